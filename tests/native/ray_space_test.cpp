// In an eye's picture its rays run side by side, and what hides a texel is what covers it there.
#include "ray_space.h"

#include <doctest/doctest.h>

#include <cmath>

#include "occluder_grid.h"
#include "support/brute_force_rays.h"
#include "support/projector_defs.h"

using namespace support;

TEST_CASE("A slide's grid of occluders answers as rays to the eye do, unless triangles reach behind it") {
    Random random(73);
    txc::MemoryBudget budget(1u << 28);
    std::uint32_t blocked_count = 0;
    std::uint32_t compared = 0;
    std::uint32_t whole = 0;
    for (int round = 0; round < 30; ++round) {
        const txc::Mesh mesh =
            make_core_mesh(make_random_triangles(random, 2 + random.below(600), 1.0, round % 3 == 0 ? 0.6 : 0.1));
        txc::OcclusionTree tree(budget);
        must(tree.build(mesh));
        TxcLayerDef def = perspective_def(0, random.between(5, 100), random.between(0.5, 2.0),
                                          random.between(0.02, 1.0), random.between(1.5, 6.0));
        const double away = round % 2 == 0 ? 3.0 : 0.6;  // every other eye amid the triangles
        place(def, random.between(-away, away), random.between(-away, away), random.between(-away, away));
        look_at(def, random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.4, 0.4));
        txc::PerspectiveProjector projector;
        must(txc::PerspectiveProjector::from_def(def, glm::vec3(0.0f), projector));
        txc::OccluderGrid grid(mesh, tree, txc::RaySpace(projector, mesh.bounds), budget);
        must(grid.build());
        if (!grid.is_whole()) continue;
        ++whole;
        const BruteForce brute{mesh, tree.least_distance()};
        std::vector<std::uint32_t> blockers;
        for (int texel = 0; texel < 400; ++texel) {
            // On a triangle, in the volume and a little outside of its sides.
            const std::uint32_t own = random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
            const auto corner = [&](int i) { return glm::dvec3(mesh.positions[mesh.triangles[own].vertex[i]]); };
            const double b = random.between(0.02, 0.97);
            const double c = random.between(0.02, 0.98 - 0.98 * b);
            const glm::dvec3 p = corner(0) * (1.0 - b - c) + corner(1) * b + corner(2) * c;
            const glm::dvec3 seen = projector.pose.to_view(p);
            if (!(-seen.z >= projector.near_distance && -seen.z <= projector.far_distance)) continue;
            if (std::fabs(seen.x / seen.z * projector.scale_x) > 0.7) continue;
            if (std::fabs(seen.y / seen.z * projector.scale_y) > 0.7) continue;
            glm::dvec3 towards;
            double reach = 0.0;
            if (!projector.ray_from(seen, towards, reach)) continue;
            towards = projector.pose.turn_to_model(towards);
            bool unsure = false;
            const bool expected =
                brute.is_blocked({p.x, p.y, p.z}, {towards.x, towards.y, towards.z}, reach, own, unsure);
            if (unsure) continue;
            CHECK_UNARY(grid.is_blocked(p, own) == expected);
            if (grid.find_blockers(own, blockers)) CHECK_UNARY(grid.is_blocked_by(blockers, p, own) == expected);
            blocked_count += expected ? 1 : 0;
            ++compared;
        }
    }
    CHECK(compared > 1500);
    CHECK(blocked_count > 300);
    CHECK(whole > 10);
    CHECK(whole < 28);
    CHECK(budget.used() == 0);
}

TEST_CASE("From the eye of a slide a surface without folds hides nothing of itself, and asks nobody") {
    const txc::Mesh mesh = make_core_mesh(make_sphere(0.6, 48, 24));
    txc::MemoryBudget budget(1u << 28);
    txc::OcclusionTree tree(budget);
    must(tree.build(mesh));
    TxcLayerDef def = perspective_def(0, 40, 1, 0.1, 9);
    place(def, 0.7, 0.4, 2.0);
    look_at(def, 0, 0, 0);
    txc::PerspectiveProjector projector;
    must(txc::PerspectiveProjector::from_def(def, glm::vec3(0.0f), projector));
    txc::OccluderGrid grid(mesh, tree, txc::RaySpace(projector, mesh.bounds), budget);
    must(grid.build());
    REQUIRE(grid.is_whole());
    int faces = 0;
    int asks = 0;
    std::vector<std::uint32_t> blockers;
    for (std::uint32_t own = 0; own < mesh.triangles.size(); ++own) {
        const auto corner = [&](int i) { return glm::dvec3(mesh.positions[mesh.triangles[own].vertex[i]]); };
        const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        if (glm::dot(normal, projector.pose.position - corner(0)) <= 0.0) continue;
        ++faces;
        asks += grid.find_blockers(own, blockers) && blockers.empty() ? 0 : 1;
    }
    CHECK(faces > 500);
    CHECK(asks == 0);
}
