// Layer tiles onto the base, bottom to top, and the rectangles that changed, packed for upload.
#pragma once

#include <vector>

#include "tile_compositor.h"

namespace txc {

/// Composites the target's dirty tiles, refreshes the mip levels above them, and packs what really changed into
/// `target.rects` and `target.packed`. `layers`: the target's own list, bottom to top. `out_texels`: how many were composited.
/// Errors: OUT_OF_BUDGET, with nothing changed.
TxcStatus composite_target(Target& target, const std::vector<LayerNode>& layers, std::uint32_t& out_texels);

}  // namespace txc
