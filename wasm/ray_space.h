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

    /// A point of model space there. Beyond its sides if the point lies behind the eye, or all but in it.
    glm::dvec3 apply(const glm::dvec3& point) const;

    /// True where the box may touch what the space holds.
    bool may_touch(const ModelBox& box) const;

    /// How much nearer to the viewer is what lies so many metres further along the ray from q; infinite beyond the eye.
    double lift(const glm::dvec3& q, double distance) const;

    /// The ray from a point of model space, which is at q there; none of it in the volume where its length is not above 0.
    TexelRay ray_from(const glm::dvec3& point, const glm::dvec3& q, std::uint32_t own) const;

private:
    bool has_eye() const { return eye_.near_distance > 0.0; }
    double distance_of(const glm::dvec3& point) const;

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
