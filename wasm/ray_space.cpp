#include "ray_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace txc {
namespace {

// Nearer to the eye than this share of the near distance a point's place in the picture says little.
constexpr double kInTheEye = 1.0 / 16.0;

}  // namespace

RaySpace::RaySpace(const PlanarProjector& projector)
    : to_space_(projector.to_decal), towards_viewer_(projector.towards_viewer), depth_(projector.depth) {
    to_space_.reach = glm::dvec3(kHalfSide, kHalfSide, 0.5);
    eye_.near_distance = 0.0;
}

RaySpace::RaySpace(const PerspectiveProjector& projector, const Bounds& model) : eye_(projector) {
    // All depths that a model has are spread over the space, however near the near plane is.
    const ProjectorPose& pose = eye_.pose;
    const BoxExtent extent({model.min, model.max});
    const double middle = -pose.to_view(extent.centre).z;
    const double reach = extent.reach_along(pose.towards);
    const double nearest = std::max(eye_.near_distance, middle - reach);
    const double farthest = std::max(nearest * 1.001, std::min(eye_.far_distance, middle + reach));
    scale_ = 1.0 / (1.0 / nearest - 1.0 / farthest);
    shift_ = 0.5 - scale_ / nearest;
    const glm::dvec3 rows[3] = {pose.right * eye_.scale_x, pose.up * eye_.scale_y, pose.towards * -shift_};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) to_space_.matrix[c][r] = rows[r][c];
        to_space_.offset[r] = -glm::dot(rows[r], pose.position);
    }
    to_space_.offset.z += scale_;
}

bool RaySpace::is_same(const RaySpace& other) const {
    return to_space_.matrix == other.to_space_.matrix && to_space_.offset == other.to_space_.offset &&
           eye_.near_distance == other.eye_.near_distance && eye_.far_distance == other.eye_.far_distance;
}

void RaySpace::divide(const glm::dvec3* points, glm::dvec3* out, int count) const {
    for (int i = 0; i < count; ++i) {
        const double distance = glm::dot(eye_.pose.position - points[i], eye_.pose.towards);
        const bool is_seen = distance > eye_.near_distance * kInTheEye;
        out[i] = is_seen ? out[i] / distance : glm::dvec3(std::numeric_limits<double>::infinity());
    }
}

bool RaySpace::may_touch(const ModelBox& box) const {
    constexpr double kBeyond = kHalfSide - 0.5;
    return has_eye() ? eye_.may_touch(box, {kBeyond, kBeyond}) : to_space_.may_touch(box);
}

double RaySpace::lift_to_eye(double x, double y, double z, double distance) const {
    const double nearness = (z - shift_) / scale_;
    x /= eye_.scale_x;
    y /= eye_.scale_y;
    const double share = distance * nearness / std::sqrt(1.0 + x * x + y * y);  // of the way to the eye
    if (!(share < 1.0)) return std::numeric_limits<double>::infinity();
    return scale_ * nearness * (share / (1.0 - share));
}

double RaySpace::least_lift_to_eye(const double (&x)[4], const double (&y)[4], double z, double distance) const {
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c) least = std::min(least, lift_to_eye(x[c], y[c], z, distance));
    return least;
}

TexelRay RaySpace::ray_from(const glm::dvec3& point, const glm::dvec3& q, std::uint32_t own) const {
    if (!has_eye()) return {point, towards_viewer_, (0.5 - q.z) * depth_, own};
    TexelRay ray{point, {}, 0.0, own};
    if (eye_.ray_from(eye_.pose.to_view(point), ray.direction, ray.length))
        ray.direction = eye_.pose.turn_to_model(ray.direction);
    return ray;
}

}  // namespace txc
