// Who owns a texel that several triangles cover, and how many they are (spec section 2).
#include <doctest/doctest.h>

#include "support/test_session.h"

using namespace support;

namespace {

/// Planes one above the other over the same chart; the lowest in the list is the first added.
Shape make_stack(std::uint32_t count, const UvRect& chart = {}) {
    Shape stack;
    for (std::uint32_t i = 0; i < count; ++i) stack.append(make_plane(1.0, i * 0.01, chart));
    return stack;
}

}  // namespace

TEST_CASE("The triangle with the lowest index owns a texel that several cover") {
    TestSession session(make_stack(3));
    const MapArrays map = session.map(session.target(16, 16));
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            CHECK_UNARY(map.position(x, y)[2] == 0.0f);
            CHECK_UNARY(map.overlap_at(x, y) == 3);
        }
    }
}

TEST_CASE("Overlapping texels are counted once each, however many triangles lie there") {
    // A quarter of the texture is covered twice, the rest once.
    Shape shape = make_plane(1.0, 0.0);
    shape.append(make_plane(1.0, 1.0, {0.5, 0.5, 1.0, 1.0}));
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64);
    const TxcMapInfo info = session.map_info(target);
    CHECK(info.covered_texels == 64 * 64);
    CHECK(info.overlapping_texels == 32 * 32);
    const MapArrays map = session.map(target);
    CHECK(map.overlap_at(31, 31) == 1);
    CHECK(map.overlap_at(32, 32) == 2);
    CHECK(map.position(40, 40)[2] == 0.0f);
}

TEST_CASE("Triangles on texels that are counted to the end cost the bake next to nothing") {
    const auto steps_of = [](std::uint32_t count) {
        TestSession session(make_stack(count));
        const TxcTarget target = session.open_target(128, 128);
        std::uint32_t steps = 1;
        while (txc_target_bake(session.id(), target, 20000, nullptr) == TXC_STATUS_PENDING) ++steps;
        CHECK(session.map_info(target).overlapping_texels == 128 * 128);
        return steps;
    };
    // Of three thousand planes the last 2745.
    CHECK(steps_of(3000) < 2 * steps_of(256));
}

TEST_CASE("The count of claims stops at 255") {
    TestSession session(make_stack(300));
    const MapArrays map = session.map(session.target(8, 8));
    for (const std::uint8_t claims : map.overlap) CHECK_UNARY(claims == 255);
}

TEST_CASE("A count of 254 and one of 255 are told apart") {
    TestSession fewer(make_stack(254));
    CHECK(fewer.map(fewer.target(8, 8)).overlap_at(3, 3) == 254);
    TestSession more(make_stack(255));
    CHECK(more.map(more.target(8, 8)).overlap_at(3, 3) == 255);
}

TEST_CASE("Empty and gutter texels have no claims") {
    TestSession session(make_stack(2, {0.25, 0.25, 0.75, 0.75}));
    const MapArrays map = session.map(session.target(32, 32, 3));
    std::uint32_t gutter = 0;
    for (std::size_t t = 0; t < map.coverage.size(); ++t) {
        CHECK_UNARY(map.overlap[t] == (map.coverage[t] == 1 ? 2 : 0));
        gutter += map.coverage[t] == 2 ? 1 : 0;
    }
    CHECK(gutter > 0);
}

TEST_CASE("A triangle that spans several repeats of the texture claims a texel once") {
    TestSession session(make_plane(1.0, 0.0, {0.0, 0.0, 3.0, 2.0}));
    const TxcMapInfo info = session.map_info(session.target(32, 32));
    CHECK(info.covered_texels == 32 * 32);
    // The square's two halves each cover the whole texture by themselves.
    CHECK(info.overlapping_texels == 32 * 32);
    TestSession wide(make_plane(1.0, 0.0, {0.0, 0.0, 4.0, 0.5}));
    const MapArrays map = wide.map(wide.target(32, 32));
    for (const std::uint8_t claims : map.overlap) CHECK_UNARY(claims <= 2);
}

TEST_CASE(
    "Whether a triangle repeats the texture twice or two hundred times makes little difference to the bake's work") {
    const auto steps_of = [](double repeats) {
        TestSession session(make_plane(1.0, 0.0, {0.0, 0.0, repeats, repeats}));
        const TxcTarget target = session.open_target(100, 128);
        std::uint32_t steps = 1;
        float progress = 0.0f;
        while (txc_target_bake(session.id(), target, 10000, &progress) == TXC_STATUS_PENDING) ++steps;
        CHECK(progress == 1.0f);
        return steps;
    };
    CHECK(steps_of(200.0) < 10 * steps_of(2.0));
}

TEST_CASE("A triangle that repeats the texture takes each texel where it comes to it first, row by row") {
    constexpr std::uint32_t kRepeats = 6;
    Shape shape = make_plane(1.0, 0.0, {0.0, 0.0, kRepeats, kRepeats});
    // Left is the lower right half: its uppermost rows are in the last repeat of a row, and do not fill it.
    shape.indices.erase(shape.indices.begin(), shape.indices.begin() + 3);
    TestSession session(shape);
    const MapArrays map = session.map(session.target(100, 60));
    for (std::uint32_t y = 0; y < 60; ++y) {
        for (std::uint32_t x = 0; x < 100; ++x) {
            const double u = (x + 0.5) / 100;
            const double v = (y + 0.5) / 60;
            // A left edge owns the centres on it.
            const double down = u + v > 1.0 - 1e-9 ? 0.0 : 1.0;
            CHECK_UNARY(std::abs(map.position(x, y)[0] + 0.5 - (u + kRepeats - 1) / kRepeats) < 1e-5);
            CHECK_UNARY(std::abs(0.5 - map.position(x, y)[1] - (v + down) / kRepeats) < 1e-5);
        }
    }
}

TEST_CASE("The overlap of two materials is not counted: each has a texture of its own") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(1.0, 1.0), 1);
    CHECK(session.map_info(session.target(16, 16, 0, 1, 0)).overlapping_texels == 0);
    CHECK(session.map_info(session.target(16, 16, 0, 1, 1)).overlapping_texels == 0);
    const TxcTarget second = session.target(16, 16, 0, 1, 1);
    CHECK(session.map(second).position(3, 3)[2] == 1.0f);
}

TEST_CASE("A triangle that repeats the texture beyond all reason is refused, and named") {
    Shape shape = make_plane();
    shape.append(make_plane(1.0, 1.0, {0.0, 0.0, 300.0, 1.0}));
    TestSession session(shape);
    TxcTargetDef def;
    txc_target_def_default(&def);
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_BAD_UVS);
    CHECK(std::string(txc_error_detail()).find("triangle 2 of material 0") != std::string::npos);
}
