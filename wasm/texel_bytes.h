// Four RGBA texels between bytes and floats. Rounding to bytes happens here and nowhere else in the compositor, so that
// its quick way over opaque tiles and its general one agree to the last bit.
#pragma once

#include "float4.h"

namespace txc {

using Byte16 = std::uint8_t __attribute__((vector_size(16)));

using UShort8 = std::uint16_t __attribute__((vector_size(16)));

inline Byte16 load_byte16(const std::uint8_t* from) {
    Byte16 bytes{};
    std::memcpy(&bytes, from, sizeof bytes);
    return bytes;
}
inline void store_byte16(std::uint8_t* to, Byte16 bytes) { std::memcpy(to, &bytes, sizeof bytes); }

inline void unpack_texels(Byte16 bytes, Float4 (&texels)[4]) {
#if defined(__wasm_simd128__)
    const v128_t all = reinterpret_cast<v128_t>(bytes);
    const v128_t low = wasm_u16x8_extend_low_u8x16(all);
    const v128_t high = wasm_u16x8_extend_high_u8x16(all);
    texels[0] = convert_widened(wasm_u32x4_extend_low_u16x8(low));
    texels[1] = convert_widened(wasm_u32x4_extend_high_u16x8(low));
    texels[2] = convert_widened(wasm_u32x4_extend_low_u16x8(high));
    texels[3] = convert_widened(wasm_u32x4_extend_high_u16x8(high));
#else
    for (int t = 0; t < 4; ++t) {
        for (int c = 0; c < 4; ++c) texels[t][c] = static_cast<float>(bytes[t * 4 + c]);
    }
#endif
}

/// Lanes of 0 to 255, first those of `low`.
inline Byte16 narrow_to_bytes(UShort8 low, UShort8 high) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Byte16>(
        wasm_u8x16_narrow_i16x8(reinterpret_cast<v128_t>(low), reinterpret_cast<v128_t>(high)));
#else
    Byte16 bytes{};
    for (int i = 0; i < 8; ++i) {
        bytes[i] = static_cast<std::uint8_t>(low[i]);
        bytes[i + 8] = static_cast<std::uint8_t>(high[i]);
    }
    return bytes;
#endif
}

/// Rounds to nearest, halves up (and what lies 2^-16 or less below a half: the float's own rounding). Lanes lie in 0 to
/// 255, but for rounding.
inline Byte16 pack_texels(const Float4 (&texels)[4]) {
    // From 256 to 512 a float has 15 bits of fraction: the byte is what stands before them. WebAssembly's saturating
    // conversion says the same in seven instructions of the processor instead of two.
    Int4 bits[4];
    for (int t = 0; t < 4; ++t) bits[t] = reinterpret_cast<Int4>(texels[t] + splat(256.5f)) >> 15;
#if defined(__wasm_simd128__)
    const auto narrow = [](Int4 low, Int4 high) {
        return reinterpret_cast<UShort8>(
            wasm_u16x8_narrow_i32x4(reinterpret_cast<v128_t>(low), reinterpret_cast<v128_t>(high)));
    };
    return narrow_to_bytes(narrow(bits[0], bits[1]) & 255, narrow(bits[2], bits[3]) & 255);
#else
    Byte16 bytes{};
    for (int t = 0; t < 4; ++t) {
        for (int c = 0; c < 4; ++c) bytes[t * 4 + c] = static_cast<std::uint8_t>(bits[t][c] & 255);
    }
    return bytes;
#endif
}

inline bool any_byte(Byte16 bytes) {
#if defined(__wasm_simd128__)
    return wasm_v128_any_true(reinterpret_cast<v128_t>(bytes));
#else
    std::uint64_t halves[2];
    std::memcpy(halves, &bytes, sizeof bytes);
    return (halves[0] | halves[1]) != 0;
#endif
}

}  // namespace txc
