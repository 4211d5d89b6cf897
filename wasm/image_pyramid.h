// A decal's picture, premultiplied, with its coarser levels: what footprint sampling reads (spec section 5).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "float4.h"
#include "memory_budget.h"

namespace txc {

/// 16 bits a channel, premultiplied. Full scale is 255 * 255, so that colour times alpha of an 8-bit picture is exact.
inline constexpr float kFullScale = 65025.0f;

inline constexpr std::int32_t kRoughnessReaches = 2;

struct PyramidLevel {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    float scale_x = 1.0f;  // pixels of this level a pixel of the picture
    float scale_y = 1.0f;
    std::vector<std::uint16_t> rgba;
    // Per pixel: the largest second difference of any channel, in 8-bit steps, rounded up, among the pixels where a
    // footprint can feel it whose centre lies between this pixel's centre and those of its right and lower neighbours:
    // up to 1 (first list) or 2 pixels away. Where it is small the picture is as good as linear, and the mean over the
    // footprint is the value at its centre. (Blocks of 8 pixels would take less room, but on a picture with fine detail
    // they spared an eighth of the texels their samples, where pixels spare three quarters.)
    std::vector<std::uint8_t> roughness[kRoughnessReaches];

    /// Around a place in pixels of the level, at least half a pixel from its border; `reach` is 1 or 2.
    std::int32_t roughness_at(float x, float y, std::int32_t reach) const {
        const auto column = static_cast<std::uint32_t>(static_cast<std::int32_t>(x - 0.5f));
        const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(y - 0.5f));
        return roughness[reach - 1][static_cast<std::size_t>(row) * width + column];
    }

    const std::uint16_t* pixel(std::uint32_t x, std::uint32_t y) const {
        return rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4;
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
    return load_ushort4(level.pixel(column, row));
}

}  // namespace txc
