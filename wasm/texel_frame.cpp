#include "texel_frame.h"

#include <cmath>

namespace txc {
namespace {

// A UV sliver can have a gradient that no float holds; it then keeps its position and normal over its few texels.
glm::vec3 finite_or_zero(const glm::dvec3& gradient) {
    constexpr double kLargest = 1e18;
    const bool finite =
        std::fabs(gradient.x) < kLargest && std::fabs(gradient.y) < kLargest && std::fabs(gradient.z) < kLargest;
    return finite ? glm::vec3(gradient) : glm::vec3(0.0f);
}

void set(TexelFrame::Coordinate (&out)[3], const glm::vec3& at, const glm::vec3& dx, const glm::vec3& dy) {
    for (int axis = 0; axis < 3; ++axis) out[axis] = {at[axis], dx[axis], dy[axis]};
}

}  // namespace

// In double: a sliver's gradients cancel, and over its length a float's rounding would move its texels off the surface.
void make_texel_frame(const Mesh& mesh, std::uint32_t triangle, const TexelTriangle& texels, const RepeatedTexel& at,
                      TexelFrame& out) {
    const Triangle& corners = mesh.triangles[triangle];
    const double per_area = 1.0 / texels.doubled_area();
    const double ab_x = texels.x[1] - texels.x[0];
    const double ab_y = texels.y[1] - texels.y[0];
    const double ac_x = texels.x[2] - texels.x[0];
    const double ac_y = texels.y[2] - texels.y[0];
    const double at_x = static_cast<double>(at.x + at.repeat_x) + 0.5 - texels.x[0];
    const double at_y = static_cast<double>(at.y + at.repeat_y) + 0.5 - texels.y[0];
    // Barycentric weights of the second and third corner, and how they change a texel to the right and a texel down.
    const double b = (at_x * ac_y - at_y * ac_x) * per_area;
    const double c = (ab_x * at_y - ab_y * at_x) * per_area;
    const double b_dx = ac_y * per_area;
    const double b_dy = -ac_x * per_area;
    const double c_dx = -ab_y * per_area;
    const double c_dy = ab_x * per_area;

    const glm::dvec3 p0(mesh.positions[corners.vertex[0]]);
    const glm::dvec3 p01 = glm::dvec3(mesh.positions[corners.vertex[1]]) - p0;
    const glm::dvec3 p02 = glm::dvec3(mesh.positions[corners.vertex[2]]) - p0;
    set(out.position, glm::vec3(p0 + p01 * b + p02 * c), finite_or_zero(p01 * b_dx + p02 * c_dx),
        finite_or_zero(p01 * b_dy + p02 * c_dy));
    out.x0 = at.x;
    out.y0 = at.y;
    out.triangle = triangle;

    const glm::vec3 zero(0.0f);
    const glm::vec3 normals[3] = {mesh.normals[corners.vertex[0]], mesh.normals[corners.vertex[1]],
                                  mesh.normals[corners.vertex[2]]};
    const glm::dvec3 n0(normals[0]);
    const glm::dvec3 n01 = glm::dvec3(normals[1]) - n0;
    const glm::dvec3 n02 = glm::dvec3(normals[2]) - n0;
    const glm::dvec3 n = n0 + n01 * b + n02 * c;
    if (normals[0] == zero || normals[1] == zero || normals[2] == zero || glm::dot(n, n) < 1e-12) {
        set(out.normal, mesh.flat_normal(corners), zero, zero);
    } else {
        set(out.normal, glm::vec3(n), finite_or_zero(n01 * b_dx + n02 * c_dx), finite_or_zero(n01 * b_dy + n02 * c_dy));
    }
}

}  // namespace txc
