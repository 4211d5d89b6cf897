// The memory budget is kept: what does not fit is refused before it is allocated, and what is counted is what is held.
#include <doctest/doctest.h>

#include <algorithm>

#include "support/allocation_meter.h"
#include "support/glb_builder.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint64_t kMib = 1u << 20;

TxcTargetDef target_of(std::uint32_t size) {
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.width = def.height = size;
    return def;
}

/// Bytes that `work` had allocated at its highest, beyond those from before.
template <typename Work>
std::uint64_t allocation_of(Work&& work) {
    const std::uint64_t before = allocated_bytes();
    take_allocation_peak();
    work();
    return take_allocation_peak() - before;
}

/// Takes what is left of the budget, but for less than 48 KiB, by images; returns them.
std::vector<TxcImage> fill_budget(TestSession& session) {
    const std::vector<std::uint8_t> pixels(64 * 64 * 4);
    std::vector<TxcImage> images;
    TxcImage image = 0;
    while (txc_image_create(session.id(), 64, 64, pixels.data(), &image) == TXC_STATUS_OK) images.push_back(image);
    return images;
}

}  // namespace

TEST_CASE("A target that does not fit is refused before anything is allocated") {
    TestSession session(1);
    session.add(make_plane());
    const TxcTargetDef def = target_of(8192);
    TxcTarget target = 0;
    const std::uint64_t allocated =
        allocation_of([&] { CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_OUT_OF_BUDGET); });
    CHECK(target == 0);
    CHECK(allocated < 64 * 1024);
}

TEST_CASE("An image or a base that does not fit is refused before anything is allocated") {
    TestSession session(32);
    session.add(make_plane());
    const TxcTarget target = session.target(64, 64);
    const std::uint32_t used = session.stats().memory_used_kib;
    const std::vector<std::uint8_t> pixels(2048 * 2048 * 4);
    TxcImage image = 0;
    std::uint64_t allocated = allocation_of(
        [&] { CHECK(txc_image_create(session.id(), 2048, 2048, pixels.data(), &image) == TXC_STATUS_OUT_OF_BUDGET); });
    CHECK(allocated < 64 * 1024);
    CHECK(session.stats().memory_used_kib == used);
    // A base is held at the target's size, whatever its own is.
    session.set_base(target, Picture(2048, 2048, {1, 2, 3, 4}));
    const TxcTarget large = session.target(512, 512);
    fill_budget(session);
    allocated = allocation_of([&] {
        CHECK(txc_target_set_base(session.id(), large, 1, 1, pixels.data(), TXC_FILTER_LINEAR) ==
              TXC_STATUS_OUT_OF_BUDGET);
    });
    CHECK(allocated < 64 * 1024);
}

TEST_CASE("An update whose texture does not fit is refused before anything is allocated") {
    TestSession session(12);
    session.add(make_plane());
    const TxcTarget target = session.target(512, 512);
    fill_budget(session);
    TxcUpdate update{};
    const std::uint64_t allocated = allocation_of(
        [&] { CHECK(txc_target_update(session.id(), target, TXC_NONE, &update) == TXC_STATUS_OUT_OF_BUDGET); });
    CHECK(allocated < 64 * 1024);
}

TEST_CASE("A model that does not fit is refused before it takes the budget's worth of memory") {
    const std::vector<std::uint8_t> file = make_model(make_sphere(1.0, 256, 256)).glb();
    TestSession session(2);
    const std::uint64_t allocated = allocation_of([&] { CHECK(session.try_load(file) == TXC_STATUS_OUT_OF_BUDGET); });
    CHECK(allocated < 4 * kMib);
    CHECK(session.stats().memory_used_kib == 0);
    Shape sphere = make_sphere(1.0, 256, 256);
    CHECK(session.try_add(sphere) == TXC_STATUS_OUT_OF_BUDGET);
    session.add(make_plane());
}

/// One mesh of 320 KiB that so many nodes use.
std::vector<std::uint8_t> in_places(int nodes) {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_sphere(1.0, 64, 64)));
    for (int i = 0; i < nodes; ++i) glb.add("nodes", text(R"({"mesh":0,"translation":[%d,0,0]})", i));
    return glb.glb();
}

