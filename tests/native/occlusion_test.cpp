// A texel is painted only if no other triangle stands between it and the front of the volume (spec section 4, test 4).
#include "occlusion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "occluder_grid.h"
#include "support/allocation_meter.h"
#include "support/brute_force_rays.h"

using namespace support;

namespace {

glm::dvec3 to_glm(const Vec3& v) { return {v.x, v.y, v.z}; }

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

/// Paints the whole front of a shape from +Z; the first material is the target.
Picture paint_front(TestSession& session, TxcTarget target, double depth, std::uint32_t occlusion, double z = 0.0) {
    session.set_base(target, kBase);
    TxcLayerDef def = decal_def(session.image(Picture(1, 1, kPaint)));
    def.filter = TXC_FILTER_NEAREST;
    def.occlusion = occlusion;
    resize(def, 4, 4, depth);
    place(def, 0, 0, z);
    session.layer(target, def);
    return session.paint(target);
}

}  // namespace

TEST_CASE("The tree finds what a search of all triangles finds") {
    Random random(70);
    txc::MemoryBudget budget(1u << 28);
    std::uint32_t blocked_count = 0;
    std::uint32_t free_count = 0;
    for (int round = 0; round < 12; ++round) {
        const std::uint32_t count = round == 0 ? 1 : 5 + random.below(400);
        const txc::Mesh mesh = make_core_mesh(make_random_triangles(random, count, 1.0, round % 2 == 0 ? 0.1 : 0.5));
        txc::OcclusionTree tree(budget);
        must(tree.build(mesh));
        const BruteForce brute{mesh, tree.least_distance()};
        for (int ray = 0; ray < 300; ++ray) {
            const Vec3 origin{random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(-1.5, 1.5)};
            Vec3 direction{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
            // Along the axes too, where a ray runs inside the faces of boxes.
            if (ray % 5 == 0) direction = ray % 2 == 0 ? Vec3{0, 0, 1} : Vec3{-1, 0, 0};
            direction = unit(direction);
            const double reach = random.between(0.01, 3.0);
            const std::uint32_t own = random.below(count);
            bool unsure = false;
            const bool expected = brute.is_blocked(origin, direction, reach, own, unsure);
            if (unsure) continue;
            CHECK_UNARY(tree.is_blocked({to_glm(origin), to_glm(direction), reach, own}) == expected);
            ++(expected ? blocked_count : free_count);
        }
    }
    CHECK(blocked_count > 400);
    CHECK(free_count > 400);
}

TEST_CASE("Rays that are asked for together are blocked as each alone is, be there few triangles near them or many") {
    Random random(71);
    txc::MemoryBudget budget(1u << 28);
    std::uint32_t blocked_count = 0;
    std::uint32_t free_count = 0;
    for (const std::uint32_t count : {1u, 40u, 4000u}) {
        const txc::Mesh mesh = make_core_mesh(make_random_triangles(random, count, 1.0, count < 100 ? 0.5 : 0.05));
        txc::OcclusionTree tree(budget);
        must(tree.build(mesh));
        for (int round = 0; round < 20; ++round) {
            const glm::dvec3 eye(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3));
            const glm::dvec3 middle(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
            std::vector<std::uint16_t> texels(256 * 4, 1);
            std::vector<txc::TexelRay> rays;
            for (std::size_t i = 0; i < 256; ++i) {
                // Some of them on one line, as a tile's row is.
                const double down = round % 3 == 0 ? 0.0 : random.between(-0.2, 0.2);
                const glm::dvec3 origin = middle + glm::dvec3(random.between(-0.2, 0.2), down, 0.0);
                const double distance = glm::length(eye - origin);
                rays.push_back({origin, (eye - origin) / distance, distance * random.between(0.2, 1.0),
                                random.below(count), texels.data() + i * 4});
            }
            tree.clear_blocked(rays.data(), rays.data() + rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const bool expected = tree.is_blocked(rays[i]);
                CHECK_UNARY((texels[i * 4] == 0) == expected);
                CHECK_UNARY(texels[i * 4 + 3] == texels[i * 4]);
                ++(expected ? blocked_count : free_count);
            }
        }
    }
    CHECK(blocked_count > 400);
    CHECK(free_count > 400);
}

TEST_CASE("Flat and axis-aligned triangles do not fall between the boxes") {
    Shape shape;
    for (int i = 0; i < 64; ++i) shape.append(make_plane(0.1 + 0.02 * (i % 5), i * 0.125));
    const txc::Mesh mesh = make_core_mesh(shape);
    txc::MemoryBudget budget(1u << 28);
    txc::OcclusionTree tree(budget);
    must(tree.build(mesh));
    for (int i = 0; i < 63; ++i) {
        const glm::dvec3 origin(0.01, 0.02, i * 0.125);
        CHECK_UNARY(tree.is_blocked({origin, {0, 0, 1}, 0.2, 0xffffffffu}));
        CHECK_UNARY(!tree.is_blocked({origin, {0, 0, 1}, 0.1, 0xffffffffu}));
    }
}

TEST_CASE("A wall hides along its joints from rays that do not move along an axis") {
    // Four plates that meet in the middle, enough of them for boxes that end there.
    Shape wall;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) wall.append(moved(make_plane(2.0, 0.5), x, y, 0));
    }
    for (int i = 0; i < 60; ++i) wall.append(moved(make_plane(0.1, 3.0), 5.0 + i, 5.0, 0));
    const txc::Mesh mesh = make_core_mesh(wall);
    txc::MemoryBudget budget(1u << 28);
    txc::OcclusionTree tree(budget);
    must(tree.build(mesh));
    const double slant = 0.6;
    for (int i = -8; i <= 8; ++i) {
        const double at = i * 0.1;
        for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(slant, 0, 0.8), glm::dvec3(-slant, 0, 0.8)})
            CHECK_UNARY(tree.is_blocked({{at, 0, 0}, direction, 2.0, 0xffffffffu}));
        for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(0, slant, 0.8), glm::dvec3(0, -slant, 0.8)})
            CHECK_UNARY(tree.is_blocked({{0, at, 0}, direction, 2.0, 0xffffffffu}));
    }
}

