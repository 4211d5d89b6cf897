// A space in which all of a decal's rays run along +Z, side by side, and what is straight or flat still is: there a triangle hides
// what it covers. A planar decal's own is one. For an eye it is the picture that the eye sees, with a share of 1 / distance for depth:
// a projective map takes lines to lines and planes to planes.
#pragma once

#include "occlusion.h"
#include "perspective_projector.h"
#include "projector.h"

namespace txc {

class RaySpace {
public:
    // Texels whose centre lies a little outside the picture still take paint (their footprint reaches in), so the space goes that far
    // on each side. Its depths that matter are those from -1/2 to 1/2.
    static constexpr double kHalfSide = 0.5625;

    explicit RaySpace(const PlanarProjector& projector);
    /// `model`: the bounds of all that there is to see.
    RaySpace(const PerspectiveProjector& projector, const Bounds& model);

    /// Whether rays of both are the same ones.
    bool is_same(const RaySpace& other) const;

    /// Whether the rays go to an eye.
    bool has_eye() const { return eye_.near_distance > 0.0; }

    /// A point of model space there. Infinite if the point lies behind the eye, or all but in it.
    glm::dvec3 apply(const glm::dvec3& point) const {
        glm::dvec3 q = to_space_.apply(point);
        if (has_eye()) divide(&point, &q, 1);
        return q;
    }
    /// Three at once.
    void apply(const glm::dvec3 (&points)[3], glm::dvec3 (&out)[3]) const {
        for (int i = 0; i < 3; ++i) out[i] = to_space_.apply(points[i]);
        if (has_eye()) divide(points, out, 3);
    }

    /// True where the box may touch what the space holds.
    bool may_touch(const ModelBox& box) const;

    /// How much nearer to the viewer is what lies so many metres further along the ray from q; infinite beyond the eye.
    double lift(const glm::dvec3& q, double distance) const {
        return has_eye() ? lift_to_eye(q.x, q.y, q.z, distance) : distance / depth_;
    }
    /// The least of that over a triangle's corners (of four, the last is the first again), were all of them so deep.
    double least_lift(const double (&x)[4], const double (&y)[4], double z, double distance) const {
        return has_eye() ? least_lift_to_eye(x, y, z, distance) : distance / depth_;
    }

    /// The ray from a point of model space, which is at q there; none of it in the volume where its length is not above 0.
    TexelRay ray_from(const glm::dvec3& point, const glm::dvec3& q, std::uint32_t own) const;

private:
    // What takes its time, or has nothing to do with planar decals, stays out of their loops, which a call costs 4 % of a drag.
    void divide(const glm::dvec3* points, glm::dvec3* out, int count) const;
    double lift_to_eye(double x, double y, double z, double distance) const;
    double least_lift_to_eye(const double (&x)[4], const double (&y)[4], double z, double distance) const;

    ModelToDecal to_space_;  // of an eye: times the distance
    // The planar one's rays.
    glm::dvec3 towards_viewer_{0.0};
    double depth_ = 0.0;
    // The perspective one's. Nearness there is shift + scale / distance.
    PerspectiveProjector eye_;
    double shift_ = 0.0;
    double scale_ = 0.0;
};

}  // namespace txc
