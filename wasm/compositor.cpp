#include "compositor.h"

#include <algorithm>
#include <cstring>

#include "blend.h"
#include "dirty_rects.h"

namespace txc {
namespace {

/// The part of a tile that lies inside the target.
struct TileArea {
    std::uint32_t x, y, width, height;
};

TileArea tile_area(const Target& target, std::uint32_t tile) {
    const std::uint32_t x = tile % target.tile_columns() * kTileSize;
    const std::uint32_t y = tile / target.tile_columns() * kTileSize;
    return {x, y, std::min(kTileSize, target.def.width - x), std::min(kTileSize, target.def.height - y)};
}

/// Copies the tile's part of the base into rows of kTileSize texels.
void copy_base(const Target& target, const TileArea& area, std::uint8_t* bytes) {
    if (target.base.rgba.empty()) {
        for (std::uint32_t t = 0; t < kTileTexels; ++t) std::memcpy(bytes + t * 4, target.base.color, 4);
        return;
    }
    for (std::uint32_t y = 0; y < area.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(area.y + y) * target.def.width + area.x;
        std::memcpy(bytes + y * kTileSize * 4, target.base.rgba.data() + first * 4, area.width * 4);
    }
}

void blend_fill(const Layer& layer, Float4* backdrops) {
    const float alpha = layer.def.color[3] * layer.def.opacity * 255.0f;
    const Float4 source = Float4{layer.def.color[0], layer.def.color[1], layer.def.color[2], 1.0f} * splat(alpha);
    const auto blend = layer.def.lock_alpha != 0 ? blend_locked : blend_normal;
    for (std::uint32_t t = 0; t < kTileTexels; ++t) blend(source, backdrops[t]);
}

template <void (*kBlend)(Float4, Float4&)>
void blend_texels(const std::uint16_t* texels, float opacity, Float4* backdrops) {
    const Float4 scale = splat(opacity * (255.0f / kFullScale));
    for (std::uint32_t t = 0; t < kTileTexels; ++t) {
        if (texels[t * 4 + 3] == 0) continue;
        kBlend(load_ushort4(texels + t * 4) * scale, backdrops[t]);
    }
}

/// Writes one tile of level 0. Returns whether any byte changed.
bool composite_tile(Target& target, const std::vector<const Layer*>& layers, std::uint32_t tile) {
    const TileArea area = tile_area(target, tile);
    std::uint8_t bytes[kTileTexels * 4] = {};  // texels beyond the target's edge stay 0 and are dropped
    copy_base(target, area, bytes);
    Float4 backdrops[kTileTexels];
    bool touched = false;
    for (const Layer* layer : layers) {
        const bool is_fill = layer->def.kind == TXC_LAYER_FILL;
        const std::uint16_t* texels = is_fill ? nullptr : layer->tiles.find(tile);
        if (!is_fill && texels == nullptr) continue;
        if (!touched) {
            for (std::uint32_t t = 0; t < kTileTexels; ++t) backdrops[t] = load_bytes4(bytes + t * 4);
            touched = true;
        }
        if (is_fill) {
            blend_fill(*layer, backdrops);
        } else if (layer->def.lock_alpha != 0) {
            blend_texels<blend_locked>(texels, layer->def.opacity, backdrops);
        } else {
            blend_texels<blend_normal>(texels, layer->def.opacity, backdrops);
        }
    }
    if (touched) {
        for (std::uint32_t t = 0; t < kTileTexels; ++t) store_rounded_bytes4(bytes + t * 4, backdrops[t]);
    }
    bool changed = false;
    for (std::uint32_t y = 0; y < area.height; ++y) {
        std::uint8_t* row = target.output.levels[0].rgba.data() +
                            (static_cast<std::size_t>(area.y + y) * target.def.width + area.x) * 4;
        const std::uint8_t* from = bytes + y * kTileSize * 4;
        if (std::memcmp(row, from, area.width * 4) == 0) continue;
        std::memcpy(row, from, area.width * 4);
        changed = true;
    }
    return changed;
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
        cover_tiles(changed_tiles, target.tile_columns(), target.tile_rows(), rect_cost, tile_rects);
        for (const TileRect& tiles : tile_rects) {
            TxcRect rect = rect_on_level(target.output.levels[level], tiles, level);
            if (rect.width == 0 || rect.height == 0) continue;
            if (level > 0) target.output.reduce(level, rect.x, rect.y, rect.x + rect.width, rect.y + rect.height);
            rect.byte_offset = offset;
            offset += rect.width * rect.height * 4;
            target.rects.push_back(rect);
        }
    }
}

void pack_rects(Target& target) {
    std::size_t total = 0;
    for (const TxcRect& rect : target.rects) total += static_cast<std::size_t>(rect.width) * rect.height * 4;
    target.packed.resize(total);
    for (const TxcRect& rect : target.rects) {
        const MipLevel& mip = target.output.levels[rect.level];
        std::uint8_t* to = target.packed.data() + rect.byte_offset;
        for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y, to += rect.width * 4) {
            std::memcpy(to, mip.rgba.data() + (static_cast<std::size_t>(y) * mip.width + rect.x) * 4, rect.width * 4);
        }
    }
}

}  // namespace

TxcStatus composite_target(Target& target, const std::vector<const Layer*>& layers, std::uint32_t& out_texels) {
    out_texels = 0;
    const bool first = target.output.levels.empty();
    if (first) {
        // The picture and, at the most, as much again for the packed copy of all of it.
        const std::uint64_t bytes = MipChain::byte_count(target.def.width, target.def.height, target.def.mip_levels);
        if (const TxcStatus status =
                target.output_share.resize(bytes * 2 + target.tile_count() * 2, "the target texture");
            status != TXC_STATUS_OK)
            return status;
        target.output.allocate(target.def.width, target.def.height, target.def.mip_levels);
        target.all_dirty = true;
    }
    std::vector<std::uint8_t> changed_tiles(target.tile_count(), 0);
    for (std::uint32_t tile = 0; tile < target.tile_count(); ++tile) {
        if (!target.all_dirty && (target.dirty_tiles.empty() || target.dirty_tiles[tile] == 0)) continue;
        const bool changed = composite_tile(target, layers, tile);
        changed_tiles[tile] = changed || first ? 1 : 0;
        const TileArea area = tile_area(target, tile);
        out_texels += area.width * area.height;
    }
    target.all_dirty = false;
    target.dirty_tiles.assign(target.tile_count(), 0);
    find_rects(target, changed_tiles);
    pack_rects(target);
    return TXC_STATUS_OK;
}

}  // namespace txc
