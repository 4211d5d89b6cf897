// Four floats that move as one: a colour, mostly. Compilers' own vector types (GCC and Clang), so that the native build
// and WebAssembly run the same operations in the same order and give the same bytes (spec section 7).
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace txc {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using UShort4 = std::uint16_t __attribute__((vector_size(8)));
using Short4 = std::int16_t __attribute__((vector_size(8)));

inline Float4 splat(float value) { return Float4{value, value, value, value}; }
inline Int4 splat(std::int32_t value) { return Int4{value, value, value, value}; }

/// x, y and z, with 0 in the last lane.
inline Float4 load_vec3(const glm::vec3& v) { return Float4{v.x, v.y, v.z, 0.0f}; }

#if defined(__wasm_simd128__)
// Clang 14 makes comparisons and selections of the conditional operator, where there is one instruction.
inline Float4 lesser(Float4 a, Float4 b) {
    return reinterpret_cast<Float4>(wasm_f32x4_pmin(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
inline Float4 greater(Float4 a, Float4 b) {
    return reinterpret_cast<Float4>(wasm_f32x4_pmax(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
inline Int4 lesser(Int4 a, Int4 b) {
    return reinterpret_cast<Int4>(wasm_i32x4_min(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
inline Int4 greater(Int4 a, Int4 b) {
    return reinterpret_cast<Int4>(wasm_i32x4_max(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
#else
inline Float4 lesser(Float4 a, Float4 b) { return b < a ? b : a; }
inline Float4 greater(Float4 a, Float4 b) { return a < b ? b : a; }
inline Int4 lesser(Int4 a, Int4 b) { return b < a ? b : a; }
inline Int4 greater(Int4 a, Int4 b) { return a < b ? b : a; }
#endif
#if defined(__wasm_simd128__)
inline bool any_lane(Int4 mask) { return wasm_v128_any_true(reinterpret_cast<v128_t>(mask)); }
#else
inline bool any_lane(Int4 mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }
#endif

/// A bit for each lane of a comparison's mask, the first in the lowest.
inline std::uint32_t lane_bits(Int4 mask) {
#if defined(__wasm_simd128__)
    return wasm_i32x4_bitmask(reinterpret_cast<v128_t>(mask));
#else
    return static_cast<std::uint32_t>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

inline Float4 absolute(Float4 a) { return greater(a, -a); }

/// Lanes of `yes` where the mask (of a comparison) is set, of `no` elsewhere.
inline Float4 select(Int4 mask, Float4 yes, Float4 no) {
    return reinterpret_cast<Float4>((mask & reinterpret_cast<Int4>(yes)) | (~mask & reinterpret_cast<Int4>(no)));
}

/// Lanes 1, 2 and 3 to 0, 1 and 2.
inline Float4 move_down(Float4 a) {
#if defined(__wasm_simd128__)
    const v128_t lanes = reinterpret_cast<v128_t>(a);
    return reinterpret_cast<Float4>(wasm_i32x4_shuffle(lanes, lanes, 1, 2, 3, 0));
#else
    return Float4{a[1], a[2], a[3], a[0]};
#endif
}

/// The first three columns of the matrix with these rows.
inline void transpose3(Float4 a, Float4 b, Float4 c, Float4 d, Float4& first, Float4& second, Float4& third) {
#if defined(__wasm_simd128__)
    // Only such shuffles as engines turn into one instruction: what the compiler makes of lanes costs V8 seven each.
    const auto v = [](Float4 row) { return reinterpret_cast<v128_t>(row); };
    const v128_t ab = wasm_i32x4_shuffle(v(a), v(b), 0, 4, 1, 5);
    const v128_t cd = wasm_i32x4_shuffle(v(c), v(d), 0, 4, 1, 5);
    const v128_t ab_high = wasm_i32x4_shuffle(v(a), v(b), 2, 6, 3, 7);
    const v128_t cd_high = wasm_i32x4_shuffle(v(c), v(d), 2, 6, 3, 7);
    first = reinterpret_cast<Float4>(wasm_i64x2_shuffle(ab, cd, 0, 2));
    second = reinterpret_cast<Float4>(wasm_i64x2_shuffle(ab, cd, 1, 3));
    third = reinterpret_cast<Float4>(wasm_i64x2_shuffle(ab_high, cd_high, 0, 2));
#else
    first = Float4{a[0], b[0], c[0], d[0]};
    second = Float4{a[1], b[1], c[1], d[1]};
    third = Float4{a[2], b[2], c[2], d[2]};
#endif
}

inline Float4 square_root(Float4 a) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Float4>(wasm_f32x4_sqrt(reinterpret_cast<v128_t>(a)));
#else
    return Float4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

#if defined(__wasm_simd128__)
// Clang 14 turns "widen, then convert" into four conversions lane by lane (which cost a drag a third of its time) unless
// something stands between the two. From 16 on it makes one of them, and 19 ends with an error of its own where something does.
inline Float4 convert_widened(v128_t integers) {
#if __clang_major__ < 16
    asm("" : "+r"(integers));
#endif
    return reinterpret_cast<Float4>(wasm_f32x4_convert_i32x4(integers));
}
#endif

inline Float4 load_ushort4(const std::uint16_t* from) {
#if defined(__wasm_simd128__)
    return convert_widened(wasm_u32x4_load16x4(from));
#else
    UShort4 values;
    std::memcpy(&values, from, sizeof values);
    return __builtin_convertvector(__builtin_convertvector(values, Int4), Float4);
#endif
}

inline Float4 load_bytes4(const std::uint8_t* from) {
#if defined(__wasm_simd128__)
    return convert_widened(wasm_u32x4_extend_low_u16x8(wasm_u16x8_extend_low_u8x16(wasm_v128_load32_zero(from))));
#else
    return Float4{static_cast<float>(from[0]), static_cast<float>(from[1]), static_cast<float>(from[2]),
                  static_cast<float>(from[3])};
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

inline Int4 load_int4(const std::int32_t* from) {
    Int4 values;
    std::memcpy(&values, from, sizeof values);
    return values;
}

inline Int4 load_short4(const std::int16_t* from) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Int4>(wasm_i32x4_load16x4(from));
#else
    Short4 values;
    std::memcpy(&values, from, sizeof values);
    return __builtin_convertvector(values, Int4);
#endif
}

/// Subtracts lanes that fit.
inline void subtract_short4(std::int16_t* from, Int4 values) {
#if defined(__wasm_simd128__)
    const v128_t wide = reinterpret_cast<v128_t>(values);
    wasm_v128_store64_lane(from, wasm_i16x8_sub(wasm_v128_load64_zero(from), wasm_i16x8_narrow_i32x4(wide, wide)), 0);
#else
    for (int c = 0; c < 4; ++c) from[c] = static_cast<std::int16_t>(from[c] - values[c]);
#endif
}

/// The two signed halves of each lane multiplied, and the products added up.
inline Int4 dot_halves(Int4 a, Int4 b) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Int4>(wasm_i32x4_dot_i16x8(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
#else
    return (a << 16 >> 16) * (b << 16 >> 16) + (a >> 16) * (b >> 16);
#endif
}

/// To nearest; halves to even.
inline Int4 round_to_int(Float4 values) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Int4>(wasm_i32x4_trunc_sat_f32x4(wasm_f32x4_nearest(reinterpret_cast<v128_t>(values))));
#else
    return __builtin_convertvector(Float4{std::nearbyint(values[0]), std::nearbyint(values[1]),
                                          std::nearbyint(values[2]), std::nearbyint(values[3])},
                                   Int4);
#endif
}

/// Downwards.
inline Int4 floor_to_int(Float4 values) {
#if defined(__wasm_simd128__)
    return reinterpret_cast<Int4>(wasm_i32x4_trunc_sat_f32x4(wasm_f32x4_floor(reinterpret_cast<v128_t>(values))));
#else
    return __builtin_convertvector(
        Float4{std::floor(values[0]), std::floor(values[1]), std::floor(values[2]), std::floor(values[3])}, Int4);
#endif
}

/// Stores lanes of 0 to 65535; what lies outside is clamped.
inline void store_ushort4(std::uint16_t* to, Int4 values) {
#if defined(__wasm_simd128__)
    const v128_t wide = reinterpret_cast<v128_t>(values);
    wasm_v128_store64_lane(to, wasm_u16x8_narrow_i32x4(wide, wide), 0);
#else
    for (int c = 0; c < 4; ++c)
        to[c] = static_cast<std::uint16_t>(values[c] < 0 ? 0 : values[c] > 65535 ? 65535 : values[c]);
#endif
}

/// Two times four of them.
inline void store_ushort8(std::uint16_t* to, Int4 low, Int4 high) {
#if defined(__wasm_simd128__)
    wasm_v128_store(to, wasm_u16x8_narrow_i32x4(reinterpret_cast<v128_t>(low), reinterpret_cast<v128_t>(high)));
#else
    store_ushort4(to, low);
    store_ushort4(to + 4, high);
#endif
}

/// The same as store_rounded_ushort4 to bytes; what lies above 255 becomes 255. No lane may be negative.
inline void store_rounded_bytes4(std::uint8_t* to, Float4 values) {
    const Int4 rounded = __builtin_convertvector(values + splat(0.5f), Int4);
#if defined(__wasm_simd128__)
    const v128_t wide = reinterpret_cast<v128_t>(rounded);
    const v128_t narrow = wasm_i16x8_narrow_i32x4(wide, wide);
    wasm_v128_store32_lane(to, wasm_u8x16_narrow_i16x8(narrow, narrow), 0);
#else
    for (int c = 0; c < 4; ++c) to[c] = static_cast<std::uint8_t>(rounded[c] < 255 ? rounded[c] : 255);
#endif
}

}  // namespace txc