TEST_CASE("Many triangles on one spot make a tree of bounded depth") {
    Shape shape;
    for (int i = 0; i < 3000; ++i) shape.append(make_plane(1.0, 0.5));
    shape.append(make_plane(1.0, 1.0));
    const txc::Mesh mesh = make_core_mesh(shape);
    txc::MemoryBudget budget(1u << 28);
    txc::OcclusionTree tree(budget);
    must(tree.build(mesh));
    CHECK(tree.is_blocked({{0.1, 0.2, 0.0}, {0, 0, 1}, 2.0, 0}));
    CHECK_FALSE(tree.is_blocked({{0.1, 0.2, 0.0}, {0, 0, 1}, 0.4, 0}));
    CHECK_FALSE(tree.is_blocked({{0.1, 0.2, 1.0}, {0, 0, 1}, 2.0, 0}));
}

TEST_CASE("A decal's grid of occluders answers as the tree's rays do") {
    Random random(71);
    txc::MemoryBudget budget(1u << 28);
    std::uint32_t blocked_count = 0;
    std::uint32_t compared = 0;
    for (int round = 0; round < 24; ++round) {
        const txc::Mesh mesh =
            make_core_mesh(make_random_triangles(random, 2 + random.below(600), 1.0, round % 3 == 0 ? 0.6 : 0.1));
        txc::OcclusionTree tree(budget);
        must(tree.build(mesh));
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
        resize(def, random.between(0.2, 2.5), random.between(0.2, 2.5), random.between(0.2, 2.5));
        const txc::PlanarProjector projector = make_projector(def);
        txc::OccluderGrid grid(mesh, tree, txc::RaySpace(projector), budget);
        must(grid.build());
        const BruteForce brute{mesh, tree.least_distance()};
        const Vec3 towards{projector.towards_viewer.x, projector.towards_viewer.y, projector.towards_viewer.z};
        const glm::dmat3 to_model = glm::inverse(projector.to_decal.matrix);
        for (int texel = 0; texel < 150; ++texel) {
            // In the volume, and a little outside its sides, where a footprint still reaches in.
            const glm::dvec3 q(random.between(-0.7, 0.7), random.between(-0.7, 0.7), random.between(-0.5, 0.5));
            const glm::dvec3 p = to_model * (q - projector.to_decal.offset);
            const std::uint32_t own = random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
            bool unsure = false;
            const bool expected =
                brute.is_blocked({p.x, p.y, p.z}, towards, (0.5 - q.z) * projector.depth, own, unsure);
            if (unsure) continue;
            CHECK_UNARY(grid.is_blocked(p, own) == expected);
            blocked_count += expected ? 1 : 0;
            ++compared;
        }
    }
    CHECK(compared > 3000);
    CHECK(blocked_count > 500);
    CHECK(budget.used() == 0);
}

