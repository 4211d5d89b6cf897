// The C ABI's functions for print truth: zones, and what becomes of layers on the surface.
#include "abi_door.h"
#include "surface_metrics.h"

namespace {

using txc::fail;
using txc::in_session;
using txc::Session;
using txc::Target;

TxcStatus check_rows(const txc::LocalSpaceMap& map, uint32_t row, uint32_t row_count) {
    const uint32_t height = map.key.height;
    if (row <= height && row_count <= height - row) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "rows %u to %u lie outside the map's %u", row, row + row_count, height);
}

/// Runs `read(map, zone)` for a zone on a baked map.
template <typename Read>
TxcStatus read_zone(Session& session, TxcTarget target_id, uint32_t zone_index, Read&& read) {
    Target* target = nullptr;
    if (const TxcStatus status = session.find_baked(target_id, target); status != TXC_STATUS_OK) return status;
    const txc::PrintZone* zone = nullptr;
    if (const TxcStatus status = session.find_zone(zone_index, zone); status != TXC_STATUS_OK) return status;
    return read(*target->map, zone);
}

}  // namespace

extern "C" {

void txc_zone_default(TxcZone* zone) {
    if (zone == nullptr) return;
    *zone = TxcZone{};
    zone->rotation[3] = 1.0f;
    for (float& extent : zone->size) extent = 1.0f;
}

TxcStatus txc_session_set_zones(TxcSession session, const TxcZone* zones, uint32_t zone_count, const float* corners_uv,
                                uint32_t corner_count) {
    return in_session(session, [&](Session& s) { return s.set_zones(zones, zone_count, corners_uv, corner_count); });
}

TxcStatus txc_zone_mask(TxcSession session, TxcTarget target, uint32_t zone_index, uint32_t row, uint32_t row_count,
                        uint8_t* out) {
    return in_session(session, out, "out", [&](Session& s) {
        return read_zone(s, target, zone_index, [&](const txc::LocalSpaceMap& map, const txc::PrintZone* zone) {
            if (const TxcStatus status = check_rows(map, row, row_count); status != TXC_STATUS_OK) return status;
            txc::draw_zone_mask(map, s.zones(), zone, row, row_count, out);
            return TXC_STATUS_OK;
        });
    });
}

TxcStatus txc_zone_surface(TxcSession session, TxcTarget target, uint32_t zone_index, TxcZoneSurface* out_surface) {
    return in_session(session, out_surface, "out_surface", [&](Session& s) {
        return read_zone(s, target, zone_index, [&](const txc::LocalSpaceMap& map, const txc::PrintZone* zone) {
            *out_surface = txc::measure_zone(map, zone);
            return TXC_STATUS_OK;
        });
    });
}

TxcStatus txc_layer_metrics(TxcSession session, const TxcLayer* layers, uint32_t layer_count,
                            TxcLayerMetrics* out_metrics, float* out_zone_shares) {
    return in_session(session, layers != nullptr ? out_metrics : nullptr, "layers or out_metrics", [&](Session& s) {
        txc::LayerMeter meter(s.zones());
        for (uint32_t i = 0; i < layer_count; ++i) {
            const txc::LocalSpaceMap* map = nullptr;
            const txc::Layer* layer = nullptr;
            const txc::ImagePyramid* image = nullptr;
            if (const TxcStatus status = s.find_measured(layers[i], map, layer, image); status != TXC_STATUS_OK)
                return status;
            meter.add({*map, *layer, image});
        }
        *out_metrics = meter.result();
        for (std::size_t z = 0; out_zone_shares != nullptr && z < s.zones().size(); ++z)
            out_zone_shares[z] = static_cast<float>(meter.zone_share(z));
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_layer_print_map(TxcSession session, TxcLayer layer_id, uint32_t kind, uint32_t row, uint32_t row_count,
                              float* out) {
    if (kind >= TXC_PRINT_MAP_COUNT)
        return fail(TXC_STATUS_BAD_ARGUMENT, "kind is %u; there are %d", kind, TXC_PRINT_MAP_COUNT);
    return in_session(session, out, "out", [&](Session& s) {
        const txc::LocalSpaceMap* map = nullptr;
        const txc::Layer* layer = nullptr;
        const txc::ImagePyramid* image = nullptr;
        if (const TxcStatus status = s.find_measured(layer_id, map, layer, image); status != TXC_STATUS_OK)
            return status;
        if (const TxcStatus status = check_rows(*map, row, row_count); status != TXC_STATUS_OK) return status;
        txc::draw_print_map({*map, *layer, image}, kind, row, row_count, out);
        return TXC_STATUS_OK;
    });
}

}  // extern "C"
