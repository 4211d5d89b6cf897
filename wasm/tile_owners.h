// Which frame owns a covered texel, for the few texels near a gutter: tiles are spread out from their runs when first
// asked for, and only a band of them is kept.
#pragma once

#include <cstdint>
#include <vector>

#include "local_space_map.h"

namespace txc {

class TileOwners {
public:
    /// `run_ends`: per tile of the grid, the place in map.runs after its last run. Both must outlive this.
    TileOwners(const LocalSpaceMap& map, const std::vector<std::uint32_t>& run_ends);

    static std::uint64_t byte_count(const MapKey& key);

    /// The frame of a covered texel, within the gutter's reach of the rows asked for last.
    std::uint32_t owner(std::uint32_t x, std::uint32_t y);

private:
    const LocalSpaceMap& map_;
    const std::vector<std::uint32_t>& run_ends_;
    std::uint32_t band_rows_;             // rows of tiles
    std::vector<std::uint32_t> tile_in_;  // per place in the band: the tile there, or kNoTile
    std::vector<std::uint32_t> frames_;   // per texel of the band
};

}  // namespace txc
