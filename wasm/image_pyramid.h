// A decal's picture, premultiplied, with its coarser levels: what footprint sampling reads (spec section 5).
#pragma once

#include <cstdint>
#include <vector>

#include "memory_budget.h"

namespace txc {

/// 16 bits a channel, premultiplied. Full scale is 255 * 255, so that colour times alpha of an 8-bit picture is exact.
inline constexpr float kFullScale = 65025.0f;

struct PyramidLevel {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    float scale_x = 1.0f;  // pixels of this level a pixel of the picture
    float scale_y = 1.0f;
    std::vector<std::uint16_t> rgba;

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

/// A colour on the scale of kFullScale, premultiplied.
struct PyramidColor {
    float channel[4] = {0.0f, 0.0f, 0.0f, 0.0f};
};

/// Adds the bilinear sample at (x, y), in pixels of the level with centres at halves. Beyond the border all is
/// transparent, so a picture fades out over the half pixel on either side of its edge; with `repeat` it goes on.
void add_bilinear(const PyramidLevel& level, float x, float y, bool repeat, PyramidColor& sum);

}  // namespace txc
