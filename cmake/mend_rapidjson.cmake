# RapidJSON 1.1.0, which package managers still have, assigns to a const member in a function that nobody calls. Clang from 20 on
# refuses that: such a header is replaced, in the build's own folder, by a copy that says the function is not there, as later ones do.
#
# folder: the link to the library's headers, or what it was replaced by
function(texelcast_mend_rapidjson folder)
    file(READ ${folder}/document.h text)
    string(REPLACE "operator=(const GenericStringRef& rhs) { s = rhs.s; length = rhs.length; }"
                   "operator=(const GenericStringRef& rhs) = delete;" mended "${text}")
    if(mended STREQUAL text)
        return()
    endif()
    file(REAL_PATH ${folder} headers)
    if(NOT headers STREQUAL folder)
        file(REMOVE ${folder})
        file(COPY ${headers}/ DESTINATION ${folder})
    endif()
    file(WRITE ${folder}/document.h "${mended}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    texelcast_mend_rapidjson(${FOLDER})
endif()
