// The bake as work: in steps, cancelled, reused, within the budget (spec section 2; texelcast.h, "Target and bake").
#include <doctest/doctest.h>

#include <cmath>

#include "support/test_session.h"

using namespace support;

namespace {

TxcTargetDef square(std::uint32_t size) {
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.width = def.height = size;
    return def;
}

}  // namespace

TEST_CASE("A bake in small steps reports rising progress and ends at 1") {
    TestSession session(make_sphere(1.0, 48, 24));
    const TxcTarget target = session.open_target(256, 256);
    float before = -1.0f;
    float progress = 0.0f;
    std::uint32_t steps = 0;
    std::uint32_t rises = 0;
    TxcStatus status = TXC_STATUS_PENDING;
    while (status == TXC_STATUS_PENDING) {
        status = txc_target_bake(session.id(), target, 2000, &progress);
        CHECK_UNARY(progress >= before);
        CHECK_UNARY(progress <= 1.0f);
        CHECK_UNARY(status == TXC_STATUS_OK || progress < 1.0f);
        rises += progress > before ? 1 : 0;
        before = progress;
        ++steps;
    }
    CHECK(status == TXC_STATUS_OK);
    CHECK(progress == 1.0f);
    CHECK(steps > 40);
    CHECK(rises > 30);
}

TEST_CASE("The map is the same whatever the work limit was") {
    Shape shape = make_sphere(1.0, 16, 8, {0.1, 0.1, 0.9, 0.9});
    shape.append(make_plane(2.0, 0.0, {0.5, 0.5, 2.5, 1.25}));
    TestSession session(shape);
    const TxcTarget at_once = session.open_target(96, 80);
    session.bake(at_once, 1u << 31);
    const MapArrays expected = session.map(at_once);
    for (const std::uint32_t work_limit : {0u, 1u, 37u, 1000u, 50000u}) {
        CAPTURE(work_limit);
        TestSession again(shape);
        const TxcTarget target = again.open_target(96, 80);
        again.bake(target, work_limit);
        CHECK_UNARY(again.map(target) == expected);
    }
}

TEST_CASE("A work limit bounds a step: no step of a large target runs away") {
    TestSession session(make_plane());
    const TxcTarget target = session.open_target(1024, 1024);
    std::uint32_t steps = 0;
    while (txc_target_bake(session.id(), target, 64 * 1024, nullptr) == TXC_STATUS_PENDING) ++steps;
    // Two passes over a million texels, a row of tiles the coarsest grain.
    CHECK(steps >= 30);
}

TEST_CASE("A map is baked once for a material, size and gutter, and used again") {
    TestSession session(make_sphere(1.0));
    CHECK(session.stats().bake_count == 0);
    const TxcTarget first = session.target(128, 128);
    CHECK(session.stats().bake_count == 1);
    const MapArrays expected = session.map(first);

    // A second target of the same four, while the first lives.
    const TxcTarget second = session.open_target(128, 128);
    float progress = 0.0f;
    CHECK(txc_target_bake(session.id(), second, 1, &progress) == TXC_STATUS_OK);
    CHECK(progress == 1.0f);
    CHECK(session.stats().bake_count == 1);

    // And again after both were destroyed.
    must(txc_target_destroy(session.id(), first));
    must(txc_target_destroy(session.id(), second));
    const TxcTarget third = session.target(128, 128);
    CHECK(session.stats().bake_count == 1);
    CHECK_UNARY(session.map(third) == expected);
}

TEST_CASE("Another size, gutter or material bakes anew") {
    TestSession session;
    session.add(make_sphere(1.0), 0);
    session.add(make_plane(), 1);
    session.target(64, 64);
    CHECK(session.stats().bake_count == 1);
    session.target(64, 128);
    CHECK(session.stats().bake_count == 2);
    session.target(64, 64, 5);
    CHECK(session.stats().bake_count == 3);
    session.target(64, 64, TXC_NONE, 1, 1);
    CHECK(session.stats().bake_count == 4);
    session.target(64, 64);
    CHECK(session.stats().bake_count == 4);
}

TEST_CASE("Two targets of one key under way at once end with one bake") {
    TestSession session(make_sphere(1.0));
    const TxcTarget first = session.open_target(64, 64);
    const TxcTarget second = session.open_target(64, 64);
    CHECK(txc_target_bake(session.id(), second, 1, nullptr) == TXC_STATUS_PENDING);
    session.bake(first);
    CHECK(txc_target_bake(session.id(), second, 1, nullptr) == TXC_STATUS_OK);
    CHECK(session.stats().bake_count == 1);
    CHECK_UNARY(session.map(first) == session.map(second));
}

TEST_CASE("Changing the model makes the old maps void") {
    TestSession session(make_plane(1.0, 0.0));
    const TxcTarget old = session.target(32, 32);
    session.add(moved(make_plane(1.0, 0.0, {0.0, 0.0, 0.5, 0.5}), 0, 0, 1));
    CHECK(txc_target_bake(session.id(), old, 1, nullptr) == TXC_STATUS_STALE_HANDLE);
    const TxcTarget target = session.target(32, 32);
    CHECK(session.stats().bake_count == 2);
    CHECK(session.map_info(target).overlapping_texels == 16 * 16);
}

