// The round tip of a brush as a picture: a white disc that is as wide as the picture, its alpha falling off from the solid
// part to the rim.
#pragma once

#include "image_pyramid.h"

namespace txc {

/// Pixels along a side. Brushes up to this many texels wide have an edge as sharp as the texture can show; wider ones
/// soften it over one pixel of the tip. (512 would hold 4 MiB a hardness and take four times as long to make.)
inline constexpr std::uint32_t kRoundTipSize = 256;

/// A tip that all strokes of one hardness share.
struct RoundTip {
    explicit RoundTip(MemoryBudget& budget) : picture(budget) {}

    float hardness = 1.0f;
    ImagePyramid picture;

    /// `of_hardness`: the share of the radius that is solid, 0 to 1. Errors: OUT_OF_BUDGET.
    TxcStatus make(float of_hardness);
};

}  // namespace txc
