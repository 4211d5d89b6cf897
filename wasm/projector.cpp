#include "projector.h"

namespace txc {

TxcStatus PlanarProjector::from_def(const TxcLayerDef& def, PlanarProjector& out) {
    ProjectorPose pose;
    if (const TxcStatus status = ProjectorPose::from_def(def, pose); status != TXC_STATUS_OK) return status;
    for (int c = 0; c < 3; ++c) {
        static constexpr const char* kFields[3] = {"size[0]", "size[1]", "size[2]"};
        if (const TxcStatus status = check_length(def.size[c], kFields[c]); status != TXC_STATUS_OK) return status;
    }
    // Rows of the inverse: a rotation's inverse is its transpose, each row divided by the box's extent.
    const glm::dvec3 rows[3] = {pose.right / static_cast<double>(def.size[0]),
                                pose.up / static_cast<double>(def.size[1]),
                                pose.towards / static_cast<double>(def.size[2])};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.to_decal.matrix[c][r] = rows[r][c];
        out.to_decal.offset[r] = -glm::dot(rows[r], pose.position);
    }
    out.towards_viewer = pose.towards;
    for (int c = 0; c < 3; ++c) {
        const glm::vec3 column(out.to_decal.matrix[c]);
        out.columns[c] = Float4{column.x, column.y, column.z, static_cast<float>(pose.towards[c])};
    }
    out.depth = static_cast<double>(def.size[2]);
    return TXC_STATUS_OK;
}

ProjectedFrame project_frame(const PlanarProjector& projector, const TexelFrame& frame) {
    // The place in double: a small decal on a large model, far from the origin, is a difference of large numbers. The
    // slopes are none, and float keeps them to a ten-thousandth of a pixel over any frame.
    const glm::dvec3 place = projector.to_decal.apply(glm::dvec3(frame.position));
    const Float4* columns = projector.columns;
    // Model directions in the first three lanes, the frame's normals in the last: both go through the same columns.
    const auto turn = [columns](const glm::vec3& p, const glm::vec3& n) {
        return columns[0] * Float4{p.x, p.x, p.x, n.x} + columns[1] * Float4{p.y, p.y, p.y, n.y} +
               columns[2] * Float4{p.z, p.z, p.z, n.z};
    };
    ProjectedFrame seen;
    seen.at = turn(glm::vec3(0.0f), frame.normal);
    seen.at[0] = static_cast<float>(place.x);
    seen.at[1] = static_cast<float>(place.y);
    seen.at[2] = static_cast<float>(place.z);
    seen.dx = turn(frame.position_dx, frame.normal_dx);
    seen.dy = turn(frame.position_dy, frame.normal_dy);
    return seen;
}

}  // namespace txc
