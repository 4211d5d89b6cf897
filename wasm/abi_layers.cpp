// The C ABI's functions for layers, and for what fills and strokes have besides.
#include <cstring>

#include "abi_door.h"

namespace {

using txc::fail;
using txc::in_session;
using txc::Session;

}  // namespace

extern "C" {

// ---- Layers -----------------------------------------------------------------------------------------------------------

void txc_layer_def_default(TxcLayerDef* def) {
    if (def == nullptr) return;
    *def = TxcLayerDef{};
    def->kind = TXC_LAYER_DECAL;
    def->visible = 1;
    def->opacity = 1.0f;
    def->angle_fade_start = 70.0f;
    def->angle_fade_end = 90.0f;
    def->occlusion = TXC_OCCLUSION_SELF;
    def->rotation[3] = 1.0f;
    for (float& extent : def->size) extent = 1.0f;
    def->fov_degrees = 45.0f;
    def->aspect = 1.0f;
    def->near_distance = 0.1f;
    def->far_distance = 100.0f;
    def->radius = 0.5f;
    def->height = 1.0f;
    def->arc_degrees = 180.0f;
    def->depth = 0.1f;
    for (float& coordinate : def->uv_center) coordinate = 0.5f;
    for (float& extent : def->uv_size) extent = 1.0f;
    def->color[3] = 1.0f;
    def->hardness = 1.0f;
    def->flow = 1.0f;
}

TxcStatus txc_layer_create(TxcSession session, TxcTarget target, const TxcLayerDef* def, TxcLayer* out_layer) {
    return in_session(session, def != nullptr ? out_layer : nullptr, "def or out_layer",
                      [&](Session& s) { return s.create_layer(target, *def, *out_layer); });
}

TxcStatus txc_layer_update(TxcSession session, TxcLayer layer, const TxcLayerDef* def) {
    return in_session(session, def, "def", [&](Session& s) { return s.update_layer(layer, *def); });
}

TxcStatus txc_layer_move(TxcSession session, TxcLayer layer, uint32_t index) {
    return in_session(session, [&](Session& s) { return s.move_layer(layer, index); });
}

TxcStatus txc_layer_destroy(TxcSession session, TxcLayer layer) {
    return in_session(session, [&](Session& s) { return s.destroy_layer(layer); });
}

TxcStatus txc_layer_def(TxcSession session, TxcLayer id, TxcLayerDef* out_def) {
    return in_session(session, out_def, "out_def", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_layer(id, layer); status != TXC_STATUS_OK) return status;
        *out_def = layer->def;
        return TXC_STATUS_OK;
    });
}

// ---- Fills ------------------------------------------------------------------------------------------------------------

void txc_gradient_default(TxcGradient* gradient) {
    if (gradient == nullptr) return;
    *gradient = TxcGradient{};
    gradient->to_model[1] = 1.0f;
    gradient->radius = 1.0f;
    gradient->stop_count = 2;
    gradient->offsets[1] = 1.0f;
    gradient->colors[3] = 1.0f;
    for (int c = 4; c < 8; ++c) gradient->colors[c] = 1.0f;
}

TxcStatus txc_fill_set_gradient(TxcSession session, TxcLayer layer, const TxcGradient* gradient) {
    return in_session(session, [&](Session& s) { return s.set_gradient(layer, gradient); });
}

TxcStatus txc_fill_set_triangles(TxcSession session, TxcLayer layer, const uint32_t* triangles,
                                 uint32_t triangle_count) {
    return in_session(session, [&](Session& s) { return s.set_triangles(layer, triangles, triangle_count); });
}

// ---- Strokes ----------------------------------------------------------------------------------------------------------

void txc_dab_default(TxcDab* dab) {
    if (dab == nullptr) return;
    TxcLayerDef def;
    txc_layer_def_default(&def);
    *dab = txc::dab_from_def(def);
}

TxcStatus txc_stroke_add_dabs(TxcSession session, TxcLayer layer, const TxcDab* dabs, uint32_t dab_count) {
    return in_session(session, dabs, "dabs", [&](Session& s) { return s.add_dabs(layer, dabs, dab_count); });
}

TxcStatus txc_stroke_clear(TxcSession session, TxcLayer layer) {
    return in_session(session, [&](Session& s) { return s.clear_dabs(layer); });
}

TxcStatus txc_stroke_dab_count(TxcSession session, TxcLayer id, uint32_t* out_count) {
    return in_session(session, out_count, "out_count", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_stroke(id, layer); status != TXC_STATUS_OK) return status;
        *out_count = static_cast<uint32_t>(layer->stroke.dabs.size());
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_stroke_dabs(TxcSession session, TxcLayer id, uint32_t first, uint32_t dab_count, TxcDab* out_dabs) {
    return in_session(session, out_dabs, "out_dabs", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_stroke(id, layer); status != TXC_STATUS_OK) return status;
        const std::vector<TxcDab>& dabs = layer->stroke.dabs;
        if (first > dabs.size() || dab_count > dabs.size() - first) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "dabs %u and %u more: the stroke has %zu", first, dab_count,
                        dabs.size());
        }
        for (uint32_t i = 0; i < dab_count; ++i) out_dabs[i] = dabs[first + i];
        return TXC_STATUS_OK;
    });
}

// ---- Ahead of updates -------------------------------------------------------------------------------------------------

TxcStatus txc_layer_prepare(TxcSession session, TxcLayer layer, uint32_t inside, uint32_t first_tile,
                            uint32_t tile_count, uint32_t* out_next_tile) {
    return in_session(session, out_next_tile, "out_next_tile", [&](Session& s) {
        return s.prepare_layer(layer, inside != 0, first_tile, tile_count, *out_next_tile);
    });
}

// ---- For lists of layers ----------------------------------------------------------------------------------------------

TxcStatus txc_layer_miniature(TxcSession session, TxcLayer layer, uint32_t of_mask, uint32_t side, uint8_t* out_rgba) {
    return in_session(session, out_rgba, "out_rgba",
                      [&](Session& s) { return s.draw_layer_miniature(layer, of_mask != 0, side, out_rgba); });
}

}  // extern "C"
