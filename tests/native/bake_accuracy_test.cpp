// What the baked map says of each texel, against shapes known in closed form and a slow bake (spec section 2).
#include <doctest/doctest.h>

#include <cmath>

#include "support/reference_map.h"
#include "support/test_session.h"

namespace {

using namespace support;

constexpr double kPositionShare = 1.0 / 32768;  // of the diagonal
constexpr double kNormalDegrees = 0.5;

struct Errors {
    double position_share = 0;  // the worst, as a share of the diagonal
    double normal_degrees = 0;  // the worst
    std::uint32_t compared = 0;
    std::uint32_t wrong_coverage = 0;
    std::uint32_t wrong_overlap = 0;
};

/// Every sure texel of the core's map against the slow bake.
Errors against_reference(const Shape& shape, std::uint32_t width, std::uint32_t height) {
    TestSession session(shape);
    const MapArrays map = session.map(session.target(width, height));
    const ReferenceMap reference(shape, width, height);
    const double diagonal = reference.diagonal();
    Errors errors;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const ReferenceTexel& texel = reference.at(x, y);
            if (!texel.sure) continue;
            if ((map.coverage_at(x, y) == 1) != (texel.claims > 0)) ++errors.wrong_coverage;
            if (map.overlap_at(x, y) != std::min(texel.claims, 255)) ++errors.wrong_overlap;
            if (texel.triangle < 0 || map.coverage_at(x, y) != 1) continue;
            const Vec3 p = reference.position(texel.triangle, texel.u, texel.v);
            const Vec3 n = reference.normal(texel.triangle, texel.u, texel.v);
            errors.position_share = std::fmax(errors.position_share, length(vec3(map.position(x, y)) - p) / diagonal);
            errors.normal_degrees = std::fmax(errors.normal_degrees, degrees_between(vec3(map.normal(x, y)), n));
            ++errors.compared;
        }
    }
    return errors;
}

void check(const Errors& errors, std::uint32_t at_least) {
    CHECK(errors.wrong_coverage == 0);
    CHECK(errors.wrong_overlap == 0);
    CHECK(errors.position_share < kPositionShare);
    CHECK(errors.normal_degrees < kNormalDegrees);
    CHECK(errors.compared > at_least);
}

}  // namespace

TEST_CASE("A plane's texels know their places and that they face the viewer") {
    const std::uint32_t width = 200;
    const std::uint32_t height = 120;
    TestSession session(make_plane(3.0, 0.25));
    const MapArrays map = session.map(session.target(width, height));
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const float* p = map.position(x, y);
            CHECK_UNARY(std::fabs(p[0] - ((x + 0.5) / width - 0.5) * 3.0) < 1e-6);
            CHECK_UNARY(std::fabs(p[1] - (0.5 - (y + 0.5) / height) * 3.0) < 1e-6);
            CHECK_UNARY(p[2] == 0.25f);
            const float* n = map.normal(x, y);
            CHECK_UNARY((n[0] == 0.0f && n[1] == 0.0f && n[2] == 1.0f));
        }
    }
}

TEST_CASE("A fine sphere's texels lie on it and face away from its middle") {
    const double radius = 2.0;
    const std::uint32_t columns = 96;
    const std::uint32_t rows = 48;
    TestSession session(make_sphere(radius, columns, rows));
    const MapArrays map = session.map(session.target(256, 128));
    // A chord's middle lies this much below the sphere; so does no point of a facet more than twice.
    const double sagitta = radius * (1.0 - std::cos(kPi / columns)) * 2.1;
    double worst_height = 0;
    double worst_angle = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            REQUIRE_UNARY(map.coverage_at(x, y) == 1);
            const Vec3 p = vec3(map.position(x, y));
            worst_height = std::fmax(worst_height, std::fabs(length(p) - radius));
            // At the poles a facet's own texels share one normal less well with the round surface.
            if (std::fabs(p.y) > 0.99 * radius) continue;
            worst_angle = std::fmax(worst_angle, degrees_between(vec3(map.normal(x, y)), p));
        }
    }
    CHECK(worst_height < sagitta);
    CHECK(worst_angle < kNormalDegrees);
}

