#include "projector.h"

#include <cmath>

namespace txc {

TxcStatus PlanarProjector::from_def(const TxcLayerDef& def, PlanarProjector& out) {
    for (int c = 0; c < 3; ++c) {
        if (!(std::fabs(def.position_model[c]) <= kMaxCoordinate)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "position[%d] is %g; it must be a finite number of metres", c,
                        static_cast<double>(def.position_model[c]));
        }
        if (!(def.size[c] > 0.0f) || !(def.size[c] <= kMaxCoordinate)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "size[%d] is %g; it must be above 0 and finite", c,
                        static_cast<double>(def.size[c]));
        }
    }
    double length_squared = 0.0;
    for (const float part : def.rotation) length_squared += static_cast<double>(part) * static_cast<double>(part);
    if (!(length_squared > 1e-12) || !(length_squared < 1e12)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "rotation (%g, %g, %g, %g) is not a quaternion",
                    static_cast<double>(def.rotation[0]), static_cast<double>(def.rotation[1]),
                    static_cast<double>(def.rotation[2]), static_cast<double>(def.rotation[3]));
    }
    const double length = std::sqrt(length_squared);
    const double x = def.rotation[0] / length;
    const double y = def.rotation[1] / length;
    const double z = def.rotation[2] / length;
    const double w = def.rotation[3] / length;
    const glm::dvec3 right(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y));
    const glm::dvec3 up(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x));
    const glm::dvec3 towards(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
    // Rows of the inverse: a rotation's inverse is its transpose, each row divided by the box's extent.
    const glm::dvec3 rows[3] = {right / static_cast<double>(def.size[0]), up / static_cast<double>(def.size[1]),
                                towards / static_cast<double>(def.size[2])};
    const glm::dvec3 centre(def.position_model[0], def.position_model[1], def.position_model[2]);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) out.to_decal.matrix[c][r] = rows[r][c];
        out.to_decal.offset[r] = -glm::dot(rows[r], centre);
    }
    out.towards_viewer = towards;
    for (int c = 0; c < 3; ++c) {
        const glm::vec3 column(out.to_decal.matrix[c]);
        out.columns[c] = Float4{column.x, column.y, column.z, static_cast<float>(towards[c])};
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