TEST_CASE("A triangle's blockers are all that ever hide a point of it, and a surface without folds has none") {
    Shape folded = make_sphere(0.6, 14, 7);
    folded.append(moved(make_cylinder(0.3, 1.4, 12), 0.3, 0.1, 0.4));
    const txc::Mesh mesh = make_core_mesh(folded);
    txc::MemoryBudget budget(1u << 28);
    txc::OcclusionTree tree(budget);
    must(tree.build(mesh));
    Random random(62);
    int blocked_count = 0;
    int clear_count = 0;
    for (int round = 0; round < 20; ++round) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, random.between(-0.3, 0.3), random.between(-0.3, 0.3), random.between(-0.3, 0.3));
        resize(def, random.between(1.0, 3.0), random.between(1.0, 3.0), random.between(1.0, 3.0));
        const txc::PlanarProjector projector = make_projector(def);
        txc::OccluderGrid grid(mesh, tree, txc::RaySpace(projector), budget);
        must(grid.build());
        std::vector<std::uint32_t> blockers;
        for (std::uint32_t own = 0; own < mesh.triangles.size(); ++own) {
            if (!grid.find_blockers(own, blockers)) continue;
            clear_count += blockers.empty() ? 1 : 0;
            for (int point = 0; point < 6; ++point) {
                const double b = random.between(0.02, 0.97);
                const double c = random.between(0.02, 1.0 - b);
                if (b + c > 0.98) continue;
                const auto corner = [&](int i) { return glm::dvec3(mesh.positions[mesh.triangles[own].vertex[i]]); };
                const glm::dvec3 p = corner(0) * (1.0 - b - c) + corner(1) * b + corner(2) * c;
                const glm::dvec3 q = projector.to_decal.apply(p);
                if (std::fabs(q.x) > 0.5 || std::fabs(q.y) > 0.5 || std::fabs(q.z) > 0.5) continue;
                const bool blocked = grid.is_blocked(p, own);
                CHECK_UNARY(grid.is_blocked_by(blockers, p, own) == blocked);
                blocked_count += blocked ? 1 : 0;
            }
        }
    }
    CHECK(blocked_count > 500);
    CHECK(clear_count > 500);
}

TEST_CASE("A plate before another hides it, and paint goes through it where that is asked for") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(0.5, 0.3), 1);  // another material, and still in the way
    const TxcTarget target = session.target(64, 64);
    const Picture hidden = paint_front(session, target, 1.0, TXC_OCCLUSION_SELF);
    CHECK(hidden.at(32, 32) == kBase);
    CHECK(hidden.at(17, 32) == kBase);
    CHECK(hidden.at(15, 32) == kPaint);
    CHECK(hidden.at(4, 60) == kPaint);
    TestSession through;
    through.add(make_plane(1.0, 0.0), 0);
    through.add(make_plane(0.5, 0.3), 1);
    const TxcTarget all = through.target(64, 64);
    CHECK(paint_front(through, all, 1.0, TXC_OCCLUSION_NONE) == Picture(64, 64, kPaint));
}

/// A shape turned by a layer's rotation, about the origin.
Shape turned_by(Shape shape, const float (&rotation)[4]) {
    const glm::dquat turn(rotation[3], rotation[0], rotation[1], rotation[2]);
    for (std::vector<float>* list : {&shape.positions, &shape.normals}) {
        for (std::size_t i = 0; i < list->size(); i += 3) {
            const glm::dvec3 to = turn * glm::dvec3((*list)[i], (*list)[i + 1], (*list)[i + 2]);
            for (int axis = 0; axis < 3; ++axis) (*list)[i + axis] = static_cast<float>(to[axis]);
        }
    }
    return shape;
}

