// The mean of a bilinear picture over a small footprint, straight from the 4 x 4 pixels around its centre.
//
// A bilinear picture's mean over a footprint is the picture weighed by tent * footprint. For an axis-aligned box that
// product falls apart into one kernel along x and one along y. A small parallelogram is close to the box with its second
// moments along both axes; what its sides lean, the covariance of x and y, comes in as one more product, of the kernels'
// slopes: k(x) k(y) + covariance k'(x) k'(y). Over checkers of 2 to 8 pixels, stripes and noise, in the worst of 30
// directions and alignments, that keeps 46 dB against 8 x 8 samples where a texel is a pixel wide and 49 dB at 0.8, of
// which lattices of 3 x 3 and 2 x 2 samples keep 36 and 41, at one and a half times the work.
//
// Tried instead, at a pixel a texel on the same pictures: four samples in a rotated grid 37 dB; lattices of rank 1 with 5, 8
// and 16 points 28, 34 and 41 dB, as each has a direction in which its points fall into few lines; one sample of the picture
// blurred by three pixels a side 17 dB, as it blurs by the tent a second time.
#pragma once

#include <cstdint>

#include "bilinear.h"

namespace txc {

/// Weights of four neighbouring pixels, kWeightOne in all (of a slope: 0).
struct KernelTaps {
    std::int16_t weights[4];
};

/// Places between two pixels: on a picture that goes from black to white in one, half an 8-bit step from one to the next.
inline constexpr std::int32_t kPhaseBits = 9;
inline constexpr std::int32_t kKernelPhases = 1 << kPhaseBits;

/// A footprint's kernels on a level of a picture.
struct FootprintKernel {
    const KernelTaps* across;  // along x, by phase
    const KernelTaps* down;    // along y
    const KernelTaps* across_slope;
    const KernelTaps* down_slope;
    std::int32_t covariance;  // of x and y, in squared pixels of the level, times kWeightOne; 0 leaves the slopes out
};

/// Of x and y over the parallelogram with these sides, in squares of their unit.
inline float covariance_of(float across_x, float across_y, float down_x, float down_y) {
    return (across_x * across_y + down_x * down_y) * (1.0f / 12.0f);
}

/// Of the parallelogram with these sides, in pixels of the level.
FootprintKernel make_footprint_kernel(float across_x, float across_y, float down_x, float down_y);

#if defined(__wasm_simd128__)
namespace detail {

struct PixelPairs {
    v128_t upper[4];  // of each column, rows 0 and 1 side by side, channel by channel
    v128_t lower[4];  // rows 2 and 3
};

/// Each column's weighed sum, less kChannelBias; then the rows' likewise. `rows`, `columns`: four weights.
inline v128_t weigh(const PixelPairs& pixels, v128_t rows, v128_t columns) {
    const v128_t upper = wasm_i32x4_shuffle(rows, rows, 0, 0, 0, 0);
    const v128_t lower = wasm_i32x4_shuffle(rows, rows, 1, 1, 1, 1);
    const auto column = [&](int i) {
        return wasm_i32x4_add(wasm_i32x4_dot_i16x8(pixels.upper[i], upper),
                              wasm_i32x4_dot_i16x8(pixels.lower[i], lower));
    };
    const v128_t left = pair_columns(column(0), column(1));
    const v128_t right = pair_columns(column(2), column(3));
    return wasm_i32x4_add(wasm_i32x4_dot_i16x8(left, wasm_i32x4_shuffle(columns, columns, 0, 0, 0, 0)),
                          wasm_i32x4_dot_i16x8(right, wasm_i32x4_shuffle(columns, columns, 1, 1, 1, 1)));
}

}  // namespace detail
#endif

/// The mean around (x, y): as of place_samples, in fixed point. `pixels`, `stride`: of the level; all
/// 4 x 4 must exist. Channels less kChannelBias;
/// they may leave the range of colours by a little where the footprint leans.
inline Int4 sample_kernel(const std::int16_t* pixels, std::int32_t stride, const FootprintKernel& kernel,
                          std::int32_t x, std::int32_t y) {
    constexpr std::int32_t kHalfPhase = 1 << (kWeightBits - kPhaseBits - 1);
    const std::int32_t phase_x = ((x & (kWeightOne - 1)) + kHalfPhase) >> (kWeightBits - kPhaseBits);
    const std::int32_t phase_y = ((y & (kWeightOne - 1)) + kHalfPhase) >> (kWeightBits - kPhaseBits);
    const std::int16_t* first = pixels + std::ptrdiff_t{((y >> kWeightBits) - 1) * stride + (x >> kWeightBits) - 1} * 4;
    const std::size_t row = static_cast<std::size_t>(stride) * 4;
#if defined(__wasm_simd128__)
    detail::PixelPairs pairs;
    const auto load_rows = [&](std::size_t at, v128_t(&out)[4]) {
        for (std::size_t half = 0; half < 2; ++half) {
            const v128_t above = wasm_v128_load(first + at + half * 8);
            const v128_t below = wasm_v128_load(first + at + row + half * 8);
            out[half * 2] = wasm_i16x8_shuffle(above, below, 0, 8, 1, 9, 2, 10, 3, 11);
            out[half * 2 + 1] = wasm_i16x8_shuffle(above, below, 4, 12, 5, 13, 6, 14, 7, 15);
        }
    };
    load_rows(0, pairs.upper);
    load_rows(row * 2, pairs.lower);
    v128_t sum = detail::weigh(pairs, wasm_v128_load64_zero(kernel.down + phase_y),
                               wasm_v128_load64_zero(kernel.across + phase_x));
    if (kernel.covariance != 0) {
        const v128_t slopes = wasm_i32x4_shr(
            wasm_i32x4_mul(wasm_i32x4_load16x4(kernel.down_slope + phase_y), wasm_i32x4_splat(kernel.covariance)),
            kWeightBits);
        sum = wasm_i32x4_add(sum, detail::weigh(pairs, wasm_i16x8_narrow_i32x4(slopes, slopes),
                                                wasm_v128_load64_zero(kernel.across_slope + phase_x)));
    }
    return reinterpret_cast<Int4>(wasm_i32x4_shr(sum, kWeightBits));
#else
    const KernelTaps& across = kernel.across[phase_x];
    const KernelTaps& down = kernel.down[phase_y];
    const KernelTaps& across_slope = kernel.across_slope[phase_x];
    const KernelTaps& down_slope = kernel.down_slope[phase_y];
    Int4 out{};
    for (int c = 0; c < 4; ++c) {
        std::int32_t sum = 0;
        std::int32_t lean = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            std::int32_t column = 0;
            std::int32_t slope = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                const std::int32_t channel = first[j * row + i * 4 + static_cast<std::size_t>(c)];
                column += channel * down.weights[j];
                slope += channel * ((down_slope.weights[j] * kernel.covariance) >> kWeightBits);
            }
            sum += (column >> kWeightBits) * across.weights[i];
            lean += (slope >> kWeightBits) * across_slope.weights[i];
        }
        out[c] = (sum + lean) >> kWeightBits;
    }
    return out;
#endif
}

}  // namespace txc
