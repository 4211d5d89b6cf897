// Four floats that move as one: a colour, mostly. Compilers' own vector types (GCC and Clang), so that the native build
// and WebAssembly run the same operations in the same order and give the same bytes (spec section 7).
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace txc {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using UShort4 = std::uint16_t __attribute__((vector_size(8)));

inline Float4 splat(float value) { return Float4{value, value, value, value}; }

inline Float4 load_ushort4(const std::uint16_t* from) {
#if defined(__wasm_simd128__)
    // Clang 14 assembles the generic form lane by lane; the instruction for it exists.
    return reinterpret_cast<Float4>(wasm_f32x4_convert_i32x4(wasm_u32x4_load16x4(from)));
#else
    UShort4 values;
    std::memcpy(&values, from, sizeof values);
    return __builtin_convertvector(__builtin_convertvector(values, Int4), Float4);
#endif
}

/// Rounds to nearest (halves up); every lane must lie in 0 to 65535.
inline void store_rounded_ushort4(std::uint16_t* to, Float4 values) {
    const Int4 rounded = __builtin_convertvector(values + splat(0.5f), Int4);
#if defined(__wasm_simd128__)
    const v128_t wide = reinterpret_cast<v128_t>(rounded);
    wasm_v128_store64_lane(to, wasm_u16x8_narrow_i32x4(wide, wide), 0);
#else
    const UShort4 narrow = __builtin_convertvector(rounded, UShort4);
    std::memcpy(to, &narrow, sizeof narrow);
#endif
}

}  // namespace txc
