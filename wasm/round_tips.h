// The round tip of a brush as pictures: a white disc that is as wide as the picture, its alpha falling off from the solid
// part to the rim. In several sizes, as a texel that sees many pixels needs many samples: a dab takes a tip of at least two
// pixels a texel, and of more where it is small. (A thousand dabs of 35 texels by one tip of 256 pixels took 1.9 s
// natively, nearly all of it in samples.) The largest is as fine as the texels under a dab of 1024: with 512 pixels the rim
// of such a dab was a band of five texels.
#pragma once

#include <memory>

#include "image_pyramid.h"

namespace txc {

/// Tips of one hardness, which all strokes of that hardness share.
class RoundTips {
public:
    /// `hardness`: the share of the radius that is solid, 0 to 1.
    RoundTips(float hardness, MemoryBudget& budget) : hardness_(hardness), budget_(budget) {}
    ~RoundTips();  // once in the module, not unrolled wherever tips are let go

    float hardness() const { return hardness_; }

    /// The tip for a dab that is so many texels wide, at the finest; made where it is asked for the first time. It lives as
    /// long as these tips. Errors: OUT_OF_BUDGET.
    TxcStatus find(double texels_across, const ImagePyramid*& out_picture);

private:
    static constexpr std::size_t kSizeCount = 13;
    static constexpr std::uint32_t kSizes[kSizeCount] = {48, 64, 80, 96, 128, 160, 192, 256, 320, 384, 512, 768, 1024};

    float hardness_;
    MemoryBudget& budget_;
    std::unique_ptr<ImagePyramid> pictures_[kSizeCount];
};

}  // namespace txc
