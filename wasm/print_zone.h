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
    glm::dvec3 position{0.0};  // model space; for boxes alone
    glm::dvec3 normal{0.0};    // unit; for boxes alone
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
};

/// A zone as texels ask about it that lie near each other: of a polygon's edges, the nearest first and seldom all.
/// (All of them for each texel: a zone of 220 corners took as long as everything else of opening its target.)
class ZoneLook {
public:
    /// The zone must outlive it.
    explicit ZoneLook(const PrintZone& zone) : zone_(&zone) {}

    const PrintZone& zone() const { return *zone_; }

    /// Metres along the surface from the texel's centre to the zone's edge, above 0 inside. The surface counts as flat from
    /// here to there, and as this texel stretches it.
    double inset(const ZoneTexel& texel);

    /// How much of a texel lies in the zone, its bleed included, 0 to 1: a ramp as wide as a texel. Gutter texels go with
    /// their chart, which ends where they begin.
    double cover(const ZoneTexel& texel, double gutter);

private:
    struct Edge {
        glm::dvec2 from, way;  // texels
        double to_y;           // of its end: the next edge begins at the very same
    };

    void come_to_block_of(const ZoneTexel& texel);
    double polygon_inset(const ZoneTexel& texel);
    double box_inset(const ZoneTexel& texel) const;

    const PrintZone* zone_;
    glm::dvec2 block_{-1.0};              // of kBlock x kBlock texels, counted from the texture's corner
    glm::dvec2 size_{0.0};                // the texture's, that the edges are in
    std::vector<Edge> edges_;             // in the size, corner by corner
    std::vector<std::uint64_t> nearest_;  // the edges' distances to the block above their places, ascending
    std::vector<Edge> crossing_;          // those that reach into the block's rows
};

/// Looks at several zones, in their order.
std::vector<ZoneLook> looks_at(const std::vector<PrintZone>& zones);
/// Whether one of them asks for a texel's place in space.
bool any_is_box(const std::vector<ZoneLook>& looks);

/// A texel of a map, for zones. `in_space`: boxes are among them.
ZoneTexel zone_texel(const LocalSpaceMap& map, const TexelRun& run, std::uint32_t x, std::uint32_t y,
                     const TexelMetric& metric, bool in_space);

}  // namespace txc
