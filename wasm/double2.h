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
inline bool any_lane2(Long2 mask) { return wasm_v128_any_true(reinterpret_cast<v128_t>(mask)); }
#else
inline Double2 lesser2(Double2 a, Double2 b) { return b < a ? b : a; }
inline Double2 greater2(Double2 a, Double2 b) { return a < b ? b : a; }
inline Double2 ceil2(Double2 v) { return Double2{std::ceil(v[0]), std::ceil(v[1])}; }
inline bool any_lane2(Long2 mask) { return (mask[0] | mask[1]) != 0; }
#endif

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
