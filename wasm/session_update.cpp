// A session's updates: what is behind is projected, then the target is composited.
#include <algorithm>
#include <map>

#include "compositor.h"
#include "layer_miniature.h"
#include "session.h"

namespace txc {

TxcStatus Session::ensure_occlusion_tree() {
    if (occlusion_ != nullptr) return TXC_STATUS_OK;
    auto tree = std::make_unique<OcclusionTree>(budget_);
    if (const TxcStatus status = tree->build(*mesh_); status != TXC_STATUS_OK) return status;
    occlusion_ = std::move(tree);
    return TXC_STATUS_OK;
}

TxcStatus Session::project_layer(Target& target, Layer& layer, TxcUpdate& update) {
    layer.changed = true;
    if (layer.def.kind == TXC_LAYER_STROKE) return project_stroke(target, layer, update);
    mark_dirty(target, layer);
    const ImagePyramid* image = layer.def.kind == TXC_LAYER_DECAL ? images_.find(layer.def.image) : nullptr;
    const bool is_shaped_fill = layer.def.kind == TXC_LAYER_FILL && !layer.is_everywhere();
    if (image == nullptr && !is_shaped_fill) {
        release_tiles(layer.tiles);
        layer.needs_projection = false;
        return TXC_STATUS_OK;
    }
    std::uint32_t texels = 0;
    if (is_shaped_fill) {
        const TxcStatus status = paint_fill(*target.map, *mesh_, layer.fill, layer.def, layer.tiles, texels);
        if (status != TXC_STATUS_OK) return status;
    } else {
        if (layer.cast.asks_for_occluders()) {
            if (const TxcStatus status = ensure_occlusion_tree(); status != TXC_STATUS_OK) return status;
        }
        const CastScene scene{*target.map, *mesh_, occlusion_.get(), budget_, occluders_};
        const TxcStatus status = cast_picture(scene, layer.cast, *image, layer.tiles, texels);
        if (status != TXC_STATUS_OK) return status;
    }
    layer.needs_projection = false;
    ++projection_count_;
    ++update.projected_layers;
    update.projected_texels += texels;
    work_left_.spend(texels);
    mark_dirty(target, layer);
    return TXC_STATUS_OK;
}

RoundTips& Session::round_tips_of(Layer& layer) {
    const float hardness = layer.def.hardness;
    std::shared_ptr<RoundTips>& tips = layer.stroke.round_tips;
    if (tips == nullptr || tips->hardness() != hardness) {
        tips.reset();
        std::erase_if(round_tips_, [](const auto& other) { return other.expired(); });
        for (const auto& other : round_tips_) {
            if (const auto known = other.lock(); known->hardness() == hardness) tips = known;
        }
        if (tips == nullptr) {
            tips = std::make_shared<RoundTips>(hardness, budget_);
            round_tips_.push_back(tips);
        }
    }
    return *tips;
}

TxcStatus Session::project_stroke(Target& target, Layer& layer, TxcUpdate& update) {
    Stroke& stroke = layer.stroke;
    if (layer.needs_projection) {
        mark_dirty(target, layer);
        release_tiles(layer.tiles);
        stroke.painted = 0;
        layer.needs_projection = false;
    }
    if (stroke.painted == stroke.dabs.size()) return TXC_STATUS_OK;
    const TxcLayerDef& def = layer.def;
    Brush brush;
    brush.is_mask = def.tip != TXC_TIP_PICTURE;
    brush.color = Float4{def.color[0], def.color[1], def.color[2], def.color[3]};
    brush.flow = def.flow;
    if (def.tip == TXC_TIP_ROUND) {
        brush.round_tips = &round_tips_of(layer);
    } else {
        stroke.round_tips.reset();
        brush.picture = images_.find(def.image);
        if (brush.picture == nullptr) {
            stroke.painted = stroke.dabs.size();
            return TXC_STATUS_OK;
        }
    }
    const bool asks_for_occluders =
        std::any_of(stroke.dabs.begin() + static_cast<std::ptrdiff_t>(stroke.painted), stroke.dabs.end(),
                    [&](const TxcDab& dab) { return layer.cast.occludes && dab.projector != TXC_PROJECTOR_UV; });
    if (asks_for_occluders) {
        if (const TxcStatus status = ensure_occlusion_tree(); status != TXC_STATUS_OK) return status;
    }
    const CastScene scene{*target.map, *mesh_, occlusion_.get(), budget_, occluders_};
    std::uint64_t texels = 0;
    target.ensure_tile_marks();
    const TxcStatus status = paint_dabs(scene, layer.cast, brush, stroke.dabs, stroke.painted, layer.tiles,
                                        target.dirty_tiles, work_left_, texels);
    if (status != TXC_STATUS_OK) {
        // Some of the dabs may be there: the next update begins anew.
        layer.needs_projection = true;
        return status;
    }
    if (layer.is_behind()) update.unfinished = 1;
    ++projection_count_;
    ++update.projected_layers;
    update.projected_texels += static_cast<std::uint32_t>(std::min<std::uint64_t>(texels, 0xffffffffu));
    return TXC_STATUS_OK;
}

TxcStatus Session::find_bleed(TxcTarget id, Target*& out_target) {
    if (const TxcStatus status = find_baked(id, out_target); status != TXC_STATUS_OK) return status;
    return txc::find_bleed(*out_target, budget_);
}

TxcStatus Session::project_layers(Target& target, const std::vector<TxcLayer>& ids, TxcUpdate& update) {
    for (const TxcLayer id : ids) {
        Layer& layer = *layers_.find(id);
        // What a hidden layer paints can wait until it is shown.
        if (layer.def.visible == 0) continue;
        if (layer.is_behind()) {
            if (!work_left_.any()) {
                update.unfinished = 1;
                return TXC_STATUS_OK;
            }
            if (const TxcStatus status = project_layer(target, layer, update); status != TXC_STATUS_OK) return status;
        }
        for (const auto* held : {&layer.mask, &layer.content}) {
            if (const TxcStatus status = project_layers(target, *held, update); status != TXC_STATUS_OK) return status;
        }
    }
    return TXC_STATUS_OK;
}

std::vector<LayerNode> Session::nodes_of(const std::vector<TxcLayer>& ids, TxcLayer split) const {
    std::vector<LayerNode> nodes;
    nodes.reserve(ids.size());
    for (const TxcLayer id : ids) {
        const Layer& layer = *layers_.find(id);
        nodes.push_back({id, &layer, nodes_of(layer.content, split), nodes_of(layer.mask, 0)});
        if (split == end_of(id) && layer.def.kind == TXC_LAYER_GROUP)
            nodes.back().content.push_back({split, &nothing_, {}, {}});
    }
    return nodes;
}

bool Session::takes_changes(const std::vector<TxcLayer>& ids) {
    bool any = false;
    for (const TxcLayer id : ids) {
        Layer& layer = *layers_.find(id);
        any = takes_changes(layer.mask) || layer.changed || any;
        layer.changed = false;
    }
    return any;
}

namespace {

/// Where each layer of a target stands, counted from the bottom, and the end of each group after what is in it.
class LayerPlaces {
public:
    void add(TxcLayer id) { places_.emplace(id, static_cast<std::int64_t>(places_.size())); }
    /// Negative for one that is not there.
    std::int64_t operator()(TxcLayer id) const {
        const auto found = places_.find(id);
        return found != places_.end() ? found->second : -1;
    }

private:
    std::map<TxcLayer, std::int64_t> places_;
};

}  // namespace

/// Tells the target's backdrops which layers changed, and forgets that they did. A mask's change is that of its layer; a
/// group's mask lies over all that is in the group, and leaves that as it was.
void Session::follow_changes(Target& target) {
    LayerPlaces places;
    TxcLayer lowest = 0;
    const auto note = [&](bool changed, TxcLayer id) {
        if (changed && lowest == 0) lowest = id;
    };
    const auto visit = [&](const auto& self, const std::vector<TxcLayer>& ids) -> void {
        for (const TxcLayer id : ids) {
            Layer& layer = *layers_.find(id);
            places.add(id);
            const bool is_group = layer.def.kind == TXC_LAYER_GROUP;
            const bool mask_changed = takes_changes(layer.mask);
            note(layer.changed || (mask_changed && !is_group), id);
            layer.changed = false;
            self(self, layer.content);
            if (!is_group) continue;
            places.add(end_of(id));
            note(mask_changed, end_of(id));
        }
    };
    visit(visit, target.order);
    target.backdrops.follow(lowest, places);
}

TxcStatus Session::update_target(TxcTarget id, std::uint32_t work_limit, TxcUpdate& out_update) {
    Target* target = nullptr;
    if (const TxcStatus status = find_baked(id, target); status != TXC_STATUS_OK) return status;
    TxcUpdate update{};
    work_left_.begin(work_limit);
    if (const TxcStatus status = project_layers(*target, target->order, update); status != TXC_STATUS_OK) return status;
    if (update.unfinished != 0 && work_limit != 0) {
        out_update = update;
        return TXC_STATUS_OK;
    }
    target->bleed.forget();
    follow_changes(*target);
    const std::vector<LayerNode> nodes = nodes_of(target->order, target->backdrops.split());
    if (const TxcStatus status = composite_target(*target, nodes, update.composited_texels); status != TXC_STATUS_OK) {
        target->backdrops.forget();
        return status;
    }
    projected_texels_ = update.projected_texels;
    composited_texels_ = update.composited_texels;
    update.rect_count = static_cast<std::uint32_t>(target->rects.size());
    update.byte_count = target->rect_bytes;
    out_update = update;
    return TXC_STATUS_OK;
}

// ---- Ahead of updates -------------------------------------------------------------------------------------------------

void Session::note_tiles(const Layer& layer, std::vector<std::uint8_t>& tiles) const {
    if (layer.def.visible == 0) return;
    if (layer.is_everywhere()) std::fill(tiles.begin(), tiles.end(), std::uint8_t{1});
    for (const std::uint32_t tile : layer.tiles.indices) tiles[tile] = 1;
    for (const TxcLayer held : layer.content) note_tiles(*layers_.find(held), tiles);
}

TxcStatus Session::draw_layer_miniature(TxcLayer id, bool of_mask, std::uint32_t side, std::uint8_t* out_rgba) const {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    Target* target = nullptr;
    if (const TxcStatus status = find_baked(layer->target, target); status != TXC_STATUS_OK) return status;
    if (side == 0 || side > TXC_MAX_MINIATURE)
        return fail(TXC_STATUS_BAD_ARGUMENT, "side is %u; it may be 1 to %u", side, TXC_MAX_MINIATURE);
    std::vector<std::uint8_t> tiles(target->tile_count());
    note_tiles(*layer, tiles);
    const MiniatureArea area = miniature_area(tiles, target->tile_columns());
    const std::vector<LayerNode> nodes = nodes_of({id}, 0);
    const auto draw = of_mask ? draw_mask_miniature : draw_miniature;
    draw(nodes.front(), area, target->tile_columns(), target->tile_rows(), side, out_rgba);
    return TXC_STATUS_OK;
}

bool Session::is_settled(const Target& target) const {
    const auto is_dirty = [](std::uint8_t mark) { return mark != 0; };
    if (target.output.levels.empty() || target.all_dirty ||
        std::any_of(target.dirty_tiles.begin(), target.dirty_tiles.end(), is_dirty))
        return false;
    const auto is_told = [&](const auto& self, const std::vector<TxcLayer>& ids) -> bool {
        return std::all_of(ids.begin(), ids.end(), [&](TxcLayer id) {
            const Layer& layer = *layers_.find(id);
            if (layer.changed) return false;
            return layer.def.visible == 0 ||
                   (!layer.is_behind() && self(self, layer.mask) && self(self, layer.content));
        });
    };
    return is_told(is_told, target.order);
}

bool Session::is_shown(const Layer& layer) const {
    if (layer.def.visible == 0 || layer.def.opacity <= 0.0f) return false;
    return layer.def.parent == 0 || is_shown(*layers_.find(layer.def.parent));
}

TxcStatus Session::prepare_layer(TxcLayer id, bool inside, std::uint32_t first_tile, std::uint32_t tile_count,
                                 std::uint32_t& out_next_tile) {
    // A pause of other work: every target has been drawn.
    occluders_.reset();
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    out_next_tile = TXC_NONE;
    // What a mask's layer changes is the layer that it masks.
    while (layer->def.role == TXC_ROLE_MASK) {
        id = layer->def.parent;
        inside = true;
        layer = layers_.find(id);
    }
    Target& target = *targets_.find(layer->target);
    if (!is_settled(target) || !is_shown(*layer)) return TXC_STATUS_OK;
    LayerPlaces places;
    const auto visit = [&](const auto& self, const std::vector<TxcLayer>& ids) -> void {
        for (const TxcLayer held : ids) {
            const Layer& other = *layers_.find(held);
            places.add(held);
            self(self, other.content);
            if (other.def.kind == TXC_LAYER_GROUP) places.add(end_of(held));
        }
    };
    visit(visit, target.order);
    const bool is_group = layer->def.kind == TXC_LAYER_GROUP;
    target.backdrops.expect(is_group && inside ? end_of(id) : id, places);
    std::vector<std::uint8_t> tiles(target.tile_count(), 0);
    note_tiles(*layer, tiles);
    const std::vector<LayerNode> nodes = nodes_of(target.order, target.backdrops.split());
    const std::uint32_t next = fill_backdrops(target, nodes, tiles, first_tile, tile_count);
    if (next < target.tile_count()) out_next_tile = next;
    return TXC_STATUS_OK;
}

}  // namespace txc
