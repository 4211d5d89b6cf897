// A projector says where a texel's outward ray meets the decal (spec section 3): the planar one. The others are in
// curved_projection.h.
#pragma once

#include <glm/glm.hpp>

#include "float4.h"
#include "local_space_map.h"
#include "projector_pose.h"
#include "status.h"
#include "tile_tree.h"

namespace txc {

/// The planar projector: a box whose +Z looks at the viewer, M = T * R * S.
struct PlanarProjector {
    ModelToDecal to_decal;           // model space to the box [-1/2, 1/2]^3
    glm::dvec3 towards_viewer{0.0};  // unit, model space: the box's +Z
    double depth = 1.0;              // metres, the box's full extent along Z
    // For frames, in all lanes each: to_decal's matrix by rows, and as a fourth towards_viewer.
    Float4 rows[4][3] = {};
    Float4 centre[3] = {};  // from the mesh's origin, in the first lane

    /// From an ABI layer's fields; `origin` as of ProjectorPose. BAD_ARGUMENT names the field.
    static TxcStatus from_def(const TxcLayerDef& def, const glm::vec3& origin, PlanarProjector& out);
};

/// One texel frame seen through a projector, affine in the texel. Lanes: decal space x, y and z, and normal . ray before
/// the normal is normalised.
struct ProjectedFrame {
    Float4 at;  // the frame's own texel (x0, y0)
    Float4 dx;  // a texel to the right
    Float4 dy;  // a texel down
};

ProjectedFrame project_frame(const PlanarProjector& projector, const TexelFrame& frame);

}  // namespace txc
