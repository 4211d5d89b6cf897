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
        # Loops as they are written: what is worth four lanes says so (float4.h, short8.h). Unrolled and vectorised beyond
        # that the module is a twelfth larger to download, and no quicker.
        target_compile_options(${target} PRIVATE -O2 -fno-unroll-loops -fno-vectorize -fno-slp-vectorize -msimd128
                                                 -mbulk-memory -msign-ext -mnontrapping-fptoint -fno-exceptions -fno-rtti)
    elseif(TEXELCAST_SANITIZE)
        target_compile_options(${target} PRIVATE -O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined
                                                 -fno-sanitize-recover=all)
        target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    else()
        target_compile_options(${target} PRIVATE -O2)
    endif()
endfunction()