TEST_CASE(
    "A copy before a surface hides it along the edges too, which lie upon one another, whichever way all is turned") {
    Random random(71);
    for (int round = 0; round < 24; ++round) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        TestSession session;
        session.add(turned_by(make_plane(1.0, 0.0), def.rotation), 0);
        session.add(turned_by(make_plane(1.2, 0.1), def.rotation), 1);
        const TxcTarget target = session.target(64, 64);
        session.set_base(target, kBase);
        def.image = session.image(Picture(1, 1, kPaint));
        def.filter = TXC_FILTER_NEAREST;
        def.occlusion = TXC_OCCLUSION_SELF;
        resize(def, 4, 4, 1);
        session.layer(target, def);
        CHECK(session.paint(target) == Picture(64, 64, kBase));
    }
}

TEST_CASE("A plate behind hides nothing") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(0.5, -0.3), 1);
    CHECK(paint_front(session, session.target(32, 32), 1.0, TXC_OCCLUSION_SELF) == Picture(32, 32, kPaint));
}

TEST_CASE("A plate before the volume hides nothing: the decal begins behind it") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(0.5, 0.3), 1);
    CHECK(paint_front(session, session.target(32, 32), 0.5, TXC_OCCLUSION_SELF) == Picture(32, 32, kPaint));
    TestSession deeper;
    deeper.add(make_plane(1.0, 0.0), 0);
    deeper.add(make_plane(0.5, 0.3), 1);
    CHECK(paint_front(deeper, deeper.target(32, 32), 0.7, TXC_OCCLUSION_SELF).at(16, 16) == kBase);
}

TEST_CASE("A back face hides as a front does") {
    Shape turned = make_plane(0.5, 0.3);
    for (std::size_t i = 0; i < turned.indices.size(); i += 3) std::swap(turned.indices[i], turned.indices[i + 1]);
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(turned, 1);
    CHECK(paint_front(session, session.target(32, 32), 1.0, TXC_OCCLUSION_SELF).at(16, 16) == kBase);
}

TEST_CASE("A twin that lies upon the surface, and a seam, hide nothing") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(1.0, 0.0), 1);
    session.add(make_plane(1.0, 1e-5), 1);
    CHECK(paint_front(session, session.target(32, 32), 1.0, TXC_OCCLUSION_SELF) == Picture(32, 32, kPaint));
}

TEST_CASE("A convex shape never hides itself") {
    for (const bool occlusion : {true, false}) {
        TestSession session(make_sphere(1.0, 32, 16));
        const TxcTarget target = session.target(96, 64);
        const Picture painted = paint_front(session, target, 4.0, occlusion ? TXC_OCCLUSION_SELF : TXC_OCCLUSION_NONE);
        static Picture first;
        if (occlusion) {
            first = painted;
            CHECK(count_color(painted, kPaint) > 1500);
        } else {
            CHECK(count_differences(first, painted) == 0);
        }
    }
}

TEST_CASE("A cube's back does not take the paint of its front") {
    // Painted from +Z through the whole cube: its back faces away, and inside the cube nothing shows.
    Shape inside_out = make_cube();
    for (std::size_t i = 0; i < inside_out.indices.size(); i += 3)
        std::swap(inside_out.indices[i], inside_out.indices[i + 1]);
    TestSession session(inside_out);
    const TxcTarget target = session.target(96, 64, 0);
    const ReferenceMap map(inside_out, 96, 64);
    const Picture painted = paint_front(session, target, 3.0, TXC_OCCLUSION_SELF);
    // Inside out, the far wall faces the viewer, but the near wall stands before it.
    CHECK(painted == Picture(96, 64, kBase));
    TestSession again(inside_out);
    const TxcTarget open = again.target(96, 64, 0);
    const Picture through = paint_front(again, open, 3.0, TXC_OCCLUSION_NONE);
    CHECK(count_color(through, kPaint) > 400);
}

