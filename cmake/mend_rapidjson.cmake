# RapidJSON 1.1.0, which package managers still have, has two faults that later ones do not: such headers are replaced, in the build's own
# folder, by a copy that says what later ones say.
# - It assigns to a const member in a function that nobody calls, which Clang from 20 on refuses.
# - A zero with an exponent beyond 22 or with more than 22 decimals goes the way of numbers whose first bit is looked for: it became any
#   number, another one on each machine ("0e100" was 4.7e80 in WebAssembly).
#
# folder: the link to the library's headers, or what it was replaced by
function(texelcast_mend_rapidjson folder)
    texelcast_mend_in_rapidjson(
        ${folder} document.h "operator=(const GenericStringRef& rhs) { s = rhs.s; length = rhs.length; }"
        "operator=(const GenericStringRef& rhs) = delete;")
    texelcast_mend_in_rapidjson(${folder} internal/strtod.h "if (int(length) + exp < -324)"
                                "if (*decimals == '0' || int(length) + exp < -324)")
endfunction()

function(texelcast_mend_in_rapidjson folder file was becomes)
    file(READ ${folder}/${file} text)
    string(REPLACE "${was}" "${becomes}" mended "${text}")
    if(mended STREQUAL text)
        return()
    endif()
    file(REAL_PATH ${folder} headers)
    if(NOT headers STREQUAL folder)
        file(REMOVE ${folder})
        file(COPY ${headers}/ DESTINATION ${folder})
    endif()
    file(WRITE ${folder}/${file} "${mended}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    texelcast_mend_rapidjson(${FOLDER})
endif()
