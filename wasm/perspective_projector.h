// The perspective projector: an eye that looks along its own -Z, as a camera or a slide projector does (spec section 3).
#pragma once

#include "projector_pose.h"
#include "texel_sight.h"

namespace txc {

struct PerspectiveProjector {
    ProjectorPose pose;
    // Decal space a unit of x / depth and y / depth: half the picture lies where those are tan(fov / 2) * aspect and
    // tan(fov / 2).
    double scale_x = 0.5;
    double scale_y = 0.5;
    double near_distance = 0.1;  // metres from the eye along its -Z
    double far_distance = 100.0;

    /// From an ABI layer's fields; `origin` as of ProjectorPose. BAD_ARGUMENT names the field.
    static TxcStatus from_def(const TxcLayerDef& def, const glm::vec3& origin, PerspectiveProjector& out);

    /// Test 1 in depth, and where the camera sees the texel. `at` is in view space.
    bool look(const TexelPlace& at, TexelSight& out) const;

    /// Whether all that lies no further than `reach` from a point (view space) is inside of the volume in depth.
    bool holds(const glm::dvec3& point, double reach) const;

    /// The way from a point (view space) to the eye: a unit direction in view space, and how much of it lies inside the
    /// volume, metres.
    bool ray_from(const glm::dvec3& point, glm::dvec3& out_direction, double& out_length) const;

    /// True where a texel whose footprint lies in the box may be painted.
    bool may_touch(const ModelBox& box, const PictureMargin& margin) const;
};

}  // namespace txc
