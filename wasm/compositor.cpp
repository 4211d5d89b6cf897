#include "compositor.h"

#include <algorithm>

#include "dirty_rects.h"

namespace txc {
namespace {

TileArea tile_area(const Target& target, std::uint32_t tile) {
    const std::uint32_t x = tile % target.tile_columns() * kTileSize;
    const std::uint32_t y = tile / target.tile_columns() * kTileSize;
    return {x, y, std::min(kTileSize, target.def.width - x), std::min(kTileSize, target.def.height - y)};
}

/// The texels of charts, gutters included.
CoverageBits charted_texels(const Target& target) {
    CoverageBits charts(target.def.width, target.def.height);
    target.map->for_each_run(0, target.def.height, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        charts.claim_span(tile_x + run.x, y, run.length);
    });
    return charts;
}

/// Whether the tile or one beside it is marked: a drag's next step reaches a little further than the step before.
bool is_near(const Target& target, const std::vector<std::uint8_t>& tiles, std::uint32_t tile) {
    const std::uint32_t columns = target.tile_columns();
    const std::uint32_t x = tile % columns;
    const std::uint32_t y = tile / columns;
    for (std::uint32_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, target.tile_rows() - 1); ++v) {
        for (std::uint32_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, columns - 1); ++u) {
            if (tiles[v * columns + u] != 0) return true;
        }
    }
    return false;
}

/// A level's rectangle that depends on the tiles, outward to whole texels; empty where an odd last column dropped out.
TxcRect rect_on_level(const MipLevel& mip, const TileRect& tiles, std::uint32_t level) {
    const std::uint32_t round_up = (1u << level) - 1;
    TxcRect rect{};
    rect.x = tiles.x0 * kTileSize >> level;
    rect.y = tiles.y0 * kTileSize >> level;
    const std::uint32_t x1 = std::min(mip.width, (tiles.x1 * kTileSize + round_up) >> level);
    const std::uint32_t y1 = std::min(mip.height, (tiles.y1 * kTileSize + round_up) >> level);
    rect.width = x1 > rect.x ? x1 - rect.x : 0;
    rect.height = y1 > rect.y ? y1 - rect.y : 0;
    rect.level = level;
    return rect;
}

void find_rects(Target& target, const std::vector<std::uint8_t>& changed_tiles) {
    target.rects.clear();
    std::uint32_t offset = 0;
    std::vector<TileRect> tile_rects;
    for (std::uint32_t level = 0; level < target.output.levels.size(); ++level) {
        // 24,000 texels of this level, in tiles of level 0 (see dirty_rects.h). From the fifth level on a tile is less
        // than a texel, so that rectangles could meet in one: a single one remains.
        const std::uint64_t rect_cost = level <= 4 ? std::uint64_t{94} << (2 * level) : ~std::uint64_t{0} >> 1;
        cover_tiles(changed_tiles, target.tile_columns(), rect_cost, tile_rects);
        for (const TileRect& tiles : tile_rects) {
            TxcRect rect = rect_on_level(target.output.levels[level], tiles, level);
            if (rect.width == 0 || rect.height == 0) continue;
            if (level > 0) target.output.reduce(level, rect.x, rect.y, rect.x + rect.width, rect.y + rect.height);
            rect.byte_offset = offset;
            offset += rect.width * rect.height * 4;
            target.rects.push_back(rect);
        }
    }
    target.rect_bytes = offset;
}

}  // namespace

TxcStatus composite_target(Target& target, const std::vector<LayerNode>& layers, std::uint32_t& out_texels) {
    out_texels = 0;
    const bool first = target.output.levels.empty();
    if (first) {
        const std::uint64_t bytes = MipChain::byte_count(target.def.width, target.def.height, target.def.mip_levels);
        const std::uint64_t charts =
            MipChain::coverage_byte_count(target.def.width, target.def.height, target.def.mip_levels);
        if (const TxcStatus status =
                target.output_share.resize(bytes + charts + target.tile_count() * 2, "the target texture");
            status != TXC_STATUS_OK)
            return status;
        target.output.allocate(target.def.width, target.def.height, target.def.mip_levels);
        if (target.def.mip_levels > 1) target.output.note_charts(charted_texels(target));
        target.all_dirty = true;
    }
    // From here on a mark says that the tile changed.
    std::vector<std::uint8_t>& marks = target.dirty_tiles;
    if (target.all_dirty || marks.empty()) marks.assign(target.tile_count(), target.all_dirty ? 1 : 0);
    TileCompositor compositor(target, layers);
    // From the first on, though the last ones were painted last and may still be near: backwards takes 1.05 to 1.17 times as
    // long, since memory comes ahead of its use only forwards.
    for (std::size_t at = next_mark(marks, 0); at < marks.size(); at = next_mark(marks, at + 1)) {
        const auto tile = static_cast<std::uint32_t>(at);
        const TileArea area = tile_area(target, tile);
        const bool changed = compositor.composite(tile, area);
        marks[tile] = changed || first ? 1 : 0;
        out_texels += area.width * area.height;
    }
    target.all_dirty = false;
    find_rects(target, marks);
    marks.assign(target.tile_count(), 0);
    return TXC_STATUS_OK;
}

std::uint32_t fill_backdrops(Target& target, const std::vector<LayerNode>& layers,
                             const std::vector<std::uint8_t>& tiles, std::uint32_t first, std::uint32_t count) {
    TileCompositor compositor(target, layers);
    for (std::uint32_t tile = first; tile < target.tile_count(); ++tile) {
        if (target.backdrops.find(tile) != nullptr || !is_near(target, tiles, tile)) continue;
        if (!target.backdrops.has_room(1)) break;
        if (count == 0) return tile;
        --count;
        // On its way to the very bytes that are there.
        compositor.composite(tile, tile_area(target, tile));
    }
    return target.tile_count();
}

}  // namespace txc