TEST_CASE("A mesh in more places than fit is refused before the first of them takes memory") {
    if (!kMetersAllocations) return;
    const std::vector<std::uint8_t> file = in_places(100);
    TestSession session(24);
    const std::uint64_t allocated = allocation_of([&] { CHECK(session.try_load(file) == TXC_STATUS_OUT_OF_BUDGET); });
    CHECK(allocated < 2 * kMib);
}

TEST_CASE("A mesh in many places takes the room of all of them once, as it is counted") {
    if (!kMetersAllocations) return;
    const std::vector<std::uint8_t> file = in_places(100);
    TestSession session;
    const std::uint64_t allocated = allocation_of([&] { session.load(file); });
    CHECK(allocated <= session.stats().memory_peak_kib * 1024ull + kMib);
}

TEST_CASE("What a session allocates stays within what it counts") {
    if (!kMetersAllocations) return;
    const std::vector<std::uint8_t> file = make_model(make_sphere(1.0, 200, 100)).glb();
    const std::vector<std::uint8_t> rgba(512 * 512 * 4, 100);
    TestSession session;
    const std::uint64_t before = allocated_bytes();
    const auto step = [&](const char* name, auto&& work) {
        take_allocation_peak();
        work();
        const std::uint64_t peak = take_allocation_peak() - before;
        const std::uint64_t held = allocated_bytes() - before;
        const TxcSessionStats stats = session.stats();
        CAPTURE(std::string(name));
        // The tenth and the half mebibyte are for vectors' room, handles and nodes of the standard library.
        CHECK(held <= stats.memory_used_kib * 1024ull * 11 / 10 + kMib / 2);
        CHECK(peak <= stats.memory_peak_kib * 1024ull * 11 / 10 + kMib / 2);
        // And it does not claim much more than it holds.
        CHECK(held + kMib * 3 >= stats.memory_used_kib * 1024ull / 2);
    };
    TxcTarget target = 0;
    TxcImage image = 0;
    TxcUpdate update{};
    const TxcTargetDef def = target_of(1024);
    step("load", [&] { session.load(file); });
    step("bake", [&] {
        must(txc_target_create(session.id(), &def, &target));
        session.bake(target);
    });
    step("image", [&] { must(txc_image_create(session.id(), 512, 512, rgba.data(), &image)); });
    step("base", [&] { must(txc_target_set_base(session.id(), target, 512, 512, rgba.data(), TXC_FILTER_LINEAR)); });
    step("first update", [&] { must(txc_target_update(session.id(), target, TXC_NONE, &update)); });
    step("decals", [&] {
        for (int i = 0; i < 8; ++i) {
            TxcLayerDef layer = decal_def(image);
            layer.occlusion = TXC_OCCLUSION_SELF;
            resize(layer, 1.5, 1.5, 3);
            place(layer, 0.1 * i, 0, 0);
            session.layer(target, layer);
        }
        must(txc_target_update(session.id(), target, TXC_NONE, &update));
    });
}

TEST_CASE("A session gives back all that it held") {
    const std::uint64_t before = allocated_bytes();
    {
        TestSession session(make_sphere(1.0));
        const TxcTarget target = session.target(256, 256, TXC_NONE, 0);
        TxcLayerDef def = decal_def(session.image(make_checker(64, 64, 8)));
        def.occlusion = TXC_OCCLUSION_SELF;
        session.layer(target, def);
        session.paint(target);
        CHECK(session.stats().memory_used_kib > 0);
    }
    // The newest error's text and static tables may have grown.
    CHECK(allocated_bytes() <= before + 64 * 1024);
}

