// Strokes as tests ask for them: a brush, and dabs that look down at the plane z = 0.
#pragma once

#include <vector>

#include "test_session.h"

namespace support {

/// A black round brush that paints through.
inline TxcLayerDef stroke_def(double hardness = 1.0, double flow = 1.0) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_STROKE;
    def.occlusion = TXC_OCCLUSION_NONE;
    def.hardness = static_cast<float>(hardness);
    def.flow = static_cast<float>(flow);
    return def;
}

inline TxcDab dab_at(double x, double y, double size, double flow = 1.0) {
    TxcDab dab;
    txc_dab_default(&dab);
    dab.flow = static_cast<float>(flow);
    dab.position_model[0] = static_cast<float>(x);
    dab.position_model[1] = static_cast<float>(y);
    for (float& extent : dab.size) extent = static_cast<float>(size);
    return dab;
}

inline TxcStatus try_add_dabs(const TestSession& session, TxcLayer layer, const std::vector<TxcDab>& dabs) {
    return txc_stroke_add_dabs(session.id(), layer, dabs.data(), static_cast<std::uint32_t>(dabs.size()));
}
inline void add_dabs(const TestSession& session, TxcLayer layer, const std::vector<TxcDab>& dabs) {
    if (!dabs.empty()) must(try_add_dabs(session, layer, dabs));
}

}  // namespace support
