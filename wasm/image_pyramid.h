// A decal's picture, premultiplied, with its coarser levels: what footprint sampling reads (spec section 5).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "float4.h"
#include "memory_budget.h"

namespace txc {

/// 16 bits a channel, premultiplied. Full scale is 255 * 255, so that colour times alpha of an 8-bit picture is exact. (With
/// 15 bits, which the multiplication of signed pairs would take as they are, a drag was 1 to 5 % quicker, and faint colours
/// came out half a step further off.)
inline constexpr std::int32_t kByteStep = 255;
inline constexpr float kFullScale = 255.0f * static_cast<float>(kByteStep);
/// What a pyramid's channels are less by, since signed 16-bit factors need them around 0. (To take it off at each sample
/// made a drag 1.03 to 1.07 times as long.)
inline constexpr std::int32_t kChannelBias = 32768;

/// The largest bend (PyramidLevel::bends) of what counts as a plane: what rounding to bytes leaves of one comes to 2 at the most.
inline constexpr std::int32_t kMostBend = 2;

/// Transparent pixels around each level, so that footprints over a picture's edge are no case of their own: the picture
/// fades out over half a pixel by itself. As many as let most runs of texels that leave it pass in one piece.
inline constexpr std::int32_t kPad = 8;

struct PyramidLevel {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    float scale_x = 1.0f;  // pixels of this level a pixel of the picture
    float scale_y = 1.0f;
    std::vector<std::int16_t> rgba;  // padded; less kChannelBias
    // Per pixel, padded likewise: the largest second difference of any channel, in 8-bit steps, rounded up, in the window of
    // pixels around it (first_of). Where it is small the picture is as good as linear, and the mean over a footprint is the
    // value at its centre. (Blocks of 8 pixels would take less room, but on a picture with fine detail they spared an eighth of
    // the texels their samples, where pixels spare three quarters.)
    std::vector<std::uint8_t> peaks[2];  // windows of 2 and 4 pixels a side
    // The same in windows of 4, 8 and 16: how far from a plane the picture is, as the largest second difference at a stride of two
    // pixels, or half the largest at a stride of one. What rounding leaves of a plane does not add up over a stretch as it
    // would by the differences from pixel to pixel. Beside a kink, which tells by itself, the wider stride does not count.
    std::vector<std::uint8_t> bends[3];

    std::int32_t stride() const { return static_cast<std::int32_t>(width) + 2 * kPad; }
    std::size_t padded_count() const { return padded_count(width, height); }
    static std::size_t padded_count(std::uint32_t width, std::uint32_t height) {
        return std::size_t{width + 2 * kPad} * (height + 2 * kPad);
    }

    /// The picture's first pixel; its neighbours lie up to kPad before it.
    const std::int16_t* first_pixel() const { return pixel(0, 0); }
    /// The first pixel's place in `peaks` or `bends`. A window of 2n pixels reaches from n - 1 pixels before its own to n after it:
    /// it knows what lies less than n from any place between its own pixel's centre and those of the neighbours on the right
    /// and below.
    const std::uint8_t* first_of(const std::vector<std::uint8_t>& list) const {
        return list.data() + padded_place(0, 0);
    }

    const std::int16_t* pixel(std::uint32_t x, std::uint32_t y) const { return rgba.data() + padded_place(x, y) * 4; }
    std::int16_t* pixel(std::uint32_t x, std::uint32_t y) { return rgba.data() + padded_place(x, y) * 4; }
    /// On the scale of kFullScale.
    Int4 color_at(std::uint32_t x, std::uint32_t y) const { return load_short4(pixel(x, y)) + splat(kChannelBias); }

    /// Whether nothing is painted in these pixels, of which the padding may be some: without any second difference a picture is a
    /// plane, and a plane is 0 where it is 0 at its corners.
    bool is_clear(std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) const;

private:
    std::size_t padded_place(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y + kPad} * (width + 2 * kPad) + x + kPad;
    }
};

struct ImagePyramid {
    explicit ImagePyramid(MemoryBudget& budget) : share(budget) {}

    std::vector<PyramidLevel> levels;  // level 0 is the picture; each next half as wide and high, down to 1 x 1
    BudgetShare share;

    /// `rgba`: straight alpha, row 0 at the top. Errors: OUT_OF_BUDGET.
    TxcStatus build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba);
};

/// The bilinear sample at (x, y), in pixels of the level with centres at halves; premultiplied, on the scale of
/// kFullScale. Beyond the border all is transparent, so a picture fades out over the half pixel on either side of its
/// edge; with `repeat` it goes on.
Float4 sample_bilinear(const PyramidLevel& level, float x, float y, bool repeat);

/// The one pixel under (x, y), which lies in the picture or on its edge.
inline Float4 sample_nearest(const PyramidLevel& level, float x, float y) {
    const std::uint32_t column = std::min(static_cast<std::uint32_t>(x), level.width - 1);
    const std::uint32_t row = std::min(static_cast<std::uint32_t>(y), level.height - 1);
    return __builtin_convertvector(level.color_at(column, row), Float4);
}

}  // namespace txc
