#include "perspective_projector.h"

#include <cmath>

#include "exact_math.h"

namespace txc {
namespace {

constexpr double kRadiansADegree = 3.14159265358979323846 / 180.0;

}  // namespace

TxcStatus PerspectiveProjector::from_def(const TxcLayerDef& def, const glm::vec3& origin, PerspectiveProjector& out) {
    if (const TxcStatus status = ProjectorPose::from_def(def, origin, out.pose); status != TXC_STATUS_OK) return status;
    if (!(def.fov_degrees > 0.0f && def.fov_degrees < 180.0f)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "fov_degrees is %g; it must be above 0 and below 180",
                    static_cast<double>(def.fov_degrees));
    }
    if (const TxcStatus status = check_length(def.aspect, "aspect"); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_length(def.near_distance, "near_distance"); status != TXC_STATUS_OK)
        return status;
    if (const TxcStatus status = check_length(def.far_distance, "far_distance"); status != TXC_STATUS_OK) return status;
    // Equal ones are an empty volume and no fault: two numbers that a host tells apart may be the same float.
    if (def.far_distance < def.near_distance) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "far_distance is %g; it must not be below near_distance, %g",
                    static_cast<double>(def.far_distance), static_cast<double>(def.near_distance));
    }
    double sine = 0.0;
    double cosine = 1.0;
    exact_sin_cos(static_cast<double>(def.fov_degrees) * 0.5 * kRadiansADegree, sine, cosine);
    out.scale_y = 0.5 * cosine / sine;
    out.scale_x = out.scale_y / static_cast<double>(def.aspect);
    out.near_distance = static_cast<double>(def.near_distance);
    out.far_distance = static_cast<double>(def.far_distance);
    return TXC_STATUS_OK;
}

bool PerspectiveProjector::look(const TexelPlace& at, TexelSight& out) const {
    const double depth = -at.position.z;
    if (!(depth >= near_distance && depth <= far_distance)) return false;
    const double per_depth = 1.0 / depth;
    const double x = at.position.x * per_depth;
    const double y = at.position.y * per_depth;
    const double by_x = scale_x * per_depth;
    const double by_y = scale_y * per_depth;
    PictureSight& picture = out.picture;
    picture.x = x * scale_x;
    picture.y = y * scale_y;
    picture.across_x = (at.across.x + x * at.across.z) * by_x;
    picture.across_y = (at.across.y + y * at.across.z) * by_y;
    picture.down_x = (at.down.x + x * at.down.z) * by_x;
    picture.down_y = (at.down.y + y * at.down.z) * by_y;
    out.ray = at.position * (-1.0 / glm::length(at.position));
    return true;
}

bool PerspectiveProjector::holds(const glm::dvec3& point, double reach) const {
    return -point.z - reach >= near_distance && -point.z + reach <= far_distance;
}

bool PerspectiveProjector::ray_from(const glm::dvec3& point, glm::dvec3& out_direction, double& out_length) const {
    const double depth = -point.z;
    if (!(depth > near_distance)) return false;
    const double distance = glm::length(point);
    out_direction = point * (-1.0 / distance);
    out_length = distance * ((depth - near_distance) / depth);
    return true;
}

// A texel may take paint though its centre lies beside the pyramid: its footprint reaches in. That footprint is the
// projection's linear part at the centre; it strays from the true one, which lies in the box, by no more than
// 2 (1 + slope) radius^2 / depth where the radius is below half the depth.
bool PerspectiveProjector::may_touch(const ModelBox& box, const PictureMargin& margin) const {
    const BoxExtent extent(box);
    const glm::dvec3 centre = pose.to_view(extent.centre);
    const double depth = -centre.z;
    const double depth_reach = extent.reach_along(pose.towards);
    if (depth + depth_reach < near_distance || depth - depth_reach > far_distance) return false;
    const double nearest = std::fmax(depth - depth_reach, near_distance);
    const double radius = extent.radius();
    if (radius >= 0.5 * nearest) return true;
    const double strays = 2.0 * radius * radius / nearest;
    const double slope_x = (0.5 + margin.x) / scale_x;
    const double slope_y = (0.5 + margin.y) / scale_y;
    for (const double side : {-1.0, 1.0}) {
        // How far inside the side plane the box's innermost point lies, times a positive number.
        const glm::dvec3 from_side_x = pose.right * side + pose.towards * slope_x;
        if (slope_x * depth - side * centre.x + extent.reach_along(from_side_x) < -(1.0 + slope_x) * strays)
            return false;
        const glm::dvec3 from_side_y = pose.up * side + pose.towards * slope_y;
        if (slope_y * depth - side * centre.y + extent.reach_along(from_side_y) < -(1.0 + slope_y) * strays)
            return false;
    }
    return true;
}

}  // namespace txc
