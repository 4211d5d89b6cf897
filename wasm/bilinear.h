// Bilinear samples in whole numbers, the inner loop of all projection: 16-bit channels times 14-bit weights, two pixels of
// all four channels in one instruction. Whole numbers give the same bytes on every machine by themselves, and take half
// the time of floats (four pixels to convert, three interpolations).
#pragma once

#include <cstdint>
#include <cstring>

#include "float4.h"
#include "image_pyramid.h"

namespace txc {

inline constexpr std::int32_t kWeightBits = 14;
inline constexpr std::int32_t kWeightOne = 1 << kWeightBits;
/// Channels stand on 0 to 65025; signed 16-bit factors need them around 0.
inline constexpr std::int32_t kChannelBias = 32768;

/// Where four samples lie on a level: the upper left of each one's four pixels, and the weights, (1 - w) in the low half
/// and w in the high half of each lane.
struct SamplePlaces {
    Int4 offset;
    Int4 weights_x;
    Int4 weights_y;
};

/// `x`, `y`: in pixels of the level, less 1/2, so that whole numbers are pixel centres; not negative.
inline SamplePlaces place_samples(Float4 x, Float4 y, std::int32_t level_width) {
    constexpr float kOne = static_cast<float>(kWeightOne);
    const Int4 fixed_x = __builtin_convertvector(x * splat(kOne), Int4);
    const Int4 fixed_y = __builtin_convertvector(y * splat(kOne), Int4);
    const Int4 one = {kWeightOne, kWeightOne, kWeightOne, kWeightOne};
    const Int4 width = {level_width, level_width, level_width, level_width};
    const Int4 right = fixed_x & (one - 1);
    const Int4 down = fixed_y & (one - 1);
    return {(fixed_y >> kWeightBits) * width + (fixed_x >> kWeightBits), (right << 16) + (one - right),
            (down << 16) + (one - down)};
}

/// One sample: channels around 0 (less kChannelBias). Weights as in SamplePlaces.
inline Int4 sample_biased(const std::uint16_t* pixels, std::size_t row_stride, std::int32_t weights_x,
                          std::int32_t weights_y) {
#if defined(__wasm_simd128__)
    const v128_t bias = wasm_i16x8_const_splat(static_cast<std::int16_t>(0x8000));
    const v128_t wx = wasm_i32x4_splat(weights_x);
    const v128_t wy = wasm_i32x4_splat(weights_y);
    const auto blend_row = [&](const std::uint16_t* at) {
        const v128_t two = wasm_v128_xor(wasm_v128_load(at), bias);
        // Left and right of each channel side by side, as the multiplication of pairs wants them.
        const v128_t pairs = wasm_i16x8_shuffle(two, two, 0, 4, 1, 5, 2, 6, 3, 7);
        return wasm_i32x4_shr(wasm_i32x4_dot_i16x8(pairs, wx), kWeightBits);
    };
    const v128_t rows = wasm_i16x8_narrow_i32x4(blend_row(pixels), blend_row(pixels + row_stride));
    const v128_t pairs = wasm_i16x8_shuffle(rows, rows, 0, 4, 1, 5, 2, 6, 3, 7);
    return reinterpret_cast<Int4>(wasm_i32x4_shr(wasm_i32x4_dot_i16x8(pairs, wy), kWeightBits));
#else
    const std::int32_t left = weights_x & 0xffff;
    const std::int32_t right = weights_x >> 16;
    const std::int32_t upper = weights_y & 0xffff;
    const std::int32_t lower = weights_y >> 16;
    Int4 out{};
    for (int c = 0; c < 4; ++c) {
        const std::uint16_t* below = pixels + row_stride + c;
        const std::int32_t above =
            ((pixels[c] - kChannelBias) * left + (pixels[c + 4] - kChannelBias) * right) >> kWeightBits;
        const std::int32_t under =
            ((below[0] - kChannelBias) * left + (below[4] - kChannelBias) * right) >> kWeightBits;
        out[c] = (above * upper + under * lower) >> kWeightBits;
    }
    return out;
#endif
}

/// Four lanes in memory, for loops over what they hold.
struct Lanes {
    alignas(16) std::int32_t at[4];
    explicit Lanes(Int4 v) { std::memcpy(at, &v, sizeof at); }
};

/// Adds up the first `count` of the four samples.
inline Int4 sum_samples(const PyramidLevel& level, const SamplePlaces& places, std::int32_t count) {
    const Lanes offsets(places.offset);
    const Lanes weights_x(places.weights_x);
    const Lanes weights_y(places.weights_y);
    const std::size_t stride = static_cast<std::size_t>(level.width) * 4;
    Int4 sum{};
    for (std::int32_t i = 0; i < count; ++i) {
        sum += sample_biased(level.rgba.data() + static_cast<std::size_t>(offsets.at[i]) * 4, stride, weights_x.at[i],
                             weights_y.at[i]);
    }
    return sum;
}

}  // namespace txc
