// Two texels that move as one, in 16 bits a channel around 0 (less kChannelBias). Compilers' own vector types, as in float4.h.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "float4.h"

namespace txc {

using Short8 = std::int16_t __attribute__((vector_size(16)));
using UShort8 = std::uint16_t __attribute__((vector_size(16)));

/// Lanes of the first texel, then of the second. They must fit.
inline Short8 narrow(Int4 first, Int4 second) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Short8>(
        wasm_i16x8_narrow_i32x4(reinterpret_cast<v128_t>(first), reinterpret_cast<v128_t>(second)));
#else
    Short8 both{};
    for (int c = 0; c < 4; ++c) {
        both[c] = static_cast<std::int16_t>(first[c]);
        both[c + 4] = static_cast<std::int16_t>(second[c]);
    }
    return both;
#endif
}

/// Two of four texels: 0 and 1 are those of `a`, 2 and 3 those of `b`.
template <int kFirst, int kSecond>
Short8 pick(Short8 a, Short8 b) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Short8>(
        wasm_i64x2_shuffle(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b), kFirst, kSecond));
#else
    Short8 from[2] = {a, b};
    Short8 both{};
    const auto* texels = reinterpret_cast<const char*>(from);
    std::memcpy(&both, texels + kFirst * 8, 8);
    std::memcpy(reinterpret_cast<char*>(&both) + 8, texels + kSecond * 8, 8);
    return both;
#endif
}

/// The part `share` / 2^15 of each lane, to the nearest; `share` is above 0.
inline Short8 part_of(Short8 values, std::int16_t share) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Short8>(wasm_i16x8_q15mulr_sat(reinterpret_cast<v128_t>(values), wasm_i16x8_splat(share)));
#else
    for (int c = 0; c < 8; ++c) values[c] = static_cast<std::int16_t>((values[c] * share + 0x4000) >> 15);
    return values;
#endif
}

/// The same with a share for each lane, from 0 on.
inline Short8 part_of(Short8 values, Short8 shares) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Short8>(
        wasm_i16x8_q15mulr_sat(reinterpret_cast<v128_t>(values), reinterpret_cast<v128_t>(shares)));
#else
    for (int c = 0; c < 8; ++c) values[c] = static_cast<std::int16_t>((values[c] * shares[c] + 0x4000) >> 15);
    return values;
#endif
}

/// Sums that stop at the ends of the range.
inline Short8 add_clamped(Short8 a, Short8 b) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Short8>(wasm_i16x8_add_sat(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
#else
    for (int c = 0; c < 8; ++c) {
        const int sum = a[c] + b[c];
        a[c] = static_cast<std::int16_t>(sum < -32768 ? -32768 : sum > 32767 ? 32767 : sum);
    }
    return a;
#endif
}

/// a - b. Sets lanes of `overflow` where that does not fit.
inline Short8 subtract(Short8 a, Short8 b, Short8& overflow) {
    // By unsigned lanes: what goes round is looked for, and of signed ones C++ leaves it open.
    const auto difference = reinterpret_cast<Short8>(reinterpret_cast<UShort8>(a) - reinterpret_cast<UShort8>(b));
#if defined(__wasm_simd128__)
    const v128_t clamped = wasm_i16x8_sub_sat(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b));
    overflow |= difference ^ reinterpret_cast<Short8>(clamped);
#else
    for (int c = 0; c < 8; ++c) overflow[c] |= static_cast<std::int16_t>(a[c] - b[c] != difference[c] ? -1 : 0);
#endif
    return difference;
}

inline bool any_lane(Short8 values) { return any_lane(reinterpret_cast<Int4>(values)); }

/// Both as the layer tiles have them.
inline void store_texels(std::uint16_t* to, Short8 values) {
    values ^= std::numeric_limits<std::int16_t>::min();
    std::memcpy(to, &values, sizeof values);
}

inline Short8 load_texels(const std::uint16_t* from) {
    Short8 values;
    std::memcpy(&values, from, sizeof values);
    return values ^ std::numeric_limits<std::int16_t>::min();
}

}  // namespace txc