TEST_CASE("The gutter at an inner corner is painted, though the neighbour stands before its continued plane") {
    // Seen from above and before, the floor's gutter runs on into the wall's solid.
    TestSession session(make_inner_corner());
    const TxcTarget target = session.target(64, 64, 3);
    session.set_base(target, kBase);
    TxcLayerDef def = decal_def(session.image(Picture(1, 1, kPaint)));
    def.filter = TXC_FILTER_NEAREST;
    def.occlusion = TXC_OCCLUSION_SELF;
    turn(def, 1, 0, 0, -45);
    resize(def, 6, 6, 6);
    session.layer(target, def);
    const Picture painted = session.paint(target);
    const MapArrays map = session.map(target);
    std::uint32_t gutter = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            if (map.coverage_at(x, y) == 0) continue;
            CHECK_UNARY(painted.at(x, y) == kPaint);
            gutter += map.coverage_at(x, y) == 2 ? 1 : 0;
        }
    }
    CHECK(gutter > 300);
}

TEST_CASE("Every texel of a cluttered scene is hidden or painted as a search of all triangles says") {
    Random random(72);
    const Shape target_shape = make_sphere(0.6, 16, 8);
    const Shape clutter = make_random_triangles(random, 60, 1.0, 0.3);
    TestSession session;
    session.add(target_shape, 0);
    session.add(clutter, 1);
    const TxcTarget target = session.target(64, 32, 0);
    session.set_base(target, kBase);
    // One mesh of both for the search; triangles of the target come first.
    Shape bare = target_shape;
    bare.normals.clear();
    bare.uvs.clear();
    bare.append(clutter);
    const txc::Mesh mesh = make_core_mesh(bare);
    const ReferenceMap map(target_shape, 64, 32);
    const double least = 0.0005 * static_cast<double>(mesh.bounds.diagonal());
    for (int round = 0; round < 6; ++round) {
        TxcLayerDef def = decal_def(session.image(Picture(1, 1, kPaint)));
        def.filter = TXC_FILTER_NEAREST;
        def.occlusion = TXC_OCCLUSION_SELF;
        def.backfaces = 1;
        def.angle_fade_start = def.angle_fade_end = 90.0f;
        random.rotation(def.rotation);
        resize(def, 3, 3, 3);
        const TxcLayer layer = session.layer(target, def);
        const Picture painted = session.paint(target);
        const txc::PlanarProjector projector = make_projector(def);
        const Vec3 towards{projector.towards_viewer.x, projector.towards_viewer.y, projector.towards_viewer.z};
        const BruteForce brute{mesh, least};
        std::uint32_t wrong = 0;
        std::uint32_t hidden = 0;
        for (std::uint32_t y = 0; y < 32; ++y) {
            for (std::uint32_t x = 0; x < 64; ++x) {
                const ReferenceTexel& texel = map.at(x, y);
                if (texel.triangle < 0 || !texel.sure) continue;
                const Vec3 p = map.position(texel.triangle, texel.u, texel.v);
                const double q_z = dot(p, towards) / 3.0;
                bool unsure = false;
                const bool expected =
                    brute.is_blocked(p, towards, (0.5 - q_z) * 3.0, static_cast<std::uint32_t>(texel.triangle), unsure);
                // Neighbours on the sphere that the ray only grazes, at about the least distance.
                bool nearer = false;
                bool ignored = false;
                nearer = BruteForce{mesh, least * 0.25}.is_blocked(p, towards, (0.5 - q_z) * 3.0,
                                                                   static_cast<std::uint32_t>(texel.triangle), ignored);
                if (unsure || ignored || nearer != expected) continue;
                wrong += (painted.at(x, y) == kBase) != expected ? 1 : 0;
                hidden += expected ? 1 : 0;
            }
        }
        CAPTURE(round);
        CHECK(wrong == 0);
        CHECK(hidden > 300);
        must(txc_layer_destroy(session.id(), layer));
    }
}

