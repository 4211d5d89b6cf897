// A session's layers: the tree that they make, and what each is told.
#include <algorithm>
#include <cstring>

#include "layer_def.h"
#include "session.h"

namespace txc {

TxcStatus Session::find_layer(TxcLayer id, Layer*& out_layer) const {
    out_layer = layers_.find(id);
    return out_layer != nullptr ? TXC_STATUS_OK : fail(TXC_STATUS_STALE_HANDLE, "there is no layer %u", id);
}

TxcStatus Session::check_image(TxcImage id) const {
    if (id == 0 || images_.find(id) != nullptr) return TXC_STATUS_OK;
    return fail(TXC_STATUS_STALE_HANDLE, "there is no image %u", id);
}

// ---- The tree ---------------------------------------------------------------------------------------------------------

std::uint32_t Session::depth_below(const Layer& layer) const {
    std::uint32_t deepest = 0;
    for (const auto* list : {&layer.content, &layer.mask}) {
        for (const TxcLayer held : *list) deepest = std::max(deepest, 1 + depth_below(*layers_.find(held)));
    }
    return deepest;
}

/// Whether a layer of `target` may be what `def` says to its parent. `id` 0: it is yet to be made.
TxcStatus Session::check_parent(TxcTarget target, TxcLayer id, const TxcLayerDef& def) const {
    if (def.parent == 0) {
        if (def.role == TXC_ROLE_CONTENT) return TXC_STATUS_OK;
        return fail(TXC_STATUS_BAD_ARGUMENT, "role is %u, but there is no parent whose mask that could be", def.role);
    }
    Layer* parent = nullptr;
    if (const TxcStatus status = find_layer(def.parent, parent); status != TXC_STATUS_OK) return status;
    if (parent->target != target)
        return fail(TXC_STATUS_BAD_ARGUMENT, "parent %u is a layer of another target", def.parent);
    if (def.role == TXC_ROLE_CONTENT && parent->def.kind != TXC_LAYER_GROUP)
        return fail(TXC_STATUS_BAD_ARGUMENT, "parent %u is not a group", def.parent);
    if (def.role == TXC_ROLE_MASK && def.kind == TXC_LAYER_GROUP)
        return fail(TXC_STATUS_BAD_ARGUMENT, "kind is %u: a group cannot be part of a mask", def.kind);
    std::uint32_t depth = 1;
    for (TxcLayer above = def.parent; above != 0; above = layers_.find(above)->def.parent) {
        if (above == id) return fail(TXC_STATUS_BAD_ARGUMENT, "parent %u is in layer %u itself", def.parent, id);
        ++depth;
    }
    if (id != 0) depth += depth_below(*layers_.find(id));
    if (depth <= TXC_MAX_DEPTH) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "parent %u lies so deep that layers would lie %u deep; %u is the most",
                def.parent, depth, TXC_MAX_DEPTH);
}

/// The list that a layer of that def stands in.
std::vector<TxcLayer>& Session::siblings(Target& target, const TxcLayerDef& def) {
    if (def.parent == 0) return target.order;
    Layer& parent = *layers_.find(def.parent);
    return def.role == TXC_ROLE_MASK ? parent.mask : parent.content;
}

void Session::remove_layers(const std::vector<TxcLayer>& ids) {
    for (const TxcLayer id : ids) {
        const Layer& layer = *layers_.find(id);
        remove_layers(layer.content);
        remove_layers(layer.mask);
        layers_.remove(id);
    }
}

/// Marks the tiles where a change of the layer may show.
void Session::mark_dirty(Target& target, const Layer& layer) {
    if (layer.is_everywhere()) {
        // Of a mask: where the layer is that it masks.
        if (layer.def.role == TXC_ROLE_MASK) {
            mark_dirty(target, *layers_.find(layer.def.parent));
        } else {
            target.mark_all_dirty();
        }
    }
    target.mark_dirty(layer.tiles);
    for (const TxcLayer held : layer.content) mark_dirty(target, *layers_.find(held));
}

