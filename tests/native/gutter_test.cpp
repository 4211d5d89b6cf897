// The texels around charts (spec section 2).
#include "gutter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/reference_map.h"
#include "support/test_session.h"

using namespace support;

namespace {

/// Two charts a few texels apart, of which one is a triangle with slanting sides.
Shape make_two_charts() {
    Shape shape = make_plane(1.0, 0.0, {0.1, 0.15, 0.42, 0.7});
    const std::uint32_t first = shape.vertex_count();
    const double corners[3][2] = {{0.5, 0.2}, {0.55, 0.8}, {0.9, 0.45}};
    for (const auto& corner : corners) {
        shape.add_vertex(3.0 + corner[0], 1.0 - corner[1], corner[0] * 0.5, corner[0], corner[1]);
        shape.add_normal(0, 0, 1);
    }
    shape.add_triangle(first, first + 1, first + 2);
    return shape;
}

std::int64_t squared_distance(std::uint32_t x, std::uint32_t y, std::uint32_t to_x, std::uint32_t to_y) {
    const std::int64_t dx = static_cast<std::int64_t>(x) - to_x;
    const std::int64_t dy = static_cast<std::int64_t>(y) - to_y;
    return dx * dx + dy * dy;
}

/// To the nearest covered texel's centre, squared; very large without one.
std::int64_t to_nearest_covered(const MapArrays& map, std::uint32_t x, std::uint32_t y) {
    std::int64_t nearest = 1 << 30;
    for (std::uint32_t cy = 0; cy < map.height; ++cy) {
        for (std::uint32_t cx = 0; cx < map.width; ++cx) {
            if (map.coverage_at(cx, cy) == 1) nearest = std::min(nearest, squared_distance(x, y, cx, cy));
        }
    }
    return nearest;
}

}  // namespace

TEST_CASE("The gutter is exactly the texels within its width of a covered one") {
    TestSession session(make_two_charts());
    for (const std::uint32_t gutter : {0u, 1u, 2u, 3u, 7u, 64u}) {
        CAPTURE(gutter);
        const TxcTarget target = session.target(72, 56, gutter);
        const MapArrays map = session.map(target);
        std::uint32_t gutter_texels = 0;
        for (std::uint32_t y = 0; y < map.height; ++y) {
            for (std::uint32_t x = 0; x < map.width; ++x) {
                if (map.coverage_at(x, y) == 1) continue;
                const bool within = to_nearest_covered(map, x, y) <= static_cast<std::int64_t>(gutter) * gutter;
                CHECK_UNARY(map.coverage_at(x, y) == (within ? 2 : 0));
                gutter_texels += within ? 1 : 0;
            }
        }
        CHECK(session.map_info(target).gutter_texels == gutter_texels);
    }
}

TEST_CASE("A gutter of 0 leaves every texel between the charts empty") {
    TestSession session(make_two_charts());
    CHECK(session.map_info(session.target(64, 64, 0)).gutter_texels == 0);
}

TEST_CASE("A gutter texel lies on the plane of the nearest covered texel's triangle, continued to it") {
    const Shape shape = make_two_charts();
    TestSession session(shape);
    const std::uint32_t gutter = 4;
    const MapArrays map = session.map(session.target(72, 56, gutter));
    const ReferenceMap reference(shape, 72, 56);
    std::uint32_t checked = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            if (map.coverage_at(x, y) != 2) continue;
            const std::int64_t nearest = to_nearest_covered(map, x, y);
            const double u = (x + 0.5) / map.width;
            const double v = (y + 0.5) / map.height;
            // Of equally near neighbours any may lend its triangle.
            double best = 1e9;
            for (std::uint32_t cy = 0; cy < map.height; ++cy) {
                for (std::uint32_t cx = 0; cx < map.width; ++cx) {
                    if (map.coverage_at(cx, cy) != 1 || squared_distance(x, y, cx, cy) != nearest) continue;
                    const int triangle = reference.at(cx, cy).triangle;
                    if (triangle < 0) continue;
                    best = std::min(best, length(vec3(map.position(x, y)) - reference.position(triangle, u, v)));
                }
            }
            CHECK_UNARY(best < reference.diagonal() / 32768);
            ++checked;
        }
    }
    CHECK(checked > 300);
}

TEST_CASE("A gutter texel's normal is a unit vector near its neighbour's") {
    const Shape shape = make_sphere(1.0, 12, 6, {0.2, 0.2, 0.8, 0.8});
    TestSession session(shape);
    const MapArrays map = session.map(session.target(64, 64, 6));
    std::uint32_t checked = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            if (map.coverage_at(x, y) != 2) continue;
            CHECK_UNARY(std::fabs(length(vec3(map.normal(x, y))) - 1.0) < 1e-5);
            const std::int64_t nearest = to_nearest_covered(map, x, y);
            double least = 180.0;
            for (std::uint32_t cy = 0; cy < map.height; ++cy) {
                for (std::uint32_t cx = 0; cx < map.width; ++cx) {
                    if (map.coverage_at(cx, cy) == 1 && squared_distance(x, y, cx, cy) == nearest)
                        least = std::min(least, degrees_between(vec3(map.normal(x, y)), vec3(map.normal(cx, cy))));
                }
            }
            CHECK_UNARY(least <= 91.0);
            ++checked;
        }
    }
    CHECK(checked > 500);
}

TEST_CASE("The default gutter is 2 texels at 1024, in proportion above, never less than 2") {
    CHECK(txc::default_gutter(1, 1) == 2);
    CHECK(txc::default_gutter(512, 512) == 2);
    CHECK(txc::default_gutter(1024, 1024) == 2);
    CHECK(txc::default_gutter(1536, 1024) == 3);
    CHECK(txc::default_gutter(2048, 2048) == 4);
    CHECK(txc::default_gutter(512, 4096) == 8);
    CHECK(txc::default_gutter(8192, 8192) == 16);
    TestSession session(make_plane());
    CHECK(session.map_info(session.target(512, 16)).gutter == 2);
    CHECK(session.map_info(session.target(1024, 16)).gutter == 2);
    CHECK(session.map_info(session.target(2048, 16)).gutter == 4);
    CHECK(session.map_info(session.target(8192, 16)).gutter == 16);
}

TEST_CASE("A gutter wider than 64 texels is refused") {
    TestSession session(make_plane());
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.gutter = 65;
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(std::string(txc_error_detail()) == "gutter is 65; it must be at most 64 texels");
}

TEST_CASE("Between two charts each gutter texel belongs to the nearer one") {
    // Left chart at z 0, right one at z 1, eight texels apart: four gutter texels each.
    Shape shape = make_plane(1.0, 0.0, {0.0, 0.0, 0.375, 1.0});
    shape.append(make_plane(1.0, 1.0, {0.625, 0.0, 1.0, 1.0}));
    TestSession session(shape);
    const MapArrays map = session.map(session.target(32, 32, 8));
    for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 12; x < 16; ++x) CHECK_UNARY(map.position(x, y)[2] == 0.0f);
        for (std::uint32_t x = 16; x < 20; ++x) CHECK_UNARY(map.position(x, y)[2] == 1.0f);
    }
}
