#include "tile_compositor.h"

#include <algorithm>
#include <cstring>

#include "image_pyramid.h"
#include "texel_bytes.h"

namespace txc {
namespace {

// Paints below a layer from which on it is quicker to read a tile's backdrops than to make them again.
constexpr std::size_t kPaintsWorthHolding = 3;
constexpr std::size_t kNoLevel = ~std::size_t{0};

bool is_opaque(const TexelRows& base) {
    Byte16 all = load_byte16(base.first);
    for (std::uint32_t y = 0; y < kTileSize; ++y) {
        for (std::uint32_t x = 0; x < kTileSize * 4; x += 16) all &= load_byte16(base.first + y * base.stride + x);
    }
    return (all[3] & all[7] & all[11] & all[15]) == 255;
}

bool copy_rows(const TexelRows& from, const TileArea& area, std::uint8_t* to, std::size_t to_stride) {
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

void copy_texels(const Float4* from, Float4* to) { std::memcpy(to, from, kTileTexels * sizeof(Float4)); }

}  // namespace

bool LayerNode::has_mask() const {
    return layer->def.invert_mask != 0 ||
           std::any_of(mask.begin(), mask.end(), [](const LayerNode& node) { return node.is_drawn(); });
}

bool LayerNode::is_open() const {
    return is_passed_through() && layer->def.opacity == 1.0f && layer->def.lock_alpha == 0 && !has_mask();
}

TileCompositor::Walk::Walk(const LayerNode& drawn_node)
    : node(&drawn_node),
      content(drawn(drawn_node.content)),
      mask(drawn(drawn_node.mask)),
      next(drawn_node.layer->tiles.indices.begin()),
      is_open(drawn_node.is_open()) {
    const TxcLayerDef& def = node->layer->def;
    mode = {def.blend, def.blend_space, def.lock_alpha != 0};
    const float color_scale = def.opacity * (255.0f / kFullScale);
    paint.scale = Float4{color_scale, color_scale, color_scale, def.opacity * (1.0f / kFullScale)};
    const float alpha = def.color[3] * def.opacity;
    paint.color = Float4{def.color[0], def.color[1], def.color[2], 0.0f} * splat(alpha * 255.0f);
    paint.color[3] = alpha;
    paint.is_unfaded = !node->layer->is_everywhere() && def.opacity == 1.0f;
}

/// Looks for the layer's own paint on a tile.
bool TileCompositor::Walk::find(std::uint32_t tile) {
    const Layer& layer = *node->layer;
    if (layer.is_everywhere()) return true;
    const std::vector<std::uint32_t>& indices = layer.tiles.indices;
    if (next != indices.end() && *next < tile) next = std::lower_bound(next + 1, indices.end(), tile);
    if (next == indices.end() || *next != tile) return false;
    paint.texels = layer.tiles.texels.data() + static_cast<std::size_t>(next - indices.begin()) * kTileTexels * 4;
    return true;
}

/// Looks for what its mask has on a tile; false where that shows nothing.
bool TileCompositor::Walk::find_mask(std::uint32_t tile) {
    bool any = false;
    for (Walk& part : mask) {
        part.is_active = part.find(tile) && part.find_mask(tile);
        any = any || part.is_active;
    }
    return any || node->layer->def.invert_mask == 0;
}

std::vector<TileCompositor::Walk> TileCompositor::drawn(const std::vector<LayerNode>& layers) {
    std::vector<Walk> walks;
    for (const LayerNode& node : layers) {
        if (node.is_drawn()) walks.emplace_back(node);
    }
    return walks;
}

TileCompositor::TileCompositor(Target& target, const std::vector<LayerNode>& layers)
    : target_(target), walks_(drawn(layers)) {
    for (std::uint32_t x = 0; x < kTileSize; ++x) std::memcpy(color_row_ + x * 4, target.base.color, 4);
    const TxcLayer split = target.backdrops.split();
    if (split == 0 || !target.backdrops.is_worth_filling() || !find_path(walks_, split)) path_.clear();
}

/// Finds the layer's place from list to list.
bool TileCompositor::find_path(const std::vector<Walk>& walks, TxcLayer split) {
    path_.push_back(0);
    for (const Walk& walk : walks) {
        if (walk.node->id == split) return true;
        const bool is_new_ground = walk.is_group() && !walk.is_open;
        if (is_new_ground) ++state_count_;
        if (find_path(walk.content, split)) return true;
        if (is_new_ground) --state_count_;
        ++path_.back();
    }
    path_.pop_back();
    return false;
}

bool TileCompositor::composite(std::uint32_t tile, const TileArea& area) {
    const bool is_held = !path_.empty() && target_.backdrops.find(tile) != nullptr;
    paints_below_ = 0;
    is_below_ = !path_.empty();
    find_paints(walks_, tile, path_.empty() ? kNoLevel : 0, is_held);
    const TexelRows base = base_rows(area);
    const std::size_t out_stride = static_cast<std::size_t>(target_.def.width) * 4;
    std::uint8_t* out =
        target_.output.levels[0].rgba.data() + (static_cast<std::size_t>(area.y) * target_.def.width + area.x) * 4;
    if (!is_held) {
        paints_.clear();
        is_plain_ = true;
        list_plain(walks_);
        if (is_plain_ && paints_.empty()) return copy_rows(base, area, out, out_stride);
        const bool is_whole = area.width == kTileSize && area.height == kTileSize;
        const bool is_to_be_held = !path_.empty() && paints_below_ >= kPaintsWorthHolding;
        if (is_plain_ && is_whole && !is_to_be_held && is_opaque(base))
            return paint_opaque_tile(base, paints_.data(), paints_.size(), out, out_stride);
    }
    std::uint8_t bytes[kTileTexels * 4] = {};  // texels beyond the target's edge are dropped
    copy_rows(base, area, bytes, kTileSize * 4);
    blend(tile, bytes);
    return copy_rows({bytes, kTileSize * 4}, area, out, out_stride);
}

TexelRows TileCompositor::base_rows(const TileArea& area) const {
    if (target_.base.rgba.empty()) return {color_row_, 0};
    const std::size_t first = static_cast<std::size_t>(area.y) * target_.def.width + area.x;
    return {target_.base.rgba.data() + first * 4, static_cast<std::size_t>(target_.def.width) * 4};
}

/// Finds out which layers paint on the tile. `level`: of the path, where `walks` lie on it. `from_split`: what lies below
/// the layer that the path leads to is held, and need not be known.
void TileCompositor::find_paints(std::vector<Walk>& walks, std::uint32_t tile, std::size_t level, bool from_split) {
    const bool is_on_path = level < path_.size();
    const std::size_t split = is_on_path ? path_[level] : walks.size();
    for (std::size_t i = is_on_path && from_split ? split : 0; i < walks.size(); ++i) {
        Walk& walk = walks[i];
        const bool leads_on = is_on_path && i == split && level + 1 < path_.size();
        if (is_on_path && i == split && !leads_on) is_below_ = false;
        if (walk.is_group()) {
            find_paints(walk.content, tile, leads_on ? level + 1 : kNoLevel, from_split);
            const auto is_active = [](const Walk& held) { return held.is_active; };
            // What is held of a group on the path may be all that it has here.
            walk.is_active =
                (leads_on && from_split) || std::any_of(walk.content.begin(), walk.content.end(), is_active);
        } else {
            walk.is_active = walk.find(tile);
            if (walk.is_active && is_below_) ++paints_below_;
        }
        if (walk.is_active && !walk.find_mask(tile)) walk.is_active = false;
    }
}

/// Lists the paints on the tile, as long as none of them asks for more than being laid on the one before.
void TileCompositor::list_plain(std::vector<Walk>& walks) {
    for (Walk& walk : walks) {
        if (!walk.is_active || !is_plain_) continue;
        if (walk.is_open) {
            list_plain(walk.content);
        } else if (walk.is_group() || walk.node->has_mask() || !walk.mode.is_plain()) {
            is_plain_ = false;
        } else {
            paints_.push_back(walk.paint);
        }
    }
}

void TileCompositor::blend(std::uint32_t tile, std::uint8_t* bytes) {
    Float4 backdrops[kTileTexels / 4][4];
    States states{nullptr, false};
    if (!path_.empty()) {
        // Read, where it is known, and written where it is not.
        states.next = target_.backdrops.find(tile);
        states.are_known = states.next != nullptr;
        if (!states.are_known && paints_below_ >= kPaintsWorthHolding)
            states.next = target_.backdrops.make(tile, target_.tile_count(), state_count_);
    }
    if (states.are_known) {
        copy_texels(states.next, backdrops[0]);
    } else {
        for (std::uint32_t t = 0; t < kTileTexels / 4; ++t) unpack_texels(load_byte16(bytes + t * 16), backdrops[t]);
    }
    const bool is_cached = states.next != nullptr;
    lay(walks_, {backdrops[0], false}, is_cached ? 0 : kNoLevel, is_cached ? &states : nullptr);
    for (std::uint32_t t = 0; t < kTileTexels / 4; ++t) store_byte16(bytes + t * 16, pack_texels(backdrops[t]));
}

/// Lays layers on their ground, bottom to top; what lies below the path's end is in `states`, or goes there.
void TileCompositor::lay(std::vector<Walk>& walks, const Ground& ground, std::size_t level, States* states) {
    const bool is_on_path = states != nullptr && level < path_.size();
    const std::size_t split = is_on_path ? path_[level] : walks.size();
    for (std::size_t i = is_on_path && states->are_known ? split : 0; i < walks.size(); ++i) {
        if (!is_on_path || i != split) {
            if (walks[i].is_active) lay_one(walks[i], ground, kNoLevel, nullptr);
            continue;
        }
        const bool leads_on = level + 1 < path_.size();
        if (!states->are_known && (!leads_on || !walks[i].is_open)) copy_texels(ground.texels, states->next);
        if (leads_on) {
            lay_one(walks[i], ground, level + 1, states);
        } else if (walks[i].is_active) {
            lay_one(walks[i], ground, kNoLevel, nullptr);
        }
    }
}

void TileCompositor::lay_one(Walk& walk, const Ground& ground, std::size_t level, States* states) {
    if (walk.is_open) {
        lay(walk.content, ground, level, states);
    } else if (walk.is_group()) {
        lay_group(walk, ground, level, states);
    } else {
        Float4 sources[kTileTexels];
        load_sources(walk.paint, sources);
        lay_sources(walk, ground, sources);
    }
}

void TileCompositor::lay_group(Walk& walk, const Ground& ground, std::size_t level, States* states) {
    Float4 texels[kTileTexels];
    if (states != nullptr) states->next += kTileTexels;
    const bool is_known = states != nullptr && states->are_known;
    if (walk.node->is_passed_through()) {
        copy_texels(ground.texels, texels);  // as they were before
        if (is_known) copy_texels(states->next, ground.texels);
        lay(walk.content, ground, level, states);
        float shares[kTileTexels];
        mask_shares(walk, shares);
        for (float& share : shares) share *= walk.node->layer->def.opacity;
        interpolate_tile(walk.mode, ground.is_isolated, texels, shares, ground.texels);
        return;
    }
    if (is_known) {
        copy_texels(states->next, texels);
    } else {
        std::fill(texels, texels + kTileTexels, splat(0.0f));
    }
    lay(walk.content, {texels, true}, level, states);
    const float opacity = walk.node->layer->def.opacity;
    if (opacity < 1.0f) {
        for (Float4& texel : texels) texel = texel * splat(opacity);
    }
    lay_sources(walk, ground, texels);
}

void TileCompositor::lay_sources(const Walk& walk, const Ground& ground, Float4* sources) {
    if (walk.node->has_mask()) {
        float shares[kTileTexels];
        mask_shares(walk, shares);
        mask_sources(shares, sources);
    }
    if (ground.is_isolated) {
        blend_isolated(walk.mode, sources, ground.texels);
    } else {
        blend_tile(walk.mode, sources, ground.texels);
    }
}

/// How far a layer's mask shows it: 1 without a mask.
void TileCompositor::mask_shares(const Walk& walk, float* shares) {
    std::fill(shares, shares + kTileTexels, 1.0f);
    for (const Walk& part : walk.mask) {
        if (!part.is_active || part.mode.lock_alpha) continue;
        float own[kTileTexels];
        const bool is_masked = part.node->has_mask();
        if (is_masked) mask_shares(part, own);
        const bool erases = part.mode.blend == TXC_BLEND_ERASE;
        for (std::uint32_t t = 0; t < kTileTexels; ++t) {
            float alpha = part.paint.texels == nullptr
                              ? part.paint.color[3]
                              : static_cast<float>(part.paint.texels[t * 4 + 3]) * part.paint.scale[3];
            if (is_masked) alpha *= own[t];
            if (erases) {
                shares[t] *= 1.0f - alpha;
            } else {
                shares[t] = alpha < 1.0f ? shares[t] + (1.0f - shares[t]) * alpha : 1.0f;
            }
        }
    }
    if (walk.node->layer->def.invert_mask == 0) return;
    for (std::uint32_t t = 0; t < kTileTexels; ++t) shares[t] = 1.0f - shares[t];
}

}  // namespace txc
