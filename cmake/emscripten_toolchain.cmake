# Finds Emscripten's own toolchain file, wherever emcc comes from (a Debian package, emsdk, Homebrew).
if(DEFINED ENV{EMSDK} AND EXISTS "$ENV{EMSDK}/upstream/emscripten/cmake/Modules/Platform/Emscripten.cmake")
    set(emscripten_root "$ENV{EMSDK}/upstream/emscripten")
else()
    find_program(TEXELCAST_EM_CONFIG NAMES em-config em-config.bat)
    if(TEXELCAST_EM_CONFIG)
        execute_process(COMMAND ${TEXELCAST_EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten_root
                        OUTPUT_STRIP_TRAILING_WHITESPACE)
    endif()
endif()
if(NOT EXISTS "${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
    message(FATAL_ERROR "Emscripten was not found: put emcc 3.1.6 or newer on PATH, or set EMSDK to the emsdk folder.")
endif()
include("${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