TEST_CASE("Destroying a target in mid-bake cancels it and gives all its memory back") {
    TestSession session(make_sphere(1.0, 64, 32));
    const std::uint32_t before = session.stats().memory_used_kib;
    for (const std::uint32_t steps : {0u, 1u, 20u, 60u}) {
        CAPTURE(steps);
        const TxcTarget target = session.open_target(512, 512);
        CHECK(session.stats().memory_used_kib > before);
        for (std::uint32_t i = 0; i < steps; ++i)
            CHECK(txc_target_bake(session.id(), target, 10000, nullptr) == TXC_STATUS_PENDING);
        must(txc_target_destroy(session.id(), target));
        CHECK(session.stats().memory_used_kib == before);
        CHECK(session.stats().bake_count == 0);
    }
    session.target(512, 512);
    CHECK(session.stats().bake_count == 1);
}

TEST_CASE("Nothing can be read or painted before the bake has finished") {
    TestSession session(make_sphere(1.0));
    const TxcTarget target = session.open_target(64, 64);
    std::vector<float> floats(64 * 64 * 3);
    std::vector<std::uint8_t> bytes(64 * 64 * 4);
    TxcMapInfo info{};
    TxcUpdate update{};
    CHECK(txc_map_info(session.id(), target, &info) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_map_read_positions(session.id(), target, 0, 64, floats.data()) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_map_read_coverage(session.id(), target, 0, 64, bytes.data()) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_map_view(session.id(), target, TXC_VIEW_NORMALS, 0, 64, bytes.data()) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_target_update(session.id(), target, TXC_NONE, &update) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_target_read(session.id(), target, 0, 0, 0, 1, 1, bytes.data()) == TXC_STATUS_NOT_BAKED);
}

TEST_CASE("A bake that does not fit the budget is refused before it begins, and holds nothing") {
    TestSession session(4);
    session.add(make_plane());
    const std::uint32_t before = session.stats().memory_used_kib;
    const TxcTargetDef def = square(4096);
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(std::string(txc_error_detail()).find("baking the map needs") == 0);
    CHECK(session.stats().memory_used_kib == before);
    session.target(256, 256);
}

TEST_CASE("A bake that runs out of budget midway gives no half-baked map, even when it is asked again") {
    // Many small triangles: their frames outgrow what is left after an image has taken most of the budget.
    const Shape sphere = make_sphere(1.0, 160, 120);
    TestSession plenty(sphere);
    const MapArrays expected = plenty.map(plenty.target(512, 512));
    TestSession session(16);
    session.add(sphere);
    const TxcImage ballast = session.image(Picture(1024, 640));
    const TxcTarget target = session.open_target(512, 512);
    TxcStatus status = TXC_STATUS_PENDING;
    while (status == TXC_STATUS_PENDING) status = txc_target_bake(session.id(), target, 20000, nullptr);
    REQUIRE(status == TXC_STATUS_OUT_OF_BUDGET);
    TxcMapInfo info{};
    CHECK(txc_map_info(session.id(), target, &info) == TXC_STATUS_NOT_BAKED);
    CHECK(txc_target_bake(session.id(), target, 1u << 30, nullptr) == TXC_STATUS_OUT_OF_BUDGET);

    must(txc_image_destroy(session.id(), ballast));
    session.bake(target);
    CHECK_UNARY(session.map(target) == expected);
}

namespace {

/// A sheet in 64 folds: each row of the texture is in as many spans, of which a block of the raster's list holds 16,384.
Shape make_folds() {
    return make_grid(64, 1, {}, [](double s, double t, double(&p)[3], double(&n)[3]) {
        p[0] = s - 0.5;
        p[1] = 0.5 - t;
        p[2] = std::lround(s * 64) % 2 * 0.01;
        n[0] = n[1] = 0.0;
        n[2] = 1.0;
    });
}

}  // namespace

TEST_CASE("Spans by the ten thousand, and those far to the right, lie on their own texels at any work limit") {
    const std::uint32_t sizes[][2] = {{256, 1024}, {TXC_MAX_SIZE, 4}};
    for (const auto& size : sizes) {
        for (const std::uint32_t work_limit : {1u << 30, 7000u}) {
            TestSession session(make_folds());
            const TxcTarget target = session.open_target(size[0], size[1]);
            session.bake(target, work_limit);
            const MapArrays map = session.map(target);
            std::uint32_t wrong = 0;
            for (std::uint32_t y = 0; y < map.height; ++y) {
                for (std::uint32_t x = 0; x < map.width; ++x) {
                    const float* at = map.position(x, y);
                    const double off_x = at[0] - ((x + 0.5) / map.width - 0.5);
                    const double off_y = at[1] - (0.5 - (y + 0.5) / map.height);
                    wrong += map.coverage_at(x, y) != 1 || std::fabs(off_x) + std::fabs(off_y) > 1e-4 ? 1 : 0;
                }
            }
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("Wherever in the list of spans the budget ends, the bake is refused and gives back what it took") {
    std::uint32_t refused = 0;
    for (std::uint32_t rows = 520; rows < 740; rows += 8) {
        CAPTURE(rows);
        TestSession session(8);
        session.add(make_folds());
        session.image(Picture(512, rows));
        const std::uint32_t used = session.stats().memory_used_kib;
        const TxcTarget target = session.open_target(256, 1024);
        TxcStatus status = TXC_STATUS_PENDING;
        while (status == TXC_STATUS_PENDING) status = txc_target_bake(session.id(), target, 1u << 30, nullptr);
        if (status == TXC_STATUS_OK) continue;
        CHECK(status == TXC_STATUS_OUT_OF_BUDGET);
        ++refused;
        must(txc_target_destroy(session.id(), target));
        CHECK(session.stats().memory_used_kib == used);
    }
    CHECK(refused > 2);
}