bool Session::shows_by_mask(const Layer& layer) const {
    return layer.def.invert_mask != 0 || std::any_of(layer.mask.begin(), layer.mask.end(), [&](TxcLayer id) {
               const TxcLayerDef& def = layers_.find(id)->def;
               return def.visible != 0 && def.opacity > 0.0f;
           });
}

/// Notes a change of the tree itself: what is held may be what was below other layers.
void Session::note_move(Target& target, Layer& layer) {
    layer.changed = true;
    mark_dirty(target, layer);
    target.backdrops.empty();
}

// ---- Layers -----------------------------------------------------------------------------------------------------------

TxcStatus Session::create_layer(TxcTarget target_id, const TxcLayerDef& def, TxcLayer& out_layer) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(target_id, target); status != TXC_STATUS_OK) return status;
    auto made = std::make_unique<Layer>(budget_);
    Layer& layer = *made;
    layer.cast.origin = mesh_->origin;
    if (const TxcStatus status = read_layer_def(def, layer.cast); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_image(def.image); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_parent(target_id, 0, def); status != TXC_STATUS_OK) return status;
    layer.target = target_id;
    layer.def = def;
    layer.needs_projection = true;
    out_layer = layers_.add(std::move(made));
    if (out_layer == 0) return fail(TXC_STATUS_BAD_ARGUMENT, "there are too many layers");
    Layer* parent = layers_.find(def.parent);
    const bool was_masked = parent != nullptr && shows_by_mask(*parent);
    siblings(*target, def).push_back(out_layer);
    layer.changed = true;
    mark_dirty(*target, layer);
    if (def.role == TXC_ROLE_CONTENT) {
        // It lies on top of all that is held, or right on it.
        if (parent != nullptr) target->backdrops.rename(end_of(def.parent), out_layer);
    } else if (shows_by_mask(*parent) != was_masked) {
        target->backdrops.empty();
    }
    return TXC_STATUS_OK;
}

TxcStatus Session::update_layer(TxcLayer id, const TxcLayerDef& def) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    PictureCast cast;
    cast.origin = mesh_->origin;
    if (const TxcStatus status = read_layer_def(def, cast); status != TXC_STATUS_OK) return status;
    // An image that was destroyed under the layer may stay named: the layer is transparent until it gets another.
    if (def.image != layer->def.image) {
        if (const TxcStatus status = check_image(def.image); status != TXC_STATUS_OK) return status;
    }
    if (const TxcStatus status = check_parent(layer->target, id, def); status != TXC_STATUS_OK) return status;
    if (def.kind != TXC_LAYER_GROUP && !layer->content.empty())
        return fail(TXC_STATUS_BAD_ARGUMENT, "kind is %u, but layer %u is a group with layers in it", def.kind, id);
    if (std::memcmp(&layer->def, &def, sizeof def) == 0) return TXC_STATUS_OK;
    Target& target = *targets_.find(layer->target);
    // Where it was: its old tiles. Where it will be: the projection marks those.
    mark_dirty(target, *layer);
    const bool moves = def.parent != layer->def.parent || def.role != layer->def.role;
    if (moves) {
        std::erase(siblings(target, layer->def), id);
        siblings(target, def).push_back(id);
    }
    if (!same_projection(layer->def, def)) layer->needs_projection = true;
    // A group that is composited by itself has a ground of its own among the backdrops.
    const Layer* parent = def.role == TXC_ROLE_MASK ? layers_.find(def.parent) : nullptr;
    const bool was_masked = parent != nullptr && shows_by_mask(*parent);
    layer->def = def;
    if (parent != nullptr && shows_by_mask(*parent) != was_masked) target.backdrops.empty();
    layer->cast = cast;
    layer->changed = true;
    if (def.kind != TXC_LAYER_STROKE) layer->stroke.clear();
    if (def.kind != TXC_LAYER_FILL) layer->fill.clear();
    if (moves) note_move(target, *layer);
    if (layer->is_everywhere()) mark_dirty(target, *layer);
    return TXC_STATUS_OK;
}

