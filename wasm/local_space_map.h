// The local space texture of the paper (its first step), held as what it is made of: every texel belongs to a
// triangle, and over a triangle position and normal are affine in the texel's column and row. The map keeps one affine
// *texel frame* a triangle and, tile by tile, the runs of texels that each frame owns; a texel's position and normal
// are evaluated where they are read.
//
// Why not two float images (the paper's form, 24 bytes a texel): frames and runs take 2 to 9 bytes a texel on real
// models, a decal's transform is applied once a triangle instead of once a texel, footprints come for free as they are
// constant within a frame, and a gutter texel is the very same thing as a covered one: its triangle's plane continued.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "memory_budget.h"
#include "mesh.h"
#include "texel_frame.h"
#include "tile_patch.h"
#include "tile_tree.h"

namespace txc {

inline constexpr std::uint32_t kTileSize = 16;  // texels along a side
inline constexpr std::uint32_t kNoTile = 0xffffffffu;

enum RunFlags : std::uint8_t {
    kRunGutter = 1,
    // The continued normal would turn away by more than 60 degrees (slivers do that): the frame's own one holds instead.
    kRunHoldNormal = 2,
};

/// Neighbouring texels of one tile row that share a frame. Tile-local coordinates.
struct TexelRun {
    std::uint32_t frame;
    std::uint8_t x;
    std::uint8_t y;
    std::uint8_t length;
    std::uint8_t flags;  // RunFlags
};

/// A tile that has texels: its runs, and bounds of their footprints' positions.
struct MapTile {
    std::uint32_t index;      // row-major among the map's tiles
    std::uint32_t first_run;  // in LocalSpaceMap::runs
    std::uint32_t run_count;
    std::uint32_t first_gutter_run;  // in LocalSpaceMap::gutter_runs
    std::uint32_t gutter_run_count;
    ModelBox box;
};

/// What identifies a map: equal keys share one map.
struct MapKey {
    std::uint32_t material = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t gutter = 0;
    // Of a window: the whole texture, and where in it the map begins. 0, and the map is the whole.
    std::uint32_t whole_width = 0;
    std::uint32_t whole_height = 0;
    std::uint32_t origin_x = 0;
    std::uint32_t origin_y = 0;
    bool operator==(const MapKey& other) const = default;

    bool is_window() const { return whole_width != 0; }
    std::uint32_t texture_width() const { return is_window() ? whole_width : width; }
    std::uint32_t texture_height() const { return is_window() ? whole_height : height; }
    std::uint32_t tile_columns() const { return (width + kTileSize - 1) / kTileSize; }
    std::uint32_t tile_rows() const { return (height + kTileSize - 1) / kTileSize; }
    std::size_t tile_count() const { return static_cast<std::size_t>(tile_columns()) * tile_rows(); }
};

enum Coverage : std::uint8_t { kEmpty = 0, kCovered = 1, kGutter = 2 };

struct LocalSpaceMap {
    explicit LocalSpaceMap(const MapKey& map_key, MemoryBudget& budget)
        : key(map_key), share(budget), patches(std::make_unique<TilePatches>(budget)) {}

    MapKey key;
    glm::vec3 origin{0.0f};  // the mesh's: where positions begin, model space
    Bounds bounds;           // of the material's triangles
    std::vector<TexelFrame> frames;
    std::vector<TexelRun> runs;          // covered texels: by tile, then frame, then row
    std::vector<TexelRun> gutter_runs;   // by tile, then row, then column
    std::vector<MapTile> tiles;          // those with texels, by index
    std::vector<std::uint32_t> tile_of;  // per tile of the grid: place in `tiles`, or kNoTile
    std::vector<std::unique_ptr<std::uint8_t[]>>
        overlap_tiles;  // per tile: claims a texel, where any texel has two or more
    TileTree tree;
    std::uint32_t covered_texels = 0;
    std::uint32_t covered_beyond = 0;  // of the texture that the map is a window of, outside of it
    std::uint32_t gutter_texels = 0;
    std::uint32_t overlapping_texels = 0;
    BudgetShare share;
    std::unique_ptr<TilePatches> patches;  // a cache: a map that is const otherwise fills it

    std::uint32_t tile_columns() const { return key.tile_columns(); }
    std::uint32_t tile_rows() const { return key.tile_rows(); }
    std::uint64_t byte_count() const;

    /// Unit normal of a run's texel, in the target's coordinates.
    glm::vec3 unit_normal(const TexelRun& run, std::int32_t x, std::int32_t y) const;

    /// Rows [row, row + row_count) into caller's arrays; empty texels are 0. See texelcast.h.
    void read_positions(std::uint32_t row, std::uint32_t row_count, float* out) const;
    void read_normals(std::uint32_t row, std::uint32_t row_count, float* out) const;
    void read_coverage(std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) const;
    void read_overlap(std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) const;

    /// Calls visit(run) for each run of a tile, the gutter's last.
    template <typename Visit>
    void for_each_run_of(const MapTile& tile, Visit&& visit) const {
        for (std::uint32_t r = 0; r < tile.run_count; ++r) visit(runs[tile.first_run + r]);
        for (std::uint32_t r = 0; r < tile.gutter_run_count; ++r) visit(gutter_runs[tile.first_gutter_run + r]);
    }

    /// Calls visit(run, tile_x, y) for each run of the rows: the tile's first column, and the row in the target.
    template <typename Visit>
    void for_each_run(std::uint32_t row, std::uint32_t row_count, Visit&& visit) const {
        const std::uint32_t columns = tile_columns();
        for (std::uint32_t tile_row = row / kTileSize; tile_row * kTileSize < row + row_count && tile_row < tile_rows();
             ++tile_row) {
            for (std::uint32_t column = 0; column < columns; ++column) {
                const std::uint32_t place = tile_of[tile_row * columns + column];
                if (place == kNoTile) continue;
                for_each_run_of(tiles[place], [&](const TexelRun& run) {
                    const std::uint32_t y = tile_row * kTileSize + run.y;
                    if (y >= row && y < row + row_count) visit(run, column * kTileSize, y);
                });
            }
        }
    }
};

}  // namespace txc
