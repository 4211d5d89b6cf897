// The quick way through a planar decal: runs of one frame whose texels all lie well inside the padded picture and take its
// full weight.
#pragma once

#include "decal_frame.h"
#include "local_space_map.h"

namespace txc {

/// Paints runs of `d` that lie in the tile with its first texel at (tile_x, tile_y) into the tile's `texels`. Those for
/// which one sample does not stand are left to `rough`; returns what follows the last of them.
///
/// Four texels at a time are asked and taken together, whether one sample stands for all of them or not: asked texel by
/// texel, a branch that no processor foresees came with each. Where the picture is smooth enough they take not four
/// samples but two or one, and the colours between are interpolated.
///
/// What bounds it are instructions: with all samples read from one small corner of the picture a drag took as long.
RoughTexel* paint_whole_runs(const TexelRun* run, const TexelRun* end, const DecalFrame& d, std::int32_t tile_x,
                             std::int32_t tile_y, std::uint16_t* texels, RoughTexel* rough);

}  // namespace txc
