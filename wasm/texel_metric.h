// How long and how wide a texel lies on the surface: the first fundamental form of texture space, a texel as its unit.
// Over a frame it is constant.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "texel_frame.h"

namespace txc {

struct TexelMetric {
    double across = 0.0;  // squared length of a texel to the right, square metres
    double skew = 0.0;    // product of a texel to the right and a texel down
    double down = 0.0;    // squared length of a texel down

    static TexelMetric of(const TexelFrame& frame) {
        const glm::dvec3 dx(TexelFrame::part(frame.position, &TexelFrame::Coordinate::dx));
        const glm::dvec3 dy(TexelFrame::part(frame.position, &TexelFrame::Coordinate::dy));
        return {glm::dot(dx, dx), glm::dot(dx, dy), glm::dot(dy, dy)};
    }

    /// Of two ways in texels, as they lie on the surface.
    double dot(const glm::dvec2& a, const glm::dvec2& b) const {
        return across * a.x * b.x + skew * (a.x * b.y + a.y * b.x) + down * a.y * b.y;
    }
    double determinant() const { return across * down - skew * skew; }
    /// A texel's, square metres.
    double area() const { return std::sqrt(std::fmax(determinant(), 0.0)); }
    /// Metres of the longest way that is one unit in texture space.
    double longest() const { return std::sqrt(0.5 * (across + down + spread())); }
    /// And of the shortest: by the area, as the difference would cancel where the two are far apart.
    double shortest() const {
        const double most = longest();
        return most > 0.0 ? area() / most : 0.0;
    }

    /// The same surface with other units: `a` and `b` are a texel to the right and a texel down in them. False where
    /// they lie on one line.
    bool in_units_of(const glm::dvec2& a, const glm::dvec2& b, TexelMetric& out) const {
        const double det = a.x * b.y - a.y * b.x;
        if (det == 0.0) return false;
        // A unit to the right and a unit down, in texels.
        const glm::dvec2 right(b.y / det, -a.y / det);
        const glm::dvec2 below(-b.x / det, a.x / det);
        out = {dot(right, right), dot(right, below), dot(below, below)};
        return true;
    }

private:
    double spread() const { return std::sqrt((across - down) * (across - down) + 4.0 * skew * skew); }
};

}  // namespace txc
