// Two doubles that move as one, as float4.h has four floats: the same operations in the same order natively and in
// WebAssembly.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace txc {

using Double2 = double __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));

inline Double2 splat2(double value) { return Double2{value, value}; }

inline Double2 absolute2(Double2 v) {
    return reinterpret_cast<Double2>(reinterpret_cast<Long2>(v) & 0x7fffffffffffffff);
}

#if defined(__wasm_simd128__)
inline Double2 lesser2(Double2 a, Double2 b) {
    return reinterpret_cast<Double2>(wasm_f64x2_pmin(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
inline Double2 greater2(Double2 a, Double2 b) {
    return reinterpret_cast<Double2>(wasm_f64x2_pmax(reinterpret_cast<v128_t>(a), reinterpret_cast<v128_t>(b)));
}
inline Double2 ceil2(Double2 v) { return reinterpret_cast<Double2>(wasm_f64x2_ceil(reinterpret_cast<v128_t>(v))); }
inline Double2 floor2(Double2 v) { return reinterpret_cast<Double2>(wasm_f64x2_floor(reinterpret_cast<v128_t>(v))); }
inline bool any_lane2(Long2 mask) { return wasm_v128_any_true(reinterpret_cast<v128_t>(mask)); }
#else
inline Double2 lesser2(Double2 a, Double2 b) { return b < a ? b : a; }
inline Double2 greater2(Double2 a, Double2 b) { return a < b ? b : a; }
inline Double2 ceil2(Double2 v) { return Double2{std::ceil(v[0]), std::ceil(v[1])}; }
inline Double2 floor2(Double2 v) { return Double2{std::floor(v[0]), std::floor(v[1])}; }
inline bool any_lane2(Long2 mask) { return (mask[0] | mask[1]) != 0; }
#endif

/// a * b - c * d where the two are nearly the same, as long as none has more than some 50 digits: then the sign holds, for no
/// product of halves is rounded.
inline Double2 product_difference2(Double2 a, Double2 b, Double2 c, Double2 d) {
    const auto upper_half = [](Double2 v) {
        return reinterpret_cast<Double2>(reinterpret_cast<Long2>(v) & ~std::int64_t{0x7ffffff});
    };
    const Double2 a1 = upper_half(a);
    const Double2 b1 = upper_half(b);
    const Double2 c1 = upper_half(c);
    const Double2 d1 = upper_half(d);
    const Double2 a2 = a - a1;
    const Double2 b2 = b - b1;
    const Double2 c2 = c - c1;
    const Double2 d2 = d - d1;
    return ((a1 * b1 - c1 * d1) + ((a1 * b2 + a2 * b1) - (c1 * d2 + c2 * d1))) + (a2 * b2 - c2 * d2);
}

struct WholePair {
    std::int32_t first;
    std::int32_t second;
};

/// Whole numbers below 2^31 either way as integers: with 1.5 * 2^52 added they stand in the doubles' lowest bits, which
/// is a third of the cost of a conversion that must look for overflow.
inline WholePair whole_to_int(Double2 whole) {
    const Double2 shifted = whole + splat2(6755399441055744.0);
    const Long2 bits = reinterpret_cast<Long2>(shifted);
    return {static_cast<std::int32_t>(bits[0]), static_cast<std::int32_t>(bits[1])};
}

}  // namespace txc
