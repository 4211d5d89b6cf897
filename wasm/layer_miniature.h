// A small picture of what one layer paints, or of its mask, for lists of layers. For the eye: where layers of a group meet, all
// modes but erase are taken as normal.
#pragma once

#include <cstdint>
#include <vector>

#include "tile_compositor.h"

namespace txc {

/// A square of the target, in texels. It may reach beyond the target's edges.
struct MiniatureArea {
    std::int32_t x;
    std::int32_t y;
    std::int32_t side;
};

/// The smallest square around the marked tiles (one mark a tile, `columns` in a row); around all of them where none is marked.
MiniatureArea miniature_area(const std::vector<std::uint8_t>& tiles, std::uint32_t columns);

/// What the node paints in the area, without its own opacity, mode and mask. `out_rgba`: `side` x `side`, straight alpha.
/// `columns`, `rows`: the target's, in tiles.
void draw_miniature(const LayerNode& node, const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows,
                    std::uint32_t side, std::uint8_t* out_rgba);

/// The same of its mask: white where it shows the layer, black where it hides it.
void draw_mask_miniature(const LayerNode& node, const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows,
                         std::uint32_t side, std::uint8_t* out_rgba);

}  // namespace txc
