#include "print_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sorted_keys.h"

namespace txc {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// Faces of a box that the surface runs along within this sine are no edge of the zone there.
constexpr double kAlong = 1e-6;

/// Texels of a block's side, and from its centre to its furthest texel's, with room for rounding.
constexpr double kBlock = 16.0;
constexpr double kBlockRadius = 12.0;
/// Distances to a block are rounded down to steps, texels.
constexpr double kDistanceStep = 1.0 / 64.0;
constexpr double kMostSteps = 4294967295.0;
/// A bound that is compared leaves room for rounding: an edge too many is looked at, never one too few.
constexpr double kBound = 1.0 - 1e-9;

double share_of(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

}  // namespace

TxcStatus PrintZone::from_def(const TxcZone& def, std::uint32_t index, const float* corners, std::uint32_t corner_count,
                              PrintZone& out) {
    out.material = def.material;
    out.is_box = def.kind == TXC_ZONE_BOX;
    if (def.kind >= TXC_ZONE_KIND_COUNT)
        return fail(TXC_STATUS_BAD_ARGUMENT, "zone %u: kind is %u; there are %d", index, def.kind, TXC_ZONE_KIND_COUNT);
    for (const float margin : {def.safe, def.bleed}) {
        if (!(margin >= 0.0f && margin <= kMaxCoordinate)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "zone %u: a margin is %g; it must be 0 or above", index,
                        static_cast<double>(margin));
        }
    }
    out.safe = static_cast<double>(def.safe);
    out.bleed = static_cast<double>(def.bleed);
    if (out.is_box) {
        TxcLayerDef pose{};
        std::copy(std::begin(def.position_model), std::end(def.position_model), std::begin(pose.position_model));
        std::copy(std::begin(def.rotation), std::end(def.rotation), std::begin(pose.rotation));
        if (const TxcStatus status = ProjectorPose::from_def(pose, glm::vec3(0.0f), out.pose); status != TXC_STATUS_OK)
            return status;
        for (int c = 0; c < 3; ++c) {
            if (const TxcStatus status = check_length(def.size[c], "a zone's size"); status != TXC_STATUS_OK)
                return status;
            out.half[c] = 0.5 * static_cast<double>(def.size[c]);
        }
        return TXC_STATUS_OK;
    }
    if (def.corner_count < 3 || def.first_corner > corner_count || def.corner_count > corner_count - def.first_corner) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "zone %u: corners %u to %u; there are %u, and a polygon has 3 or more",
                    index, def.first_corner, def.first_corner + def.corner_count, corner_count);
    }
    for (std::uint32_t c = def.first_corner; c < def.first_corner + def.corner_count; ++c) {
        const glm::dvec2 corner(static_cast<double>(corners[c * 2]), static_cast<double>(corners[c * 2 + 1]));
        if (!(std::fabs(corner.x) <= 1e6 && std::fabs(corner.y) <= 1e6))
            return fail(TXC_STATUS_BAD_ARGUMENT, "zone %u: corner %u is not finite", index, c);
        out.corners.push_back(corner);
    }
    return TXC_STATUS_OK;
}

double ZoneLook::inset(const ZoneTexel& texel) { return zone_->is_box ? box_inset(texel) : polygon_inset(texel); }

double ZoneLook::cover(const ZoneTexel& texel, double gutter) {
    const double beyond = inset(texel) + zone_->bleed;
    const double side = std::sqrt(texel.metric.area());
    if (!(side > 0.0)) return beyond >= 0.0 ? 1.0 : 0.0;
    return std::clamp(0.5 + beyond / side + gutter, 0.0, 1.0);
}

double ZoneLook::box_inset(const ZoneTexel& texel) const {
    const glm::dvec3 at = zone_->pose.to_view(texel.position);
    const glm::dvec3 normal = zone_->pose.turn_to_view(texel.normal);
    if (!(normal.z > 0.0)) return -kFar;
    double nearest = kFar;
    for (int c = 0; c < 3; ++c) {
        const double depth = zone_->half[c] - std::fabs(at[c]);
        // How fast one comes nearer to the face on the surface; a face that it runs along is never met.
        const double slope = std::sqrt(std::max(1.0 - normal[c] * normal[c], 0.0));
        nearest = std::min(nearest, slope > kAlong ? depth / slope : depth < 0.0 ? -kFar : kFar);
    }
    return nearest;
}

