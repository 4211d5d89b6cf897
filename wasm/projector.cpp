#include "projector.h"

#include <cstddef>
#include <cstring>

namespace txc {

TxcStatus PlanarProjector::from_def(const TxcLayerDef& def, const glm::vec3& origin, PlanarProjector& out) {
    ProjectorPose pose;
    if (const TxcStatus status = ProjectorPose::from_def(def, origin, pose); status != TXC_STATUS_OK) return status;
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
        for (int r = 0; r < 3; ++r) out.rows[r][c] = splat(static_cast<float>(rows[r][c]));
        out.rows[3][c] = splat(static_cast<float>(pose.towards[c]));
        out.centre[c] = Float4{static_cast<float>(pose.position[c]), 0.0f, 0.0f, 0.0f};
    }
    out.depth = static_cast<double>(def.size[2]);
    return TXC_STATUS_OK;
}

ProjectedFrame project_frame(const PlanarProjector& projector, const TexelFrame& frame) {
    // The three parts of a coordinate, with the float before (which there is none of before the first) or after them.
    const auto load = [&frame](std::size_t offset) {
        Float4 parts;
        std::memcpy(&parts, reinterpret_cast<const char*>(&frame) + offset, sizeof parts);
        return parts;
    };
    constexpr std::size_t kPosition = offsetof(TexelFrame, position);
    constexpr std::size_t kBeforeNormal = offsetof(TexelFrame, normal) - sizeof(float);
    constexpr std::size_t kNext = sizeof(TexelFrame::Coordinate);
    const auto turn = [](const Float4(&row)[3], Float4 x, Float4 y, Float4 z) {
        return row[0] * x + row[1] * y + row[2] * z;
    };
    // The centre is taken off first: a small decal on a large model, far from the origin, would else be a difference of
    // large products.
    const Float4 x = load(kPosition) - projector.centre[0];
    const Float4 y = load(kPosition + kNext) - projector.centre[1];
    const Float4 z = load(kPosition + 2 * kNext) - projector.centre[2];
    const Float4 facing =
        turn(projector.rows[3], load(kBeforeNormal), load(kBeforeNormal + kNext), load(kBeforeNormal + 2 * kNext));
    ProjectedFrame seen;
    transpose3(turn(projector.rows[0], x, y, z), turn(projector.rows[1], x, y, z), turn(projector.rows[2], x, y, z),
               move_down(facing), seen.at, seen.dx, seen.dy);
    return seen;
}

}  // namespace txc
