#include "cylindrical_projector.h"

#include <cmath>

#include "exact_math.h"

namespace txc {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;
// Nearer to the axis than this share of the radius a point has no direction that rounding did not make.
constexpr double kAxisShare = 1e-6;

}  // namespace

TxcStatus CylindricalProjector::from_def(const TxcLayerDef& def, const glm::vec3& origin, CylindricalProjector& out) {
    if (const TxcStatus status = ProjectorPose::from_def(def, origin, out.pose); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_length(def.radius, "radius"); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_length(def.height, "height"); status != TXC_STATUS_OK) return status;
    if (!(def.arc_degrees > 0.0f && def.arc_degrees <= 360.0f)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "arc_degrees is %g; it must be above 0 and at most 360",
                    static_cast<double>(def.arc_degrees));
    }
    if (const TxcStatus status = check_length(def.depth, "depth"); status != TXC_STATUS_OK) return status;
    out.radius = static_cast<double>(def.radius);
    out.height = static_cast<double>(def.height);
    out.depth = static_cast<double>(def.depth);
    out.period = 360.0 / static_cast<double>(def.arc_degrees);
    return TXC_STATUS_OK;
}

bool CylindricalProjector::look(const TexelPlace& at, TexelSight& out) const {
    const glm::dvec3& p = at.position;
    const double squared = p.x * p.x + p.z * p.z;
    const double from_axis = std::sqrt(squared);
    if (!(from_axis > radius * kAxisShare) || !(std::fabs(from_axis - radius) <= depth)) return false;
    const double by_angle = period / kTurn / squared;
    PictureSight& picture = out.picture;
    // Half a turn is half a period to the last bit, so that the back's centres fall into the picture.
    picture.x = exact_atan2(p.x, p.z) / kTurn * period;
    picture.y = p.y / height;
    picture.across_x = (p.z * at.across.x - p.x * at.across.z) * by_angle;
    picture.across_y = at.across.y / height;
    picture.down_x = (p.z * at.down.x - p.x * at.down.z) * by_angle;
    picture.down_y = at.down.y / height;
    out.ray = glm::dvec3(p.x / from_axis, 0.0, p.z / from_axis);
    return true;
}

bool CylindricalProjector::holds(const glm::dvec3& point, double reach) const {
    return std::fabs(std::sqrt(point.x * point.x + point.z * point.z) - radius) + reach <= depth;
}

bool CylindricalProjector::ray_from(const glm::dvec3& point, glm::dvec3& out_direction, double& out_length) const {
    const double from_axis = std::sqrt(point.x * point.x + point.z * point.z);
    if (!(from_axis > radius * kAxisShare)) return false;
    out_direction = glm::dvec3(point.x / from_axis, 0.0, point.z / from_axis);
    out_length = radius + depth - from_axis;
    return true;
}

// As with the perspective projector, a footprint is the linear part of the map. With w the way from the texel's centre,
// measured by the centre's distance from the axis, its angle strays from the true one by no more than w^2 where w is
// below 1/2: it is the imaginary part of w as a complex number, and the true one that of log(1 + w).
bool CylindricalProjector::may_touch(const ModelBox& box, const PictureMargin& margin) const {
    const BoxExtent extent(box);
    const glm::dvec3 centre = pose.to_view(extent.centre);
    if (std::fabs(centre.y) - extent.reach_along(pose.up) > (0.5 + margin.y) * height) return false;
    const double reach_x = extent.reach_along(pose.right);
    const double reach_z = extent.reach_along(pose.towards);
    const double inner_x = std::fmax(std::fabs(centre.x) - reach_x, 0.0);
    const double inner_z = std::fmax(std::fabs(centre.z) - reach_z, 0.0);
    const double outer_x = std::fabs(centre.x) + reach_x;
    const double outer_z = std::fabs(centre.z) + reach_z;
    const double innermost = std::sqrt(inner_x * inner_x + inner_z * inner_z);
    const double outermost = std::sqrt(outer_x * outer_x + outer_z * outer_z);
    if (innermost > radius + depth || outermost < radius - depth) return false;
    if (period <= 1.0) return true;
    const double box_radius = extent.radius();
    const double from_axis = std::sqrt(centre.x * centre.x + centre.z * centre.z);
    const double nearest = std::fmax(innermost, radius - depth);
    if (box_radius >= 0.5 * nearest || box_radius >= from_axis) return true;
    const double sine = box_radius / from_axis;
    const double half_angle = exact_atan2(sine, std::sqrt(1.0 - sine * sine));
    const double strays = (box_radius / nearest) * (box_radius / nearest);
    const double limit = (0.5 + margin.x) * kTurn / period;
    return std::fabs(exact_atan2(centre.x, centre.z)) - half_angle - strays <= limit;
}

}  // namespace txc
