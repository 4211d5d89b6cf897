#include "tile_owners.h"

#include <algorithm>

namespace txc {
namespace {

constexpr std::uint32_t kTileTexels = kTileSize * kTileSize;

/// Rows of tiles that a gutter around one row of tiles can look into.
std::uint32_t band_rows(const MapKey& key) { return 2 * ((key.gutter + kTileSize - 1) / kTileSize) + 1; }

std::size_t band_tiles(const MapKey& key) { return static_cast<std::size_t>(band_rows(key)) * key.tile_columns(); }

}  // namespace

TileOwners::TileOwners(const LocalSpaceMap& map, const std::vector<std::uint32_t>& run_ends)
    : map_(map),
      run_ends_(run_ends),
      band_rows_(band_rows(map.key)),
      tile_in_(band_tiles(map.key), kNoTile),
      frames_(band_tiles(map.key) * kTileTexels) {}

std::uint64_t TileOwners::byte_count(const MapKey& key) {
    return std::uint64_t{band_tiles(key)} * (1 + kTileTexels) * sizeof(std::uint32_t);
}

std::uint32_t TileOwners::owner(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t columns = map_.tile_columns();
    const std::uint32_t tile = y / kTileSize * columns + x / kTileSize;
    const std::size_t place = static_cast<std::size_t>(y / kTileSize % band_rows_) * columns + x / kTileSize;
    std::uint32_t* frames = frames_.data() + place * kTileTexels;
    if (tile_in_[place] != tile) {
        tile_in_[place] = tile;
        for (std::uint32_t r = tile > 0 ? run_ends_[tile - 1] : 0; r < run_ends_[tile]; ++r) {
            const TexelRun& run = map_.runs[r];
            std::fill_n(frames + run.y * kTileSize + run.x, run.length, run.frame);
        }
    }
    return frames[y % kTileSize * kTileSize + x % kTileSize];
}

}  // namespace txc