TEST_CASE("A sphere's texels agree with the interpolated triangles") {
    check(against_reference(make_sphere(1.5, 24, 12), 160, 96), 14000);
    check(against_reference(make_sphere(0.001, 24, 12, {0.1, 0.1, 0.7, 0.9}), 128, 128), 7500);
}

TEST_CASE("A cylinder's texels agree with the interpolated triangles and with the round surface") {
    const Shape cylinder = make_cylinder(0.5, 2.0, 96);
    check(against_reference(cylinder, 192, 64), 11000);
    TestSession session(cylinder);
    const MapArrays map = session.map(session.target(192, 64));
    double worst_angle = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            const double around = (x + 0.5) / map.width * 2.0 * kPi;
            const Vec3 outward{-std::sin(around), 0.0, -std::cos(around)};
            worst_angle = std::fmax(worst_angle, degrees_between(vec3(map.normal(x, y)), outward));
            CHECK_UNARY(std::fabs(map.position(x, y)[1] - (0.5 - (y + 0.5) / map.height) * 2.0) < 1e-6);
        }
    }
    CHECK(worst_angle < kNormalDegrees);
}

TEST_CASE("Random triangles with random normals agree with the slow bake, overlaps and wrapped corners included") {
    Random random(20);
    for (int round = 0; round < 12; ++round) {
        Shape shape;
        for (std::uint32_t t = 0; t < 12; ++t) {
            for (int corner = 0; corner < 3; ++corner) {
                // Less than a repeat apart: a triangle that covers a texel twice has a claim of its own.
                shape.add_vertex(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1),
                                 random.between(0.35, 1.3), random.between(-0.6, 0.35));
                // Within 55 degrees of +Z: opposite normals have no mean that either would call its own.
                const Vec3 n = unit({random.between(-1, 1), random.between(-1, 1), 1.0});
                shape.add_normal(n.x, n.y, n.z);
            }
            shape.add_triangle(t * 3, t * 3 + 1, t * 3 + 2);
        }
        CAPTURE(round);
        check(against_reference(shape, 64, 80), 500);
    }
}

TEST_CASE("A model far from the origin and one of tiny size keep their accuracy") {
    check(against_reference(moved(make_sphere(1.0, 24, 12), 50.0, -20.0, 30.0), 128, 64), 7000);
    check(against_reference(make_sphere(1e-5, 24, 12), 128, 64), 7000);
    check(against_reference(make_sphere(1e4, 24, 12), 128, 64), 7000);
}

TEST_CASE("A sliver far thinner than a texel keeps its few texels on its surface") {
    Random random(23);
    std::uint32_t compared = 0;
    for (int round = 0; round < 40; ++round) {
        Shape shape;
        const double thickness = random.between(1e-4, 4e-4);
        const double slope = random.between(0.7, 0.8);
        shape.add_vertex(0, 1, 0, 0.05, 0.1);
        shape.add_vertex(1, 0, 0.5, 0.95, 0.1 + slope);
        shape.add_vertex(1, 1, 0, 0.95, 0.1 + slope + thickness);
        shape.add_triangle(0, 1, 2);
        CAPTURE(round);
        const Errors errors = against_reference(shape, 512, 512);
        check(errors, 0);
        compared += errors.compared;
    }
    CHECK(compared > 200);
}

TEST_CASE("A large texture's far texels are as accurate as its first") {
    TestSession session(make_plane(1.0));
    const TxcTarget target = session.target(TXC_MAX_SIZE, 4);
    const MapArrays map = session.map(target);
    for (std::uint32_t x = 0; x < map.width; ++x)
        CHECK_UNARY(std::fabs(map.position(x, 2)[0] - ((x + 0.5) / map.width - 0.5)) < std::sqrt(2.0) * kPositionShare);
}

