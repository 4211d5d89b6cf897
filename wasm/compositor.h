// Layer tiles onto the base, bottom to top, and the rectangles that changed, packed for upload.
#pragma once

#include <vector>

#include "tile_compositor.h"

namespace txc {

/// Composites the target's dirty tiles, refreshes the mip levels above them, and packs what really changed into
/// `target.rects` and `target.packed`. `layers`: the target's own list, bottom to top. `out_texels`: how many were composited.
/// Errors: OUT_OF_BUDGET, with nothing changed.
TxcStatus composite_target(Target& target, const std::vector<LayerNode>& layers, std::uint32_t& out_texels);

/// Holds the backdrops (backdrop_cache.h) of those of `tiles` (a mark for each of the target's) that lie from `first` on, or
/// next to one: as many tiles as `count`, and as long as there is room. All that the layers paint must be in the target's
/// picture already, which stays as it is. Returns the tile to go on with, or the number of all tiles when there is no more to do.
std::uint32_t fill_backdrops(Target& target, const std::vector<LayerNode>& layers,
                             const std::vector<std::uint8_t>& tiles, std::uint32_t first, std::uint32_t count);

}  // namespace txc
