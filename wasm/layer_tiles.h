// What one layer paints, tile by tile: the derived thing that makes layers independent of each other. A layer below or
// above is never touched when this one moves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "local_space_map.h"
#include "memory_budget.h"

namespace txc {

inline constexpr std::uint32_t kTileTexels = kTileSize * kTileSize;

/// Premultiplied RGBA on the scale of kFullScale, 16 x 16 texels a tile; tiles that the layer leaves alone are absent.
struct LayerTiles {
    explicit LayerTiles(MemoryBudget& budget) : share(budget) {}

    std::vector<std::uint32_t> indices;  // of the target's tile grid, ascending
    std::vector<std::uint16_t> texels;   // kTileTexels * 4 a tile, in the order of `indices`
    BudgetShare share;

    /// The tile's texels, or null where the layer paints none of them.
    const std::uint16_t* find(std::uint32_t tile_index) const {
        const auto at = std::lower_bound(indices.begin(), indices.end(), tile_index);
        if (at == indices.end() || *at != tile_index) return nullptr;
        return texels.data() + static_cast<std::size_t>(at - indices.begin()) * kTileTexels * 4;
    }
};

}  // namespace txc
