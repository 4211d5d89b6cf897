// Where a point of the model meets a decal, in double precision, written from spec.md section 3 and sharing no code with
// the core.
#pragma once

#include <cmath>

#include "reference_map.h"
#include "texelcast.h"

namespace support {

/// v turned by the inverse of the layer's rotation: Rodrigues' form of conjugation by a unit quaternion.
inline Vec3 into_box(const TxcLayerDef& def, const Vec3& v, double direction = -1.0) {
    const double norm = std::sqrt(static_cast<double>(def.rotation[0]) * def.rotation[0] +
                                  static_cast<double>(def.rotation[1]) * def.rotation[1] +
                                  static_cast<double>(def.rotation[2]) * def.rotation[2] +
                                  static_cast<double>(def.rotation[3]) * def.rotation[3]);
    const Vec3 axis = Vec3{def.rotation[0] / norm, def.rotation[1] / norm, def.rotation[2] / norm} * direction;
    const Vec3 twice = cross(axis, v) * 2.0;
    return v + twice * (def.rotation[3] / norm) + cross(axis, twice);
}
/// And back.
inline Vec3 out_of_box(const TxcLayerDef& def, const Vec3& v) { return into_box(def, v, 1.0); }

/// What a point sees through the layer's projector.
struct ReferenceSight {
    double x = 0, y = 0;       // decal space
    double depth_slack = 1e9;  // how far inside the volume's depth, in parts of it; negative outside
    Vec3 towards;              // unit, model space: along the ray to the projector
    double reach = 0;          // metres of the ray that lie inside the volume
};

/// `u`, `v` as the target has them, for the flat stamp.
inline ReferenceSight look(const TxcLayerDef& def, const Vec3& point, double u, double v) {
    ReferenceSight sight;
    const Vec3 q = into_box(def, point - vec3(def.position_model));
    if (def.projector == TXC_PROJECTOR_PLANAR) {
        sight.x = q.x / def.size[0];
        sight.y = q.y / def.size[1];
        sight.depth_slack = 0.5 - std::fabs(q.z / def.size[2]);
        sight.towards = out_of_box(def, {0, 0, 1});
        sight.reach = 0.5 * def.size[2] - q.z;
    } else if (def.projector == TXC_PROJECTOR_PERSPECTIVE) {
        const double depth = -q.z;
        const double half_height = depth * std::tan(def.fov_degrees * kPi / 360.0);
        sight.x = 0.5 * q.x / (half_height * def.aspect);
        sight.y = 0.5 * q.y / half_height;
        sight.depth_slack = std::fmin(depth - def.near_distance, def.far_distance - depth) / def.far_distance;
        sight.towards = out_of_box(def, q * (-1.0 / length(q)));
        sight.reach = length(q) * (1.0 - def.near_distance / depth);
    } else if (def.projector == TXC_PROJECTOR_CYLINDRICAL) {
        const double from_axis = std::hypot(q.x, q.z);
        sight.x = std::atan2(q.x, q.z) / (def.arc_degrees * kPi / 180.0);
        sight.y = q.y / def.height;
        sight.depth_slack = (def.depth - std::fabs(from_axis - def.radius)) / def.radius;
        sight.towards = out_of_box(def, {q.x / from_axis, 0, q.z / from_axis});
        sight.reach = def.radius + def.depth - from_axis;
    } else {
        const double angle = def.uv_angle_degrees * kPi / 180.0;
        const double right = u - def.uv_center[0];
        const double down = v - def.uv_center[1];
        // Back by the angle: clockwise is from right to down.
        sight.x = (right * std::cos(angle) + down * std::sin(angle)) / def.uv_size[0];
        sight.y = -(down * std::cos(angle) - right * std::sin(angle)) / def.uv_size[1];
    }
    return sight;
}

/// Decal widths after which the same point is met again; 0 where there is no going round.
inline double period_of(const TxcLayerDef& def) {
    return def.projector == TXC_PROJECTOR_CYLINDRICAL ? 360.0 / static_cast<double>(def.arc_degrees) : 0.0;
}

}  // namespace support