void ZoneLook::come_to_block_of(const ZoneTexel& texel) {
    const glm::dvec2 block = glm::floor(texel.place / kBlock);
    if (block == block_ && texel.size == size_) return;
    block_ = block;
    size_ = texel.size;
    edges_.clear();
    nearest_.clear();
    crossing_.clear();
    const glm::dvec2 centre = (block + 0.5) * kBlock;
    const std::vector<glm::dvec2>& corners = zone_->corners;
    glm::dvec2 from = corners.back() * size_;
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
        const glm::dvec2 to = corners[c] * size_;
        const Edge edge{from, to - from, to.y};
        const glm::dvec2 left =
            centre - from - edge.way * share_of(glm::dot(centre - from, edge.way), glm::dot(edge.way, edge.way));
        const double distance = std::max(glm::length(left) * kBound - kBlockRadius, 0.0);
        nearest_.push_back(static_cast<std::uint64_t>(std::min(kMostSteps, distance / kDistanceStep)) << 32 | c);
        edges_.push_back(edge);
        if (std::max(from.y, to.y) >= centre.y - kBlock && std::min(from.y, to.y) <= centre.y + kBlock)
            crossing_.push_back(edge);
        from = to;
    }
    sort_keys(nearest_);
}

double ZoneLook::polygon_inset(const ZoneTexel& texel) {
    come_to_block_of(texel);
    bool inside = false;
    for (const Edge& edge : crossing_) {
        const glm::dvec2 way = texel.place - edge.from;
        if ((edge.from.y > texel.place.y) != (edge.to_y > texel.place.y) && way.x < edge.way.x * way.y / edge.way.y)
            inside = !inside;
    }
    // A texel's way is at least this long on the surface.
    const double shortest = texel.metric.shortest() * kBound;
    double nearest = kFar;
    for (const std::uint64_t key : nearest_) {
        const double least = static_cast<double>(key >> 32) * kDistanceStep * shortest;
        if (least * least > nearest) break;
        const Edge& edge = edges_[static_cast<std::uint32_t>(key)];
        const glm::dvec2 way = texel.place - edge.from;
        const double share = share_of(texel.metric.dot(way, edge.way), texel.metric.dot(edge.way, edge.way));
        const glm::dvec2 left = way - edge.way * share;
        nearest = std::min(nearest, texel.metric.dot(left, left));
    }
    const double distance = std::sqrt(std::max(nearest, 0.0));
    return inside ? distance : -distance;
}

std::vector<ZoneLook> looks_at(const std::vector<PrintZone>& zones) {
    return std::vector<ZoneLook>(zones.begin(), zones.end());
}

bool any_is_box(const std::vector<ZoneLook>& looks) {
    return std::any_of(looks.begin(), looks.end(), [](const ZoneLook& look) { return look.zone().is_box; });
}

ZoneTexel zone_texel(const LocalSpaceMap& map, const TexelRun& run, std::uint32_t x, std::uint32_t y,
                     const TexelMetric& metric, bool in_space) {
    const MapKey& key = map.key;
    ZoneTexel texel{{x + key.origin_x + 0.5, y + key.origin_y + 0.5},
                    {static_cast<double>(key.texture_width()), static_cast<double>(key.texture_height())},
                    metric};
    if (!in_space) return texel;
    const auto column = static_cast<std::int32_t>(x);
    const auto row = static_cast<std::int32_t>(y);
    texel.position = glm::dvec3(map.origin) + glm::dvec3(map.frames[run.frame].position_at(column, row));
    texel.normal = glm::dvec3(map.unit_normal(run, column, row));
    return texel;
}

}  // namespace txc
