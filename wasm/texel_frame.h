// Position and normal of one triangle as affine functions of the texel: what the local space map is made of.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "mesh.h"
#include "uv_raster.h"

namespace txc {

/// `x0`, `y0` is the texel at whose centre position and normal hold. A triangle whose UVs wrap has one frame for each
/// repeat that owns texels, and a sliver one for each row.
struct TexelFrame {
    /// One coordinate over the texels. Coordinate by coordinate a projector turns all three parts in one go.
    struct Coordinate {
        float at;  // the texel (x0, y0)
        float dx;  // change a texel to the right
        float dy;  // change a texel down
    };

    Coordinate position[3];  // from the mesh's origin, metres
    Coordinate normal[3];    // not normalised: interpolated like the positions
    std::int32_t x0;
    std::int32_t y0;
    std::uint32_t triangle;  // index into Mesh::triangles

    glm::vec3 position_at(std::int32_t x, std::int32_t y) const { return at(position, x, y); }
    glm::vec3 normal_at(std::int32_t x, std::int32_t y) const { return at(normal, x, y); }

    /// A member of all three coordinates: part(frame.position, &TexelFrame::Coordinate::dx).
    static glm::vec3 part(const Coordinate (&of)[3], float Coordinate::*member) {
        return {of[0].*member, of[1].*member, of[2].*member};
    }

private:
    glm::vec3 at(const Coordinate (&of)[3], std::int32_t x, std::int32_t y) const {
        return part(of, &Coordinate::at) + part(of, &Coordinate::dx) * static_cast<float>(x - x0) +
               part(of, &Coordinate::dy) * static_cast<float>(y - y0);
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
