# tinygltf goes through all meshes once more, to mark what their buffer views are for, which nobody here asks. It refuses on the way a
# list of indices without a view, which glTF allows where a sparse list says them. gltf_reader.cpp checks what it reads itself: the header
# is replaced, in the build's own folder, by a copy that leaves that out, which also makes the module 0.4 kB less to download.
#
# file: the link to the library's header, or what it was replaced by
function(texelcast_mend_tinygltf file)
    file(READ ${file} text)
    set(walk "for (auto &mesh : model->meshes) {")
    string(FIND "${text}" "if (false) ${walk}" found)
    if(NOT found EQUAL -1)
        return()
    endif()
    string(REPLACE "${walk}" "if (false) ${walk}" mended "${text}")
    file(REMOVE ${file})
    file(WRITE ${file} "${mended}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    texelcast_mend_tinygltf(${FILE})
endif()
