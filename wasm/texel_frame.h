// Position and normal of one triangle as affine functions of the texel: what the local space map is made of.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "mesh.h"
#include "uv_raster.h"

namespace txc {

/// `x0`, `y0` is the texel at whose centre `position` and `normal` hold. A triangle whose UVs wrap has one frame for
/// each repeat that owns texels.
struct TexelFrame {
    glm::vec3 position;     // model space, metres
    glm::vec3 position_dx;  // metres a texel to the right
    glm::vec3 position_dy;  // metres a texel down
    glm::vec3 normal;       // not normalised: interpolated like the positions
    glm::vec3 normal_dx;
    glm::vec3 normal_dy;
    std::int32_t x0;
    std::int32_t y0;
    std::uint32_t triangle;  // index into Mesh::triangles

    glm::vec3 position_at(std::int32_t x, std::int32_t y) const {
        return position + position_dx * static_cast<float>(x - x0) + position_dy * static_cast<float>(y - y0);
    }
    glm::vec3 normal_at(std::int32_t x, std::int32_t y) const {
        return normal + normal_dx * static_cast<float>(x - x0) + normal_dy * static_cast<float>(y - y0);
    }
};

/// A place in texture space: a texel of the target, and where the repeat that it is seen in begins (in texels).
struct RepeatedTexel {
    std::int32_t x;
    std::int32_t y;
    std::int64_t repeat_x;
    std::int64_t repeat_y;
};

/// Makes the frame of a triangle (its corners in texels: `texels`) at a texel that it covers.
void make_texel_frame(const Mesh& mesh, std::uint32_t triangle, const TexelTriangle& texels, const RepeatedTexel& at,
                      TexelFrame& out);

}  // namespace txc
