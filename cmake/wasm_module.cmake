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

# emcc strips names after it has optimised, and Binaryen forgets then how it would have written the functions most tightly: once
# more through it is 0.5 kB less to download. (Alignment hints, which no engine looks at, are 0.15 kB of that.) Where
# it is not found beside emcc the module is that much larger, and does the same.
find_program(TEXELCAST_WASM_OPT wasm-opt HINTS ${EMSCRIPTEN_ROOT_PATH}/../bin)

function(texelcast_tighten target)
    # What compile_options.cmake asks for, and what newer releases of emcc take for granted.
    set(features --enable-simd --enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int
                 --enable-mutable-globals --enable-multivalue --enable-reference-types)
    if(TEXELCAST_WASM_OPT)
        add_custom_command(
            TARGET ${target} POST_BUILD
            COMMAND ${TEXELCAST_WASM_OPT} ${features} --dealign -Oz --converge $<TARGET_FILE:${target}> -o
                    $<TARGET_FILE:${target}>
            VERBATIM)
    endif()
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
    texelcast_tighten(${target})
endfunction()

# A command with `_start`, for node:wasi.
function(texelcast_wasm_command target)
    texelcast_standalone(${target})
endfunction()
