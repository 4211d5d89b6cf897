// One material's base colour texture under way: its map, its base picture, its layers, and the picture that comes out.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "backdrop_cache.h"
#include "base_picture.h"
#include "bleed.h"
#include "fill_paint.h"
#include "layer_tiles.h"
#include "local_space_map.h"
#include "map_baker.h"
#include "mip_chain.h"
#include "picture_cast.h"
#include "stroke.h"

namespace txc {

struct Layer {
    explicit Layer(MemoryBudget& budget) : tiles(budget), stroke(budget), fill(budget) {}

    TxcTarget target = 0;
    TxcLayerDef def{};
    PictureCast cast;               // of a decal, and of a stroke but for the projector; derived from def
    LayerTiles tiles;               // of all but groups and fills that go everywhere
    Stroke stroke;                  // empty for the other kinds
    FillShape fill;                 // likewise
    std::vector<TxcLayer> content;  // of a group, bottom to top
    std::vector<TxcLayer> mask;     // bottom to top
    bool needs_projection = false;  // `tiles` show an older def
    bool changed = true;            // since the newest update, in whatever way

    /// `tiles` lack something: an older def, or fewer dabs.
    bool is_behind() const { return needs_projection || stroke.painted < stroke.dabs.size(); }
    bool is_everywhere() const { return def.kind == TXC_LAYER_FILL && fill.is_everywhere(); }
};

struct Target {
    Target(const TxcTargetDef& target_def, MemoryBudget& budget)
        : def(target_def), bleed(budget), backdrops(budget), base_share(budget), output_share(budget) {}

    TxcTargetDef def;
    std::unique_ptr<MapBaker> baker;     // while the bake is under way
    std::shared_ptr<LocalSpaceMap> map;  // once it is done
    BasePicture base;
    std::vector<TxcLayer> order;            // those that are in no other, bottom to top
    MipChain output;                        // empty before the first update
    std::vector<std::uint8_t> dirty_tiles;  // per tile: must be composited again
    bool all_dirty = true;

    // The newest update's report.
    std::vector<TxcRect> rects;
    std::uint32_t rect_bytes = 0;  // of all of them

    Bleed bleed;  // for exports
    BackdropCache backdrops;

    BudgetShare base_share;
    BudgetShare output_share;  // output, tile marks

    std::uint32_t tile_columns() const { return (def.width + kTileSize - 1) / kTileSize; }
    std::uint32_t tile_rows() const { return (def.height + kTileSize - 1) / kTileSize; }
    std::uint32_t tile_count() const { return tile_columns() * tile_rows(); }

    /// Makes the list of marks, where there is none yet.
    void ensure_tile_marks() {
        if (dirty_tiles.empty()) dirty_tiles.assign(tile_count(), 0);
    }
    /// Marks tiles, so that the next update composites them.
    void mark_dirty(const LayerTiles& tiles) {
        ensure_tile_marks();
        for (const std::uint32_t tile : tiles.indices) dirty_tiles[tile] = 1;
    }
    void mark_all_dirty() { all_dirty = true; }
    /// What everything lies on changed.
    void change_base() {
        all_dirty = true;
        backdrops.forget();
    }
};

}  // namespace txc
