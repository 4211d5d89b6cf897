// Where a product may be printed: a part of its texture, or the surface inside a box that faces the box's +Z.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "local_space_map.h"
#include "projector_pose.h"
#include "status.h"
#include "texel_metric.h"

namespace txc {

/// A texel as zones ask about it.
struct ZoneTexel {
    glm::dvec2 place{0.0};  // its centre, texels of the whole texture
    glm::dvec2 size{0.0};   // of the whole texture, texels
    TexelMetric metric;
    glm::dvec3 position{0.0};  // model space
    glm::dvec3 normal{0.0};    // unit
};

struct PrintZone {
    std::uint32_t material = 0;
    bool is_box = false;
    std::vector<glm::dvec2> corners;  // u and v
    ProjectorPose pose;               // of a box
    glm::dvec3 half{0.5};
    double safe = 0.0;   // metres of the surface
    double bleed = 0.0;  // metres of the surface

    /// `corners`: u and v, all zones'. BAD_ARGUMENT names zone and field.
    static TxcStatus from_def(const TxcZone& def, std::uint32_t index, const float* corners, std::uint32_t corner_count,
                              PrintZone& out);

    /// Metres along the surface from the texel's centre to the zone's edge, above 0 inside. The surface counts as flat from
    /// here to there, and as this texel stretches it.
    double inset(const ZoneTexel& texel) const;
};

/// How much of a texel lies in the zone, its bleed included, 0 to 1: a ramp as wide as a texel. Gutter texels go with
/// their chart, which ends where they begin.
double zone_cover(const PrintZone& zone, const ZoneTexel& texel, double gutter);

/// A texel of a map, for zones.
ZoneTexel zone_texel(const LocalSpaceMap& map, const TexelRun& run, std::uint32_t x, std::uint32_t y,
                     const TexelMetric& metric);

}  // namespace txc