TxcStatus Session::move_layer(TxcLayer id, std::uint32_t index) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    Target& target = *targets_.find(layer->target);
    std::vector<TxcLayer>& list = siblings(target, layer->def);
    const auto from = std::find(list.begin(), list.end(), id);
    const std::size_t to = std::min<std::size_t>(index, list.size() - 1);
    if (static_cast<std::size_t>(from - list.begin()) == to) return TXC_STATUS_OK;
    list.erase(from);
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), id);
    note_move(target, *layer);
    return TXC_STATUS_OK;
}

TxcStatus Session::destroy_layer(TxcLayer id) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    Target& target = *targets_.find(layer->target);
    note_move(target, *layer);
    std::erase(siblings(target, layer->def), id);
    remove_layers({id});
    return TXC_STATUS_OK;
}

// ---- Fills ------------------------------------------------------------------------------------------------------------

TxcStatus Session::find_fill(TxcLayer id, Layer*& out_layer) const {
    if (const TxcStatus status = find_layer(id, out_layer); status != TXC_STATUS_OK) return status;
    return out_layer->def.kind == TXC_LAYER_FILL ? TXC_STATUS_OK
                                                 : fail(TXC_STATUS_BAD_ARGUMENT, "layer %u is not a fill", id);
}

TxcStatus Session::set_gradient(TxcLayer id, const TxcGradient* gradient) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_fill(id, layer); status != TXC_STATUS_OK) return status;
    if (gradient != nullptr) {
        if (const TxcStatus status = check_gradient(*gradient); status != TXC_STATUS_OK) return status;
    }
    Target& target = *targets_.find(layer->target);
    mark_dirty(target, *layer);
    layer->fill.has_gradient = gradient != nullptr;
    if (gradient != nullptr) layer->fill.gradient = *gradient;
    change_fill(target, *layer);
    return TXC_STATUS_OK;
}

TxcStatus Session::set_triangles(TxcLayer id, const std::uint32_t* triangles, std::uint32_t count) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_fill(id, layer); status != TXC_STATUS_OK) return status;
    Target& target = *targets_.find(layer->target);
    const std::size_t known = mesh_->materials[target.def.material].triangles.size();
    for (std::uint32_t i = 0; triangles != nullptr && i < count; ++i) {
        if (triangles[i] >= known) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "triangles[%u] is %u; the material has %zu, counted from 0", i,
                        triangles[i], known);
        }
    }
    FillShape& shape = layer->fill;
    if (triangles != nullptr) {
        const TxcStatus status = shape.share.resize(std::uint64_t{count} * sizeof *triangles, "a fill's triangles");
        if (status != TXC_STATUS_OK) return status;
    }
    mark_dirty(target, *layer);
    shape.has_triangles = triangles != nullptr;
    shape.triangles = decltype(shape.triangles)();
    if (triangles != nullptr) {
        shape.triangles.assign(triangles, triangles + count);
    } else {
        shape.share.release();
    }
    change_fill(target, *layer);
    return TXC_STATUS_OK;
}

void Session::change_fill(Target& target, Layer& layer) {
    layer.needs_projection = true;
    layer.changed = true;
    if (layer.is_everywhere()) mark_dirty(target, layer);
}

// ---- Strokes ----------------------------------------------------------------------------------------------------------

TxcStatus Session::find_stroke(TxcLayer id, Layer*& out_layer) const {
    if (const TxcStatus status = find_layer(id, out_layer); status != TXC_STATUS_OK) return status;
    return out_layer->def.kind == TXC_LAYER_STROKE ? TXC_STATUS_OK
                                                   : fail(TXC_STATUS_BAD_ARGUMENT, "layer %u is not a stroke", id);
}

TxcStatus Session::add_dabs(TxcLayer id, const TxcDab* dabs, std::uint32_t count) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_stroke(id, layer); status != TXC_STATUS_OK) return status;
    return layer->stroke.add(dabs, count);
}

TxcStatus Session::clear_dabs(TxcLayer id) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_stroke(id, layer); status != TXC_STATUS_OK) return status;
    layer->stroke.clear();
    layer->needs_projection = true;
    return TXC_STATUS_OK;
}

}  // namespace txc
