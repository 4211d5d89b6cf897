// What one layer paints, tile by tile: the derived thing that makes layers independent of each other. A layer below or
// above is never touched when this one moves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "local_space_map.h"
#include "memory_budget.h"
#include "raw_vector.h"

namespace txc {

inline constexpr std::uint32_t kTileTexels = kTileSize * kTileSize;

/// Premultiplied RGBA on the scale of kFullScale, 16 x 16 texels a tile; tiles that the layer leaves alone are absent.
struct LayerTiles {
    explicit LayerTiles(MemoryBudget& budget) : share(budget) {}

    std::vector<std::uint32_t> indices;  // of the target's tile grid, ascending
    RawVector<std::uint16_t> texels;     // kTileTexels * 4 a tile, in the order of `indices`
    BudgetShare share;

    /// The tile's texels, or null where the layer paints none of them.
    const std::uint16_t* find(std::uint32_t tile_index) const {
        const auto at = std::lower_bound(indices.begin(), indices.end(), tile_index);
        if (at == indices.end() || *at != tile_index) return nullptr;
        return texels.data() + static_cast<std::size_t>(at - indices.begin()) * kTileTexels * 4;
    }
};

inline void clear_tile(std::uint16_t* texels) { std::memset(texels, 0, kTileTexels * 4 * sizeof *texels); }

/// What paints a layer.
class LayerPainter {
public:
    /// Writes all of the tile, whatever stood there, or says with false that it paints nothing.
    virtual bool paint_tile(const MapTile& tile, std::uint16_t* texels) = 0;

protected:
    ~LayerPainter() = default;
};

/// Paints a layer anew on each candidate (a place in map.tiles, ascending). `out_texels`: how many texels took colour. Errors:
/// OUT_OF_BUDGET; `out` is then empty.
///
/// (A dragged layer that is painted in the midst of compositing and not stored takes 1.0 to 1.03 of the time by stretches of 16, 64 or
/// 256 tiles, 1.2 tile by tile, as two loops in turn are slower than one after the other, and would have to be projected again when
/// the next layer moves.)
TxcStatus paint_tiles(const LocalSpaceMap& map, const std::vector<std::uint32_t>& candidates, LayerPainter& painter,
                      LayerTiles& out, std::uint32_t& out_texels);

}  // namespace txc
