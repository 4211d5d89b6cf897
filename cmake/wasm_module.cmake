# A standalone WebAssembly module: a plain .wasm with a C ABI and WASI-like imports, without Emscripten's JavaScript, so
# that web/core can load it anywhere (that glue needs `new Function`, and 3.1.6's fails on Node 18 and later).

# Renamed in 3.1.25.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
    set(TEXELCAST_STACK_SETTING TOTAL_STACK)
else()
    set(TEXELCAST_STACK_SETTING STACK_SIZE)
endif()

function(texelcast_standalone target)
    set_target_properties(${target} PROPERTIES SUFFIX .wasm)
    # emmalloc is 3 kB less to download than dlmalloc. -Oz is about the linked module's own clean-up: its functions were
    # made quick or small when they were compiled. Link-time optimisation makes it larger.
    target_link_options(${target} PRIVATE -Oz -sMALLOC=emmalloc -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=16777216
                                          -sMAXIMUM_MEMORY=4GB -s${TEXELCAST_STACK_SETTING}=1048576)
endfunction()

# A library: `_initialize` and every function that the header declares with TXC_API.
function(texelcast_wasm_module target)
    texelcast_standalone(${target})
    set(header ${CMAKE_SOURCE_DIR}/wasm/texelcast.h)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    file(READ ${header} text)
    string(REGEX MATCHALL "TXC_API [^;{]*(txc_[a-z0-9_]+)\\(" declarations "${text}")
    set(exports "")
    foreach(declaration IN LISTS declarations)
        string(REGEX MATCH "(txc_[a-z0-9_]+)\\($" ignored "${declaration}")
        list(APPEND exports _${CMAKE_MATCH_1})
    endforeach()
    list(JOIN exports "," exports)
    target_link_options(${target} PRIVATE --no-entry "-sEXPORTED_FUNCTIONS=${exports}")
endfunction()

# A command with `_start`, for node:wasi.
function(texelcast_wasm_command target)
    texelcast_standalone(${target})
endfunction()