TEST_CASE("Without vertex normals the face's own normal holds") {
    const Shape cube = make_cube(2.0);
    TestSession session(cube);
    const MapArrays map = session.map(session.target(96, 64, 0));
    const ReferenceMap reference(cube, 96, 64);
    std::uint32_t compared = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            const int triangle = reference.at(x, y).triangle;
            if (triangle < 0 || map.coverage_at(x, y) != 1) continue;
            const Vec3 n = vec3(map.normal(x, y));
            // Triangles come in pairs, a face each: +X, -X, +Y, -Y, +Z, -Z.
            const double along[3] = {n.x, n.y, n.z};
            CHECK_UNARY(along[triangle / 4] == (triangle / 2 % 2 == 0 ? 1.0 : -1.0));
            ++compared;
        }
    }
    CHECK(compared > 3000);
}

TEST_CASE("A vertex normal of zero, or not a number, gives way to the flat one") {
    for (const float bad : {0.0f, std::nanf(""), HUGE_VALF}) {
        Shape plane = make_plane();
        for (std::size_t i = 0; i < plane.normals.size(); ++i) plane.normals[i] = i % 3 == 0 ? bad : 0.0f;
        TestSession session(plane);
        const MapArrays map = session.map(session.target(8, 8));
        CHECK(degrees_between(vec3(map.normal(3, 3)), {0, 0, 1}) < 1e-6);
    }
}

TEST_CASE("Where one corner's normal is zero, or not a number, those of the others are interpolated") {
    for (const float bad : {0.0f, std::nanf("")}) {
        Shape plane = make_plane();
        const float normals[] = {0.0f, 0.0f, 0.0f, 0.6f, 0.0f, 0.8f, 0.0f, 0.6f, 0.8f, -0.6f, 0.0f, 0.8f};
        plane.normals.assign(std::begin(normals), std::end(normals));
        const ReferenceMap reference(plane, 32, 32);
        Shape broken = plane;
        broken.normals[0] = bad;
        TestSession session(broken);
        const MapArrays map = session.map(session.target(32, 32));
        double worst = 0;
        for (std::uint32_t y = 0; y < 32; ++y) {
            for (std::uint32_t x = 0; x < 32; ++x) {
                const ReferenceTexel& texel = reference.at(x, y);
                if (!texel.sure) continue;
                const Vec3 n = reference.normal(texel.triangle, texel.u, texel.v);
                worst = std::fmax(worst, degrees_between(vec3(map.normal(x, y)), n));
            }
        }
        CHECK(worst < kNormalDegrees);
    }
}

TEST_CASE("Normals need not come as unit vectors") {
    Shape plane = make_plane();
    for (float& n : plane.normals) n *= 250.0f;
    TestSession session(plane);
    const MapArrays map = session.map(session.target(8, 8));
    CHECK(map.normal(3, 3)[2] == 1.0f);
}

TEST_CASE("A triangle without area in texture space owns nothing and is counted") {
    Shape shape = make_plane();
    const std::uint32_t first = shape.vertex_count();
    for (const double v : {0.1, 0.5, 0.9}) {
        shape.add_vertex(v, 0, 1, 0.5, v);
        shape.add_normal(0, 0, 1);
    }
    shape.add_triangle(first, first + 1, first + 2);
    TestSession session(shape);
    CHECK(session.material_info().degenerate_uv_triangles == 1);
    const TxcMapInfo info = session.map_info(session.target(32, 32));
    CHECK(info.covered_texels == 32 * 32);
    CHECK(info.overlapping_texels == 0);
}

TEST_CASE("A triangle without area in space still has texels, with a usable normal") {
    Shape shape;
    shape.add_vertex(1, 1, 1, 0, 0);
    shape.add_vertex(1, 1, 1, 1, 0);
    shape.add_vertex(1, 1, 1, 0, 1);
    shape.add_triangle(0, 1, 2);
    TestSession session(shape);
    const MapArrays map = session.map(session.target(16, 16));
    CHECK(map.coverage_at(2, 2) == 1);
    CHECK(map.position(2, 2)[0] == 1.0f);
    CHECK(std::fabs(length(vec3(map.normal(2, 2))) - 1.0) < 1e-6);
}
