// The quickest way through a planar decal: a whole tile in one loop, where all of its texels take the decal's full weight
// under footprints that are as good as one.
#pragma once

#include "footprint.h"
#include "tile_patch.h"

namespace txc {

/// How much finer slopes are than places. An axis is known to 1/500 of a pixel then, over half a tile. (As many bits as each tile
/// leaves room for are finer, but a shift that is not known when the loops are compiled is three to forty instructions for four
/// texels, where this is one: a drag took 1.02 to 1.05 of the time.)
inline constexpr std::int32_t kSlopeBits = 9;

/// How a decal sees a patch's whole numbers, in fixed point on a level (bilinear.h): place = base + (whole . slope >> kSlopeBits).
struct PatchView {
    Int4 xy_to_x{};  // the slopes in all lanes, two halves each, as PatchTexels has them
    Int4 z_to_x{};
    Int4 xy_to_y{};
    Int4 z_to_y{};
    std::int32_t base_x = 0;
    std::int32_t base_y = 0;
    // Places are held within these: what lies beyond is as transparent as what lies there.
    std::int32_t least_x = 0, most_x = 0, least_y = 0, most_y = 0;
    // The pixels that may lie around the texels' places.
    std::int32_t first_column = 0, last_column = 0, first_row = 0, last_row = 0;
    ChordLimits chords;
};

/// Paints texels of a patch into the tile's `texels`. Those for which one sample does not stand are left to `rough`; returns
/// what follows the last of them. May paint beside `painted`: see clear_uncovered.
/// `painted`: which, of those that there are. `may_join`: the patch is whole, as TilePatch::Continuity says.
RoughTexel* paint_patch(const TileCoverage& painted, bool may_join, const PatchTexels& places, const PatchView& view,
                        const PyramidLevel& level, const Footprint& footprint, std::uint16_t* texels,
                        RoughTexel* rough);

/// What stands for a weight of 1.
inline constexpr std::int16_t kFullWeight = 32767;

/// Multiplies a tile's texels, whatever stands there, by their weights: from 0 to kFullWeight.
void fade_texels(const std::int16_t* weights, std::uint16_t* texels);

/// Clears what the tile holds beside these texels: painted there, or from before.
void clear_uncovered(const TileCoverage& covered, std::uint16_t* texels);

}  // namespace txc
