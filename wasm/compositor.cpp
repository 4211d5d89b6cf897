#include "compositor.h"

#include <algorithm>
#include <cstring>

#include "dirty_rects.h"
#include "texel_bytes.h"
#include "tile_blend.h"

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

bool is_opaque(const TexelRows& base) {
    Byte16 all = load_byte16(base.first);
    for (std::uint32_t y = 0; y < kTileSize; ++y) {
        for (std::uint32_t x = 0; x < kTileSize * 4; x += 16) all &= load_byte16(base.first + y * base.stride + x);
    }
    return (all[3] & all[7] & all[11] & all[15]) == 255;
}

/// A visible layer while the dirty tiles go by in ascending order.
class LayerWalk {
public:
    explicit LayerWalk(const Layer& layer) : tiles_(layer.tiles) {
        const TxcLayerDef& def = layer.def;
        is_fill_ = def.kind == TXC_LAYER_FILL;
        next_ = tiles_.indices.begin();
        const float color_scale = def.opacity * (255.0f / kFullScale);
        paint_.scale = Float4{color_scale, color_scale, color_scale, def.opacity * (1.0f / kFullScale)};
        const float alpha = def.color[3] * def.opacity;
        paint_.color = Float4{def.color[0], def.color[1], def.color[2], 0.0f} * splat(alpha * 255.0f);
        paint_.color[3] = alpha;
        paint_.blend = def.blend;
        paint_.blend_space = def.blend_space;
        paint_.lock_alpha = def.lock_alpha != 0;
        paint_.is_unfaded = !is_fill_ && def.opacity == 1.0f;
    }

    /// The layer's paint on a tile, or null where there is none.
    const TilePaint* on(std::uint32_t tile) {
        if (is_fill_) return &paint_;
        if (next_ != tiles_.indices.end() && *next_ < tile)
            next_ = std::lower_bound(next_ + 1, tiles_.indices.end(), tile);
        if (next_ == tiles_.indices.end() || *next_ != tile) return nullptr;
        paint_.texels =
            tiles_.texels.data() + static_cast<std::size_t>(next_ - tiles_.indices.begin()) * kTileTexels * 4;
        return &paint_;
    }

private:
    const LayerTiles& tiles_;
    bool is_fill_;
    std::vector<std::uint32_t>::const_iterator next_;
    TilePaint paint_{};
};

/// Writes tiles of level 0.
class TileCompositor {
public:
    TileCompositor(Target& target, const std::vector<const Layer*>& layers) : target_(target) {
        for (const Layer* layer : layers) {
            if (layer->def.opacity > 0.0f) walks_.emplace_back(*layer);
        }
        for (std::uint32_t x = 0; x < kTileSize; ++x) std::memcpy(color_row_ + x * 4, target.base.color, 4);
    }

    /// Tiles come in ascending order. Returns whether any byte changed.
    bool composite(std::uint32_t tile, const TileArea& area) {
        paints_.clear();
        bool plain = true;
        for (LayerWalk& walk : walks_) {
            const TilePaint* paint = walk.on(tile);
            if (paint == nullptr) continue;
            paints_.push_back(*paint);
            plain = plain && paint->is_plain();
        }
        const TexelRows base = base_rows(area);
        const std::size_t out_stride = static_cast<std::size_t>(target_.def.width) * 4;
        std::uint8_t* out =
            target_.output.levels[0].rgba.data() + (static_cast<std::size_t>(area.y) * target_.def.width + area.x) * 4;
        if (paints_.empty()) return copy_rows(base, area, out, out_stride);
        const bool whole = area.width == kTileSize && area.height == kTileSize;
        if (plain && whole && is_opaque(base))
            return paint_opaque_tile(base, paints_.data(), paints_.size(), out, out_stride);
        std::uint8_t bytes[kTileTexels * 4] = {};  // texels beyond the target's edge are dropped
        copy_rows(base, area, bytes, kTileSize * 4);
        blend_paints(bytes);
        return copy_rows({bytes, kTileSize * 4}, area, out, out_stride);
    }

private:
    TexelRows base_rows(const TileArea& area) const {
        if (target_.base.rgba.empty()) return {color_row_, 0};
        const std::size_t first = static_cast<std::size_t>(area.y) * target_.def.width + area.x;
        return {target_.base.rgba.data() + first * 4, static_cast<std::size_t>(target_.def.width) * 4};
    }

    static bool copy_rows(const TexelRows& from, const TileArea& area, std::uint8_t* to, std::size_t to_stride) {
        bool changed = false;
        for (std::uint32_t y = 0; y < area.height; ++y) {
            const std::uint8_t* row = from.first + y * from.stride;
            std::uint8_t* to_row = to + y * to_stride;
            if (area.width == kTileSize) {  // WebAssembly's memcmp goes byte by byte
                Byte16 difference{};
                for (std::uint32_t x = 0; x < kTileSize * 4; x += 16) {
                    const Byte16 bytes = load_byte16(row + x);
                    difference |= bytes ^ load_byte16(to_row + x);
                    store_byte16(to_row + x, bytes);
                }
                changed = changed || any_byte(difference);
            } else if (std::memcmp(to_row, row, area.width * 4) != 0) {
                std::memcpy(to_row, row, area.width * 4);
                changed = true;
            }
        }
        return changed;
    }

    void blend_paints(std::uint8_t (&bytes)[kTileTexels * 4]) const {
        Float4 backdrops[kTileTexels / 4][4];
        for (std::uint32_t t = 0; t < kTileTexels / 4; ++t) unpack_texels(load_byte16(bytes + t * 16), backdrops[t]);
        for (const TilePaint& paint : paints_) blend_tile(paint, backdrops[0]);
        for (std::uint32_t t = 0; t < kTileTexels / 4; ++t) store_byte16(bytes + t * 16, pack_texels(backdrops[t]));
    }

    Target& target_;
    std::vector<LayerWalk> walks_;
    std::vector<TilePaint> paints_;  // on the tile at hand, bottom to top
    std::uint8_t color_row_[kTileSize * 4];
};

/// The texels of charts, gutters included.
CoverageBits charted_texels(const Target& target) {
    CoverageBits charts(target.def.width, target.def.height);
    target.map->for_each_run(0, target.def.height, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        charts.claim_span(tile_x + run.x, y, run.length);
    });
    return charts;
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
        const std::uint64_t charts =
            MipChain::coverage_byte_count(target.def.width, target.def.height, target.def.mip_levels);
        if (const TxcStatus status =
                target.output_share.resize(bytes * 2 + charts + target.tile_count() * 2, "the target texture");
            status != TXC_STATUS_OK)
            return status;
        target.output.allocate(target.def.width, target.def.height, target.def.mip_levels);
        if (target.def.mip_levels > 1) target.output.note_charts(charted_texels(target));
        target.all_dirty = true;
    }
    std::vector<std::uint8_t> changed_tiles(target.tile_count(), 0);
    TileCompositor compositor(target, layers);
    for (std::uint32_t tile = 0; tile < target.tile_count(); ++tile) {
        if (!target.all_dirty && (target.dirty_tiles.empty() || target.dirty_tiles[tile] == 0)) continue;
        const TileArea area = tile_area(target, tile);
        const bool changed = compositor.composite(tile, area);
        changed_tiles[tile] = changed || first ? 1 : 0;
        out_texels += area.width * area.height;
    }
    target.all_dirty = false;
    target.dirty_tiles.assign(target.tile_count(), 0);
    find_rects(target, changed_tiles);
    pack_rects(target);
    return TXC_STATUS_OK;
}

}  // namespace txc
