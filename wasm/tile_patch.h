// A tile's texels without their triangles: positions as a structure of arrays, and bounds of what else a planar decal asks.
// A tile whose texels all look alike to a decal is painted from here in one loop, however many triangles it holds.
//
// Patches are derived from the map's frames and runs when a decal first comes near, and kept while the session has plenty of
// memory; where it has not they are made anew each time, to the same values.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "float4.h"
#include "memory_budget.h"

namespace txc {

struct LocalSpaceMap;
struct MapTile;

/// Which texels of a tile.
struct TileCoverage {
    std::uint16_t rows[16] = {};  // the first column in the lowest bit
    bool is_full = false;         // all of them

    /// Adds texels of a row: `bits`, of which the lowest is the one in column `x`.
    void add(std::uint32_t x, std::uint32_t y, std::uint32_t bits) {
        rows[y] = static_cast<std::uint16_t>(rows[y] | bits << x);
    }
    bool is_empty() const {
        std::uint32_t any = 0;
        for (const std::uint16_t row : rows) any |= row;
        return any == 0;
    }
    /// The columns that have their texels in all four rows from `row` on.
    std::uint32_t columns_of_four(std::uint32_t row) const {
        return rows[row] & rows[row + 1] & rows[row + 2] & rows[row + 3];
    }
};

/// What is known of a tile as a whole; covered and gutter texels alike. Vectors in the first three lanes.
struct TilePatch {
    enum class State : std::uint8_t {
        kUnmade,
        kBounds,  // its texels differ too much, or are too few, for one loop: the bounds alone are of use
        kUniform
    };

    /// Whether neighbours are a texel apart on the surface too: no two charts meet in the tile that lie apart on it. Only then may
    /// colours be interpolated between texels.
    enum class Continuity : std::uint8_t { kUnasked, kBroken, kWhole };

    State state = State::kUnmade;
    Continuity continuity = Continuity::kUnasked;  // told by TilePatches::texels
    TileCoverage there;                            // the texels that there are
    float longest_normal = 0.0f;
    Float4 normal{};  // of the normals, which are not of unit length
    Float4 normal_spread{};
    Float4 middle{};  // of the positions, model space
    Float4 step{};    // of the positions' whole numbers
    Float4 across{};  // middle and half width of the change from a texel to the next of its row, over the frames
    Float4 across_spread{};
    Float4 down{};  // of its column
    Float4 down_spread{};
};

/// Positions in whole numbers from -32767 to 32767: (position - middle) / step. 0 where there is no texel.
struct PatchTexels {
    std::int32_t xy[256];  // x in the low half, y in the high one
    std::int16_t z[256];

    Float4 at(std::size_t i) const {
        const auto half = [](std::int32_t low) { return static_cast<float>(static_cast<std::int16_t>(low)); };
        return Float4{half(xy[i]), half(xy[i] >> 16), half(z[i]), 0.0f};
    }
};

/// The patches of a map's tiles.
class TilePatches {
public:
    explicit TilePatches(MemoryBudget& budget) : share_(budget) {}

    /// Of the tile at `place` of map.tiles.
    const TilePatch& find(const LocalSpaceMap& map, std::uint32_t place);
    /// Its texels, where it is uniform. Of the tile found last.
    const PatchTexels& texels(const LocalSpaceMap& map, std::uint32_t place);

    std::uint64_t byte_count() const { return share_.bytes(); }

private:
    bool has_room(std::uint64_t bytes);

    std::vector<TilePatch> patches_;  // none, or one a tile
    std::vector<std::unique_ptr<PatchTexels>> texels_;
    BudgetShare share_;
    TilePatch unkept_;
    std::unique_ptr<PatchTexels> unkept_texels_;
};

}  // namespace txc
