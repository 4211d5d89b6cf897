#include "texel_frame.h"

#include <cmath>

#include "double2.h"

namespace txc {
namespace {

/// Two coordinates over the texels; of each the lanes of one are TexelFrame::Coordinate.
struct CoordinatePair {
    Double2 at;
    Double2 dx;
    Double2 dy;

    Double2 gradients() const { return absolute2(dx) + absolute2(dy); }
};

/// Barycentric weights of the second and third corner, and how they change a texel to the right and a texel down.
struct CornerWeights {
    double b, c;
    double b_dx, b_dy;
    double c_dx, c_dy;

    CoordinatePair mix(Double2 first, Double2 second, Double2 third) const {
        const Double2 to_second = second - first;
        const Double2 to_third = third - first;
        return {first + to_second * splat2(b) + to_third * splat2(c),
                to_second * splat2(b_dx) + to_third * splat2(c_dx), to_second * splat2(b_dy) + to_third * splat2(c_dy)};
    }
};

Double2 pair_of(float first, float second) { return Double2{static_cast<double>(first), static_cast<double>(second)}; }

// A UV sliver can have a gradient that no float holds; it then keeps its position and normal over its few texels.
constexpr double kLargestGradient = 1e18;

void hold_finite(double& x, double& y, double& z) {
    const bool finite =
        std::fabs(x) < kLargestGradient && std::fabs(y) < kLargestGradient && std::fabs(z) < kLargestGradient;
    if (!finite) x = y = z = 0.0;
}

__attribute__((noinline)) void hold_finite(Double2& xy, Double2& z_x, Double2& yz) {
    double six[6] = {xy[0], xy[1], z_x[0], z_x[1], yz[0], yz[1]};
    hold_finite(six[0], six[1], six[2]);
    hold_finite(six[3], six[4], six[5]);
    xy = Double2{six[0], six[1]};
    z_x = Double2{six[2], six[3]};
    yz = Double2{six[4], six[5]};
}

template <int kLane>
TexelFrame::Coordinate coordinate(const CoordinatePair& pair) {
    return {static_cast<float>(pair.at[kLane]), static_cast<float>(pair.dx[kLane]), static_cast<float>(pair.dy[kLane])};
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
    const CornerWeights weights{(at_x * ac_y - at_y * ac_x) * per_area,
                                (ab_x * at_y - ab_y * at_x) * per_area,
                                ac_y * per_area,
                                -ac_x * per_area,
                                -ab_y * per_area,
                                ab_x * per_area};

    // Position and normal are six coordinates, two at a time: x and y, z and the normal's x, its y and z.
    const auto& [v0, v1, v2] = corners.vertex;
    const glm::vec3& p0 = mesh.positions[v0];
    const glm::vec3& p1 = mesh.positions[v1];
    const glm::vec3& p2 = mesh.positions[v2];
    const glm::vec3& n0 = mesh.normals[v0];
    const glm::vec3& n1 = mesh.normals[v1];
    const glm::vec3& n2 = mesh.normals[v2];
    CoordinatePair xy = weights.mix(pair_of(p0.x, p0.y), pair_of(p1.x, p1.y), pair_of(p2.x, p2.y));
    CoordinatePair z_x = weights.mix(pair_of(p0.z, n0.x), pair_of(p1.z, n1.x), pair_of(p2.z, n2.x));
    CoordinatePair yz = weights.mix(pair_of(n0.y, n0.z), pair_of(n1.y, n1.z), pair_of(n2.y, n2.z));
    // What is no number is not below it.
    const Double2 gradients = xy.gradients() + z_x.gradients() + yz.gradients();
    if (!(gradients[0] < kLargestGradient && gradients[1] < kLargestGradient)) {
        hold_finite(xy.dx, z_x.dx, yz.dx);
        hold_finite(xy.dy, z_x.dy, yz.dy);
    }
    out.position[0] = coordinate<0>(xy);
    out.position[1] = coordinate<1>(xy);
    out.position[2] = coordinate<0>(z_x);
    out.normal[0] = coordinate<1>(z_x);
    out.normal[1] = coordinate<0>(yz);
    out.normal[2] = coordinate<1>(yz);
    out.x0 = at.x;
    out.y0 = at.y;
    out.triangle = triangle;
    const double length_2 = z_x.at[1] * z_x.at[1] + yz.at[0] * yz.at[0] + yz.at[1] * yz.at[1];
    if (length_2 < 1e-12) {
        const glm::vec3 flat = mesh.flat_normal(corners);
        for (int axis = 0; axis < 3; ++axis) out.normal[axis] = {flat[axis], 0.0f, 0.0f};
    }
}

}  // namespace txc
