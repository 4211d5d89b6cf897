// Decals by the projectors that are not planar, as tests ask for them.
#pragma once

#include "test_session.h"

namespace support {

inline TxcLayerDef perspective_def(TxcImage image, double fov_degrees, double aspect, double near_distance,
                                   double far_distance) {
    TxcLayerDef def = decal_def(image);
    def.projector = TXC_PROJECTOR_PERSPECTIVE;
    def.fov_degrees = static_cast<float>(fov_degrees);
    def.aspect = static_cast<float>(aspect);
    def.near_distance = static_cast<float>(near_distance);
    def.far_distance = static_cast<float>(far_distance);
    return def;
}

inline TxcLayerDef cylindrical_def(TxcImage image, double radius, double height, double arc_degrees, double depth) {
    TxcLayerDef def = decal_def(image);
    def.projector = TXC_PROJECTOR_CYLINDRICAL;
    def.radius = static_cast<float>(radius);
    def.height = static_cast<float>(height);
    def.arc_degrees = static_cast<float>(arc_degrees);
    def.depth = static_cast<float>(depth);
    return def;
}

inline TxcLayerDef uv_def(TxcImage image, double u, double v, double size_u, double size_v, double angle_degrees) {
    TxcLayerDef def = decal_def(image);
    def.projector = TXC_PROJECTOR_UV;
    def.uv_center[0] = static_cast<float>(u);
    def.uv_center[1] = static_cast<float>(v);
    def.uv_size[0] = static_cast<float>(size_u);
    def.uv_size[1] = static_cast<float>(size_v);
    def.uv_angle_degrees = static_cast<float>(angle_degrees);
    return def;
}

/// A vertex of the eye's way: turns the layer so that its -Z looks from its position to a point, its Y as near to +Y as
/// may be.
inline void look_at(TxcLayerDef& def, double x, double y, double z) {
    double towards[3] = {def.position_model[0] - x, def.position_model[1] - y, def.position_model[2] - z};
    const double length = std::sqrt(towards[0] * towards[0] + towards[1] * towards[1] + towards[2] * towards[2]);
    for (double& part : towards) part /= length;
    // First up or down about X, then about Y.
    const double pitch = std::asin(towards[1]) / 2;
    const double yaw = std::atan2(towards[0], towards[2]) / 2;
    def.rotation[0] = static_cast<float>(-std::cos(yaw) * std::sin(pitch));
    def.rotation[1] = static_cast<float>(std::sin(yaw) * std::cos(pitch));
    def.rotation[2] = static_cast<float>(std::sin(yaw) * std::sin(pitch));
    def.rotation[3] = static_cast<float>(std::cos(yaw) * std::cos(pitch));
}

}  // namespace support