TEST_CASE("A layer that shrinks keeps its room while it may grow again, counted, and gives it back once it is small") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(1024, 1024);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, {255, 0, 0, 255})));
    resize(def, 2, 2, 1);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    // 8 bytes a texel.
    constexpr std::uint64_t kWholeKib = 8 * 1024;
    const std::uint64_t with_whole = session.stats().memory_used_kib;
    const std::uint64_t held_with_whole = allocated_bytes();
    const auto shrink_to = [&](double side) {
        resize(def, side, side, 1);
        session.change(layer, def);
        session.update(target);
    };
    shrink_to(0.7);
    CHECK(session.stats().memory_used_kib >= with_whole - kWholeKib / 8);
    shrink_to(0.2);
    CHECK(session.stats().memory_used_kib <= with_whole - kWholeKib * 7 / 8);
    if (kMetersAllocations) CHECK(allocated_bytes() <= held_with_whole - kWholeKib * 1024 * 7 / 8);
}

std::uint32_t map_kib(const TestSession& session, TxcTarget target) {
    TxcMapInfo info{};
    must(txc_map_info(session.id(), target, &info));
    return info.byte_count / 1024;
}

TEST_CASE("Destroying things gives their share of the budget back") {
    TestSession session(make_sphere(1.0));
    const std::uint32_t model_alone = session.stats().memory_used_kib;
    const TxcTarget target = session.target(256, 256);
    const std::uint32_t with_map = session.stats().memory_used_kib;
    const std::uint32_t map_alone = map_kib(session, target);
    const TxcImage image = session.image(make_noise(256, 256, 140));
    TxcLayerDef def = decal_def(image);
    resize(def, 2, 2, 2);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    CHECK(session.stats().memory_used_kib > with_map);
    must(txc_layer_destroy(session.id(), layer));
    must(txc_image_destroy(session.id(), image));
    const std::uint32_t patches = map_kib(session, target) - map_alone;
    must(txc_target_destroy(session.id(), target));
    CHECK(session.stats().memory_used_kib <= with_map + patches + 1);  // the map is spared, and what it derived
    session.add(make_plane());
    CHECK(session.stats().memory_used_kib <= model_alone + 1);
    CHECK(session.stats().memory_peak_kib >= with_map);
    CHECK(session.stats().memory_budget_kib == 512 * 1024);
}

TEST_CASE("A thousand moves of a decal hold no more than the first") {
    TestSession session(make_sphere(1.0));
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(session.image(make_checker(32, 32, 4)));
    def.occlusion = TXC_OCCLUSION_SELF;
    resize(def, 0.5, 0.5, 1);
    const TxcLayer layer = session.layer(target, def);
    Random random(141);
    std::uint64_t early = 0;
    std::uint64_t late = 0;
    for (int step = 0; step < 1000; ++step) {
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(0.5, 1));
        session.change(layer, def);
        session.update(target);
        std::uint64_t& most = step < 500 ? early : late;
        most = std::max(most, allocated_bytes());
    }
    CHECK(late <= early + 64 * 1024);
}

TEST_CASE("Maps that no target uses make way for a bake that runs out of budget midway") {
    const Shape sphere = make_sphere(1.0);
    TestSession plenty(sphere);
    const std::uint32_t model_alone = plenty.stats().memory_used_kib;
    plenty.target(2048, 2048, 8);
    const std::uint32_t map_kib = plenty.stats().memory_used_kib - model_alone;
    const std::uint32_t bake_kib = plenty.stats().memory_peak_kib;
    // Room for such a bake, but not beside the two maps before it, which a session keeps in case they are asked for again.
    const std::uint32_t budget_mib = (bake_kib + map_kib / 2) / 1024 + 1;
    REQUIRE(budget_mib * 1024 < bake_kib + 2 * map_kib);
    TestSession session(budget_mib);
    session.add(sphere);
    for (const std::uint32_t gutter : {8u, 7u, 6u, 5u})
        must(txc_target_destroy(session.id(), session.target(2048, 2048, gutter)));
    CHECK(session.stats().bake_count == 4);
}

TEST_CASE("Maps that no target uses make way for a bake that does not even begin") {
    TestSession session(16);
    session.add(make_sphere(1.0));
    must(txc_target_destroy(session.id(), session.target(1024, 1024)));
    fill_budget(session);
    session.target(512, 512);
    CHECK(session.stats().bake_count == 2);
}