TEST_CASE("A tree that does not fit the budget is refused") {
    Random random(73);
    const txc::Mesh mesh = make_core_mesh(make_random_triangles(random, 1000, 1.0, 0.1));
    txc::MemoryBudget budget(50000);
    txc::OcclusionTree tree(budget);
    CHECK(tree.build(mesh) == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(budget.used() == 0);
}

TEST_CASE("The point of a triangle nearest to another is found in each of its seven regions") {
    Random random(74);
    for (int round = 0; round < 200; ++round) {
        const txc::Mesh mesh = make_core_mesh(make_random_triangles(random, 1, 1.0, 1.0));
        const glm::dvec3 from(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3));
        const glm::dvec3 found = txc::nearest_point_on_triangle(mesh, 0, from);
        const glm::dvec3 a(mesh.positions[0]);
        const glm::dvec3 ab = glm::dvec3(mesh.positions[1]) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.positions[2]) - a;
        // No sample of the triangle may be nearer.
        double nearest = 1e9;
        for (int i = 0; i <= 60; ++i) {
            for (int j = 0; i + j <= 60; ++j)
                nearest = std::fmin(nearest, glm::length(a + ab * (i / 60.0) + ac * (j / 60.0) - from));
        }
        const double distance = glm::length(found - from);
        CHECK_UNARY(distance <= nearest + 1e-9);
        CHECK_UNARY(distance >= nearest - 0.1);
        // And it lies in the triangle.
        const glm::dvec3 normal = glm::cross(ab, ac);
        if (glm::length(normal) > 1e-3) CHECK_UNARY(std::fabs(glm::dot(normal, found - a)) < 1e-9);
    }
}

namespace {

/// Two balls side by side, one material each, and a decal that lies over both of them, or over the first alone.
struct TwoBalls {
    TestSession session;
    TxcTarget targets[2];
    TxcLayer layers[2];

    explicit TwoBalls(double width) {
        for (std::uint32_t material : {0u, 1u})
            session.add(moved(make_sphere(0.5, 240, 120), material * 2.0, 0.0, 0.0), material);
        TxcLayerDef def = decal_def(session.image(Picture(1, 1, kPaint)));
        def.occlusion = TXC_OCCLUSION_SELF;
        resize(def, width, 1, 2);
        for (std::uint32_t material : {0u, 1u}) {
            targets[material] = session.target(16, 16, TXC_NONE, 1, material);
            session.update(targets[material]);
            layers[material] = session.layer(targets[material], def);
        }
    }

    /// The most that an update had allocated at once, beyond what was there before it.
    std::uint64_t allocation_of_update(std::uint32_t material) {
        const std::uint64_t before = allocated_bytes();
        take_allocation_peak();
        session.update(targets[material]);
        return take_allocation_peak() - before;
    }
};

// Of these balls: what gathering occluders takes, and what the rest of a cast does.
constexpr std::uint64_t kOccluders = 4 << 20;
constexpr std::uint64_t kLittle = 512 * 1024;

}  // namespace

TEST_CASE("A decal over several materials gathers its occluders once, and they are given back in a pause") {
    if (!kMetersAllocations) return;
    TwoBalls balls(6.0);
    CHECK(balls.allocation_of_update(0) > kOccluders);
    CHECK(balls.allocation_of_update(1) < kLittle);
    const std::uint64_t held = allocated_bytes();
    std::uint32_t next = 0;
    must(txc_layer_prepare(balls.session.id(), balls.layers[0], 0, 0, 1, &next));
    CHECK(allocated_bytes() + kOccluders < held);
}

TEST_CASE("A material that a decal names and does not reach gathers no occluders") {
    if (!kMetersAllocations) return;
    TwoBalls balls(0.8);
    CHECK(balls.allocation_of_update(0) > kOccluders);
    // Not what is kept of the first.
    std::uint32_t next = 0;
    must(txc_layer_prepare(balls.session.id(), balls.layers[0], 0, 0, 1, &next));
    CHECK(balls.allocation_of_update(1) < kLittle);
}

TEST_CASE("Occluders that are kept for the next material are none to a decal that has moved") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(0.5, 0.3), 1);
    const TxcTarget target = session.target(64, 64);
    CHECK(paint_front(session, target, 1.0, TXC_OCCLUSION_SELF).at(32, 32) == kBase);
    // With half the depth the plate lies before the volume. Kept occluders would still hide what is behind it.
    CHECK(paint_front(session, target, 0.5, TXC_OCCLUSION_SELF).at(32, 32) == kPaint);
}
