// A texel frame as a planar decal sees it: what its texels share while the decal is painted.
#pragma once

#include <cstdint>
#include <vector>

#include "footprint.h"
#include "projector.h"

namespace txc {

/// Lanes of a frame's affine map into the decal: where its texels meet the picture (pixels of the picture, 0 at its left
/// and top edge), how deep they lie (decal space), how they face (normal . ray, before the normal is normalised).
enum Lane { kX, kY, kDepth, kFacing };

/// What is known of the triangles that may hide a frame.
enum class Hiding { kUnasked, kNone, kBlockers, kUnknown };

/// A frame as this decal sees it.
struct DecalFrame {
    std::uint32_t frame = 0xffffffffu;
    std::int32_t x0 = 0;
    std::int32_t y0 = 0;
    ProjectedFrame seen{};         // x and y in pixels of the picture
    std::uint32_t tile = kNoTile;  // that looked at it last
    bool has_footprint = false;
    Footprint footprint{};
    const PyramidLevel* level = nullptr;  // the footprint's
    std::int32_t pair_limit = -1;         // chord_limit of every second texel
    std::int32_t four_limit = -1;         // and of every fourth
    Hiding hiding = Hiding::kUnasked;
    std::vector<std::uint32_t> blockers;  // where hiding says that these are all

    Float4 at_texel(std::int32_t x, std::int32_t y) const {
        return seen.at + seen.dx * splat(static_cast<float>(x - x0)) + seen.dy * splat(static_cast<float>(y - y0));
    }
};

}  // namespace txc
