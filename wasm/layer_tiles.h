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
#include "texel_bytes.h"

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

/// How many texels of a tile have taken colour.
inline std::uint32_t count_painted(const std::uint16_t* texels) {
    UShort8 clear{};  // minus one for each that has not
    for (std::uint32_t i = 0; i < kTileTexels * 4; i += 8) {
        UShort8 two;
        std::memcpy(&two, texels + i, sizeof two);
        clear += reinterpret_cast<UShort8>(two == 0);
    }
    return kTileTexels - (static_cast<std::uint16_t>(-clear[3]) + std::uint32_t{static_cast<std::uint16_t>(-clear[7])});
}

inline void clear_tile(std::uint16_t* texels) { std::memset(texels, 0, kTileTexels * 4 * sizeof *texels); }

/// Paints a layer anew: `painter.paint_tile(tile, texels)` for each candidate (a place in map.tiles, ascending), which
/// writes all of the tile, whatever stood there, or says with false that it paints nothing. `out_texels`: how many texels took
/// colour. Errors: OUT_OF_BUDGET; `out` is then empty.
///
/// (A dragged layer that is painted in the midst of compositing and not stored takes 1.0 to 1.03 of the time by stretches of 16, 64 or
/// 256 tiles, 1.2 tile by tile, as two loops in turn are slower than one after the other, and would have to be projected again when
/// the next layer moves.)
template <typename Painter>
TxcStatus paint_tiles(const LocalSpaceMap& map, const std::vector<std::uint32_t>& candidates, Painter&& painter,
                      LayerTiles& out, std::uint32_t& out_texels) {
    out.indices.clear();
    out_texels = 0;
    constexpr std::size_t kTileBytes = kTileTexels * 4 * sizeof(std::uint16_t) + sizeof(std::uint32_t);
    // Dragged layers keep their arrays from step to step; one that shrank a lot gives them back.
    if (out.texels.capacity() > candidates.size() * kTileTexels * 4 * 4) {
        out.texels.clear();
        out.texels.shrink_to_fit();
    }
    const std::size_t tiles = std::max(candidates.size(), out.texels.capacity() / (kTileTexels * 4));
    if (const TxcStatus status = out.share.resize(tiles * kTileBytes, "projecting a layer"); status != TXC_STATUS_OK) {
        out.texels.clear();
        return status;
    }
    // What an earlier step left is not cleared: every tile is written anew.
    out.texels.resize(candidates.size() * kTileTexels * 4);
    std::uint16_t* texels = out.texels.data();
    for (const std::uint32_t place : candidates) {
        const std::uint32_t painted = painter.paint_tile(map.tiles[place], texels) ? count_painted(texels) : 0;
        if (painted == 0) continue;
        texels += kTileTexels * 4;
        out.indices.push_back(map.tiles[place].index);
        out_texels += painted;
    }
    out.texels.resize(out.indices.size() * kTileTexels * 4);
    return TXC_STATUS_OK;
}

}  // namespace txc
