# How our own sources are compiled. Results must be the same bytes on every machine (spec section 7): no contraction of
# a*b+c, no fast-math, and natively no -march, which would let the compiler choose other instructions.
function(texelcast_compile_options target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise $<$<BOOL:${TEXELCAST_WARNINGS_AS_ERRORS}>:/WX>)
        return()
    endif()
    target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off
                                             $<$<BOOL:${TEXELCAST_WARNINGS_AS_ERRORS}>:-Werror>)
    if(EMSCRIPTEN)
        target_compile_options(${target} PRIVATE -O3 -msimd128 -mbulk-memory -mnontrapping-fptoint -fno-exceptions -fno-rtti)
    elseif(TEXELCAST_SANITIZE)
        target_compile_options(${target} PRIVATE -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined
                                                 -fno-sanitize-recover=all)
        target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    else()
        target_compile_options(${target} PRIVATE -O2)
    endif()
endfunction()
