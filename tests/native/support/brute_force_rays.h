// What stands in a ray's way, found without a tree.
#pragma once

#include <cmath>

#include "core_mesh.h"
#include "reference_map.h"

namespace support {

/// By asking every triangle, with plane and barycentric coordinates. `unsure` where a border or a bound is near.
struct BruteForce {
    const txc::Mesh& mesh;
    double least;

    bool is_blocked(const Vec3& origin, const Vec3& direction, double reach, std::uint32_t own, bool& unsure) const {
        bool blocked = false;
        unsure = false;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (t == own) continue;
            Vec3 corners[3];
            for (int c = 0; c < 3; ++c) {
                const glm::vec3 p = mesh.positions[mesh.triangles[t].vertex[c]];
                corners[c] = {p.x, p.y, p.z};
            }
            const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double slope = dot(normal, direction);
            if (std::fabs(slope) < 1e-12) continue;
            const double distance = dot(normal, corners[0] - origin) / slope;
            if (!(distance > least * 0.9 && distance < reach * 1.01)) continue;
            const Vec3 hit = origin + direction * distance;
            double lowest = 1.0;
            for (int c = 0; c < 3; ++c) {
                const Vec3 edge = cross(corners[(c + 1) % 3] - corners[c], hit - corners[c]);
                lowest = std::fmin(lowest, dot(edge, normal) / dot(normal, normal));
            }
            if (lowest < -1e-6) continue;
            if (lowest < 1e-6 || std::fabs(distance - least) < least * 1e-3 || std::fabs(distance - reach) < 1e-6)
                unsure = true;
            if (distance > least && distance <= reach) blocked = true;
        }
        return blocked;
    }
};

}  // namespace support
