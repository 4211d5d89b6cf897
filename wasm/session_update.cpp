// A session's updates: what is behind is projected, then the target is composited.
#include <algorithm>
#include <map>

#include "compositor.h"
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
        const CastScene scene{*target.map, *mesh_, occlusion_.get(), budget_};
        const TxcStatus status = cast_picture(scene, layer.cast, *image, layer.tiles, texels);
        if (status != TXC_STATUS_OK) return status;
    }
    layer.needs_projection = false;
    ++projection_count_;
    ++update.projected_layers;
    update.projected_texels += texels;
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
    const CastScene scene{*target.map, *mesh_, occlusion_.get(), budget_};
    std::uint64_t texels = 0;
    target.ensure_tile_marks();
    const TxcStatus status =
        paint_dabs(scene, layer.cast, brush, stroke.dabs, stroke.painted, layer.tiles, target.dirty_tiles, texels);
    if (status != TXC_STATUS_OK) {
        // Some of the dabs may be there: the next update begins anew.
        layer.needs_projection = true;
        return status;
    }
    stroke.painted = stroke.dabs.size();
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
            if (const TxcStatus status = project_layer(target, layer, update); status != TXC_STATUS_OK) return status;
        }
        for (const auto* held : {&layer.mask, &layer.content}) {
            if (const TxcStatus status = project_layers(target, *held, update); status != TXC_STATUS_OK) return status;
        }
    }
    return TXC_STATUS_OK;
}

std::vector<LayerNode> Session::nodes_of(const std::vector<TxcLayer>& ids) const {
    std::vector<LayerNode> nodes;
    nodes.reserve(ids.size());
    for (const TxcLayer id : ids) {
        const Layer& layer = *layers_.find(id);
        nodes.push_back({id, &layer, nodes_of(layer.content), nodes_of(layer.mask)});
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

/// Tells the target's backdrops which layers changed, and forgets that they did. A mask's change is that of its layer.
void Session::follow_changes(Target& target) {
    std::map<TxcLayer, std::int64_t> places;
    TxcLayer lowest = 0;
    const auto visit = [&](const auto& self, const std::vector<TxcLayer>& ids) -> void {
        for (const TxcLayer id : ids) {
            Layer& layer = *layers_.find(id);
            places.emplace(id, static_cast<std::int64_t>(places.size()));
            const bool changed = takes_changes(layer.mask) || layer.changed;
            layer.changed = false;
            if (changed && lowest == 0) lowest = id;
            self(self, layer.content);
        }
    };
    visit(visit, target.order);
    target.backdrops.follow(lowest, [&](TxcLayer id) {
        const auto found = places.find(id);
        return found != places.end() ? found->second : std::int64_t{-1};
    });
}

TxcStatus Session::update_target(TxcTarget id, TxcUpdate& out_update) {
    Target* target = nullptr;
    if (const TxcStatus status = find_baked(id, target); status != TXC_STATUS_OK) return status;
    TxcUpdate update{};
    if (const TxcStatus status = project_layers(*target, target->order, update); status != TXC_STATUS_OK) return status;
    target->bleed.forget();
    follow_changes(*target);
    const std::vector<LayerNode> nodes = nodes_of(target->order);
    if (const TxcStatus status = composite_target(*target, nodes, update.composited_texels); status != TXC_STATUS_OK) {
        target->backdrops.forget();
        return status;
    }
    projected_texels_ = update.projected_texels;
    composited_texels_ = update.composited_texels;
    update.rect_count = static_cast<std::uint32_t>(target->rects.size());
    update.byte_count = static_cast<std::uint32_t>(target->packed.size());
    out_update = update;
    return TXC_STATUS_OK;
}

}  // namespace txc
