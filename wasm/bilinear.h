// Bilinear samples in whole numbers, the inner loop of all projection: 16-bit channels times 14-bit weights, two pixels of
// all four channels in one instruction. Whole numbers give the same bytes on every machine by themselves, and take half
// the time of floats (four pixels to convert, three interpolations).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "float4.h"
#include "image_pyramid.h"

namespace txc {

inline constexpr std::int32_t kWeightBits = 14;
inline constexpr std::int32_t kWeightOne = 1 << kWeightBits;

inline const Int4 kBias = {kChannelBias, kChannelBias, kChannelBias, kChannelBias};

/// Places in fixed point: pixels times kWeightOne.
inline std::int32_t to_fixed(float pixels) {
    return static_cast<std::int32_t>(pixels * static_cast<float>(kWeightOne));
}

/// Where four samples lie on a level: the upper left of each one's four pixels, counted from the picture's first, and the
/// weights, (1 - w) in the low half and w in the high half of each lane.
struct SamplePlaces {
    Int4 offset;
    Int4 weights_x;
    Int4 weights_y;
};

/// `x`, `y`: in pixels of the level, less 1/2, so that whole numbers are pixel centres, in fixed point.
inline SamplePlaces place_samples(Int4 x, Int4 y, std::int32_t stride) {
    const Int4 one = {kWeightOne, kWeightOne, kWeightOne, kWeightOne};
    const Int4 right = x & (one - 1);
    const Int4 down = y & (one - 1);
    return {(y >> kWeightBits) * splat(stride) + (x >> kWeightBits), (right << 16) + (one - right),
            (down << 16) + (one - down)};
}

/// The same of places in floats.
inline SamplePlaces place_samples(Float4 x, Float4 y, std::int32_t stride) {
    constexpr float kOne = static_cast<float>(kWeightOne);
    return place_samples(round_to_int(x * splat(kOne)), round_to_int(y * splat(kOne)), stride);
}

/// One lane in all four.
template <int kLane>
Int4 broadcast(Int4 v) {
#if defined(__wasm_simd128__)
    const v128_t lanes = reinterpret_cast<v128_t>(v);
    return reinterpret_cast<Int4>(wasm_i32x4_shuffle(lanes, lanes, kLane, kLane, kLane, kLane));
#else
    return Int4{v[kLane], v[kLane], v[kLane], v[kLane]};
#endif
}

#if defined(__wasm_simd128__)
namespace detail {
/// Two columns' weighed sums, channel by channel side by side without their weights' scale, as the multiplication of pairs wants
/// them. (With masks in place of the shuffle it is five or six instructions instead of three.)
inline v128_t pair_columns(v128_t left, v128_t right) {
    return wasm_i16x8_shuffle(wasm_u32x4_shr(left, kWeightBits), wasm_i32x4_shl(right, 16 - kWeightBits), 0, 9, 2, 11,
                              4, 13, 6, 15);
}
}  // namespace detail
#endif

/// One sample: channels around 0 (less kChannelBias). Each lane of the weights holds the same pair, as in SamplePlaces.
inline Int4 sample_biased(const std::int16_t* pixels, std::size_t row_stride, Int4 weights_x, Int4 weights_y) {
#if defined(__wasm_simd128__)
    // Only such shuffles as engines turn into one instruction: a mask of bytes costs V8 five.
    const v128_t upper = wasm_v128_load(pixels);
    const v128_t lower = wasm_v128_load(pixels + row_stride);
    const auto blend_column = [&](v128_t pairs) {
        return wasm_i32x4_dot_i16x8(pairs, reinterpret_cast<v128_t>(weights_y));
    };
    const v128_t left = blend_column(wasm_i16x8_shuffle(upper, lower, 0, 8, 1, 9, 2, 10, 3, 11));
    const v128_t right = blend_column(wasm_i16x8_shuffle(upper, lower, 4, 12, 5, 13, 6, 14, 7, 15));
    return reinterpret_cast<Int4>(wasm_i32x4_shr(
        wasm_i32x4_dot_i16x8(detail::pair_columns(left, right), reinterpret_cast<v128_t>(weights_x)), kWeightBits));
#else
    const std::int32_t left = weights_x[0] & 0xffff;
    const std::int32_t right = weights_x[0] >> 16;
    const std::int32_t upper = weights_y[0] & 0xffff;
    const std::int32_t lower = weights_y[0] >> 16;
    Int4 out{};
    for (int c = 0; c < 4; ++c) {
        const std::int16_t* below = pixels + row_stride + c;
        const std::int32_t at_left = (pixels[c] * upper + below[0] * lower) >> kWeightBits;
        const std::int32_t at_right = (pixels[c + 4] * upper + below[4] * lower) >> kWeightBits;
        out[c] = (at_left * left + at_right * right) >> kWeightBits;
    }
    return out;
#endif
}

/// The sample at one of four places.
template <int kLane>
Int4 sample_lane(const std::int16_t* pixels, std::int32_t stride, const SamplePlaces& places) {
    return sample_biased(pixels + std::ptrdiff_t{places.offset[kLane]} * 4, std::size_t(stride) * 4,
                         broadcast<kLane>(places.weights_x), broadcast<kLane>(places.weights_y));
}

/// Adds up the first `count` of the four samples.
inline Int4 sum_samples(const PyramidLevel& level, const SamplePlaces& places, std::int32_t count) {
    const std::int16_t* pixels = level.first_pixel();
    const std::int32_t stride = level.stride();
    Int4 sum = sample_lane<0>(pixels, stride, places);
    if (count > 1) sum += sample_lane<1>(pixels, stride, places);
    if (count > 2) sum += sample_lane<2>(pixels, stride, places);
    if (count > 3) sum += sample_lane<3>(pixels, stride, places);
    return sum;
}

}  // namespace txc
