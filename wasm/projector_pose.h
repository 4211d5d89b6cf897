// Where a projector stands and how it is turned: what all kinds but the flat stamp share (spec section 3).
#pragma once

#include <glm/glm.hpp>

#include "status.h"
#include "tile_tree.h"

namespace txc {

/// Position, from the mesh's origin, and axes. The axes are unit and at right angles; +Z points from the surface to the viewer.
struct ProjectorPose {
    glm::dvec3 position{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 towards{0.0, 0.0, 1.0};

    /// From an ABI layer's position_model and rotation; `origin`: of the positions that it will look at, model space. BAD_ARGUMENT
    /// names the field.
    static TxcStatus from_def(const TxcLayerDef& def, const glm::vec3& origin, ProjectorPose& out);

    /// A direction of model space along the projector's own axes: its *view space*, metres, the position its origin.
    glm::dvec3 turn_to_view(const glm::dvec3& v) const {
        return {glm::dot(right, v), glm::dot(up, v), glm::dot(towards, v)};
    }
    glm::dvec3 to_view(const glm::dvec3& point) const { return turn_to_view(point - position); }
    glm::dvec3 turn_to_model(const glm::dvec3& v) const { return right * v.x + up * v.y + towards * v.z; }
};

/// A box of model space, for asking whether texels inside it may be painted.
struct BoxExtent {
    glm::dvec3 centre;  // model space
    glm::dvec3 half;    // a little more than half its size, for the rounding of boxes and texels to float

    explicit BoxExtent(const ModelBox& box);

    /// How far the box reaches from its centre along a direction (model space, need not be unit).
    double reach_along(const glm::dvec3& direction) const { return glm::dot(glm::abs(direction), half); }
    /// No point of the box is further from its centre.
    double radius() const { return glm::length(half); }
};

/// How far beyond its rectangle a picture still paints: the half pixel over which it fades out, in shares of its width
/// and height.
struct PictureMargin {
    double x = 0.0;
    double y = 0.0;
};

/// BAD_ARGUMENT unless kMinLength <= value <= kMaxCoordinate; `field` names it.
TxcStatus check_length(float value, const char* field);

}  // namespace txc
