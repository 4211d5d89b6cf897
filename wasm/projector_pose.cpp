#include "projector_pose.h"

#include <cmath>

#include "mesh.h"

namespace txc {

TxcStatus ProjectorPose::from_def(const TxcLayerDef& def, const glm::vec3& origin, ProjectorPose& out) {
    for (int c = 0; c < 3; ++c) {
        if (!(std::fabs(def.position_model[c]) <= kMaxCoordinate)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "position[%d] is %g; it must be a finite number of metres", c,
                        static_cast<double>(def.position_model[c]));
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
    out.position = glm::dvec3(glm::vec3(def.position_model[0], def.position_model[1], def.position_model[2]) - origin);
    out.right = glm::dvec3(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y));
    out.up = glm::dvec3(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x));
    out.towards = glm::dvec3(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
    return TXC_STATUS_OK;
}

BoxExtent::BoxExtent(const ModelBox& box) {
    const glm::dvec3 low(box.min);
    const glm::dvec3 high(box.max);
    centre = (low + high) * 0.5;
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    // A float's rounding, several times over.
    half = (high - low) * 0.5 + glm::dvec3(1e-6 * glm::max(farthest.x, glm::max(farthest.y, farthest.z)));
}

TxcStatus check_length(float value, const char* field) {
    if (value >= kMinLength && value <= kMaxCoordinate) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "%s is %g; it must be from 1e-12 to 1e+12", field, static_cast<double>(value));
}

}  // namespace txc
