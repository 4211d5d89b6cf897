// The cylindrical projector: a label around a mug. Rays run straight away from the box's Y axis (spec section 3).
#pragma once

#include "projector_pose.h"
#include "texel_sight.h"

namespace txc {

struct CylindricalProjector {
    ProjectorPose pose;
    double radius = 0.5;  // metres
    double height = 1.0;  // metres, along the axis
    double depth = 0.1;   // metres, either side of the radius
    double period = 1.0;  // decal widths in a whole turn: 360 / arc; 1 where the picture meets itself at the back

    /// From an ABI layer's fields; `origin` as of ProjectorPose. BAD_ARGUMENT names the field.
    static TxcStatus from_def(const TxcLayerDef& def, const glm::vec3& origin, CylindricalProjector& out);

    /// Test 1 in depth, and where the texel's ray meets the label. `at` is in view space. The picture's x lies within
    /// half a period of the middle. False on the axis, too: from there every way is outward.
    bool look(const TexelPlace& at, TexelSight& out) const;

    /// Whether all that lies no further than `reach` from a point (view space) is inside of the volume in depth.
    bool holds(const glm::dvec3& point, double reach) const;

    /// The way from a point (view space) outward: a unit direction in view space, and how much of it lies inside the
    /// volume, metres. False on the axis.
    bool ray_from(const glm::dvec3& point, glm::dvec3& out_direction, double& out_length) const;

    /// True where a texel whose footprint lies in the box may be painted.
    bool may_touch(const ModelBox& box, const PictureMargin& margin) const;
};

}  // namespace txc
