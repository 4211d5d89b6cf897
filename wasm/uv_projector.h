// The flat stamp: a decal laid on the unfolded texture itself (spec section 3). It knows neither position nor normal, so
// tests 2 to 4 of section 4 do not apply to it.
#pragma once

#include <cstdint>

#include "projector_pose.h"
#include "texel_sight.h"

namespace txc {

struct UvProjector {
    glm::dvec2 center{0.5};  // u, v
    glm::dvec2 size{1.0};    // in u and in v, before it is turned
    double sine = 0.0;       // of the angle, clockwise as v runs down
    double cosine = 1.0;

    /// From an ABI layer's fields. BAD_ARGUMENT names the field.
    static TxcStatus from_def(const TxcLayerDef& def, UvProjector& out);

    /// Where a texel of a width x height target lies in the stamp. It is turned in u and v as if they were of one
    /// length, so that a design looks the same at every size; the texture does not wrap under it.
    PictureSight look(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) const;

    /// True where a texel of the rectangle (texels, its last column and row excluded) may be painted.
    bool may_touch(std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1, std::uint32_t width,
                   std::uint32_t height, const PictureMargin& margin) const;

private:
    /// Decal space, y up, of a step in u and v.
    glm::dvec2 turn(double u, double v) const {
        return {(u * cosine + v * sine) / size.x, (u * sine - v * cosine) / size.y};
    }
};

}  // namespace txc
