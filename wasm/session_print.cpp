// What a session knows for the print: its zones, and layers that are ready to be measured.
#include "session.h"

namespace txc {

TxcStatus Session::set_zones(const TxcZone* zones, std::uint32_t zone_count, const float* corners,
                             std::uint32_t corner_count) {
    if (zone_count > TXC_MAX_ZONES)
        return fail(TXC_STATUS_BAD_ARGUMENT, "zone_count is %u; %u is the most", zone_count, TXC_MAX_ZONES);
    if (zones == nullptr && zone_count > 0) return fail(TXC_STATUS_BAD_ARGUMENT, "zones is null");
    if (corners == nullptr && corner_count > 0) return fail(TXC_STATUS_BAD_ARGUMENT, "corners_uv is null");
    std::vector<PrintZone> made(zone_count);
    for (std::uint32_t z = 0; z < zone_count; ++z) {
        const TxcStatus status = PrintZone::from_def(zones[z], z, corners, corner_count, made[z]);
        if (status != TXC_STATUS_OK) return status;
    }
    zones_ = std::move(made);
    return TXC_STATUS_OK;
}

TxcStatus Session::find_zone(std::uint32_t index, const PrintZone*& out_zone) const {
    out_zone = nullptr;
    if (index == TXC_NONE) return TXC_STATUS_OK;
    if (index >= zones_.size())
        return fail(TXC_STATUS_BAD_ARGUMENT, "zone is %u; the session has %zu, counted from 0", index, zones_.size());
    out_zone = &zones_[index];
    return TXC_STATUS_OK;
}

TxcStatus Session::find_measured(TxcLayer id, const LocalSpaceMap*& out_map, const Layer*& out_layer,
                                 const ImagePyramid*& out_image) const {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    if (layer->def.kind == TXC_LAYER_GROUP)
        return fail(TXC_STATUS_BAD_ARGUMENT, "layer %u is a group: measure the layers in it", id);
    Target* target = nullptr;
    if (const TxcStatus status = find_baked(layer->target, target); status != TXC_STATUS_OK) return status;
    if (layer->is_behind()) return fail(TXC_STATUS_BAD_ARGUMENT, "layer %u waits for an update of its target", id);
    out_map = target->map.get();
    out_layer = layer;
    out_image = layer->def.kind == TXC_LAYER_DECAL ? images_.find(layer->def.image) : nullptr;
    return TXC_STATUS_OK;
}

}  // namespace txc
