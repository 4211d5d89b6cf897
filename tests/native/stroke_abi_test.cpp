// The ABI's promises about dabs: read back as given, refused by name, counted against the budget (texelcast.h).
#include <doctest/doctest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include "support/allocation_meter.h"
#include "support/one_of_each.h"
#include "support/strokes.h"

using namespace support;

namespace {

std::string detail() { return txc_error_detail(); }

TxcDab dab_of_numbers() {
    TxcDab dab{};
    dab.projector = TXC_PROJECTOR_CYLINDRICAL;
    dab.flow = 0.0625f;
    dab.flip_x = 1;
    float number = 51.0f;
    for (float* field : {&dab.position_model[0],
                         &dab.position_model[1],
                         &dab.position_model[2],
                         &dab.rotation[0],
                         &dab.rotation[1],
                         &dab.rotation[2],
                         &dab.rotation[3],
                         &dab.size[0],
                         &dab.size[1],
                         &dab.size[2],
                         &dab.fov_degrees,
                         &dab.aspect,
                         &dab.near_distance,
                         &dab.far_distance,
                         &dab.radius,
                         &dab.height,
                         &dab.arc_degrees,
                         &dab.depth,
                         &dab.uv_center[0],
                         &dab.uv_center[1],
                         &dab.uv_size[0],
                         &dab.uv_size[1],
                         &dab.uv_angle_degrees})
        *field = number++;
    return dab;
}

}  // namespace

TEST_CASE("A dab's defaults are a layer's, at full flow") {
    TxcDab dab;
    std::memset(&dab, 0xcd, sizeof dab);
    txc_dab_default(&dab);
    TxcLayerDef def;
    txc_layer_def_default(&def);
    CHECK(dab.flow == 1.0f);
    CHECK(dab.flip_x == 0);
    CHECK(dab.projector == TXC_PROJECTOR_PLANAR);
    CHECK(std::memcmp(dab.position_model, def.position_model, sizeof(float) * 23) == 0);
    CHECK(sizeof(TxcDab) == 26 * 4);
    CHECK(def.tip == TXC_TIP_ROUND);
    CHECK(def.hardness == 1.0f);
    CHECK(def.flow == 1.0f);
    txc_dab_default(nullptr);
}

TEST_CASE("A dab's every field is kept apart and read back as it was given, and so is the brush") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    TxcLayerDef def = stroke_def(0.125, 0.375);
    def.tip = TXC_TIP_MASK;
    const TxcLayer layer = session.layer(target, def);
    const TxcLayerDef kept = session.layer_def(layer);
    CHECK(std::memcmp(&kept, &def, sizeof def) == 0);
    const TxcDab numbers = dab_of_numbers();
    add_dabs(session, layer, {dab_at(1, 2, 3), numbers});
    std::uint32_t count = 0;
    must(txc_stroke_dab_count(session.id(), layer, &count));
    CHECK(count == 2);
    TxcDab back;
    std::memset(&back, 0xcd, sizeof back);
    must(txc_stroke_dabs(session.id(), layer, 1, 1, &back));
    CHECK(std::memcmp(&back, &numbers, sizeof back) == 0);
    must(txc_stroke_dabs(session.id(), layer, 0, 1, &back));
    CHECK(back.position_model[1] == 2.0f);
    must(txc_stroke_dabs(session.id(), layer, 2, 0, &back));
    CHECK(txc_stroke_dabs(session.id(), layer, 1, 2, &back) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(detail() == "dabs 1 and 2 more: the stroke has 2");
    CHECK(txc_stroke_dabs(session.id(), layer, 0xffffffffu, 2, &back) == TXC_STATUS_BAD_ARGUMENT);
}

TEST_CASE("A bad dab is named with its field and value, and none of its call is added") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    const TxcLayer layer = session.layer(target, stroke_def());
    add_dabs(session, layer, {dab_at(0, 0, 0.5)});
    const std::uint64_t before = (session.update(target), session.hash(target));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    struct Case {
        std::function<void(TxcDab&)> spoil;
        const char* said;
    };
    const Case cases[] = {
        {[=](TxcDab& d) { d.flow = nan; }, "dabs[2]: flow is "},
        {[](TxcDab& d) { d.flow = 1.5f; }, "dabs[2]: flow is 1.5; it must be from 0 to 1"},
        {[](TxcDab& d) { d.flow = -0.5f; }, "dabs[2]: flow is -0.5"},
        {[](TxcDab& d) { d.projector = 4; }, "dabs[2]: projector is 4"},
        {[](TxcDab& d) { d.flip_x = 2; }, "dabs[2]: flip_x is 2"},
        {[=](TxcDab& d) { d.position_model[1] = nan; }, "dabs[2]: position[1] is "},
        {[=](TxcDab& d) { d.size[2] = infinity; }, "dabs[2]: size[2] is inf"},
        {[](TxcDab& d) { d.size[0] = 0; }, "dabs[2]: size[0] is 0"},
        {[](TxcDab& d) {
             for (float& part : d.rotation) part = 0;
         },
         "dabs[2]: rotation (0, 0, 0, 0)"},
        {[=](TxcDab& d) {
             d.projector = TXC_PROJECTOR_UV;
             d.uv_center[0] = nan;
         },
         "dabs[2]: uv_center[0] is "},
    };
    for (const Case& c : cases) {
        CAPTURE(std::string(c.said));
        std::vector<TxcDab> dabs(4, dab_at(0.2, 0.2, 0.5));
        c.spoil(dabs[2]);
        CHECK(try_add_dabs(session, layer, dabs) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(detail().find(c.said) != std::string::npos);
        std::uint32_t count = 0;
        must(txc_stroke_dab_count(session.id(), layer, &count));
        CHECK(count == 1);
    }
    CHECK(session.update(target).rect_count == 0);
    CHECK(session.hash(target) == before);
}

TEST_CASE("A brush out of range is refused by name") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    const TxcLayer layer = session.layer(target, stroke_def());
    const auto refuses = [&](const char* said, auto&& spoil) {
        TxcLayerDef def = stroke_def();
        spoil(def);
        CHECK(txc_layer_update(session.id(), layer, &def) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(detail().find(said) != std::string::npos);
    };
    refuses("tip is 3", [](TxcLayerDef& d) { d.tip = 3; });
    refuses("hardness is 2", [](TxcLayerDef& d) { d.hardness = 2; });
    refuses("hardness is ", [](TxcLayerDef& d) { d.hardness = std::numeric_limits<float>::quiet_NaN(); });
    refuses("flow is -1", [](TxcLayerDef& d) { d.flow = -1; });
    refuses("angle_fade is 70 to 91", [](TxcLayerDef& d) { d.angle_fade_end = 91; });
    // A stroke's projectors are its dabs'.
    TxcLayerDef def = stroke_def();
    def.size[0] = 0;
    CHECK(txc_layer_update(session.id(), layer, &def) == TXC_STATUS_OK);
}

TEST_CASE("Only strokes take dabs") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    const TxcDab dab = dab_at(0, 0, 1);
    std::uint32_t count = 0;
    TxcDab back;
    const std::string said = "layer " + std::to_string(handles.layer) + " is not a stroke";
    CHECK(txc_stroke_add_dabs(session.id(), handles.layer, &dab, 1) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(detail() == said);
    CHECK(txc_stroke_clear(session.id(), handles.layer) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_stroke_dab_count(session.id(), handles.layer, &count) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_stroke_dabs(session.id(), handles.layer, 0, 1, &back) == TXC_STATUS_BAD_ARGUMENT);
}

TEST_CASE("Counts of dabs beyond what a stroke takes, or the budget, are refused before any is read") {
    TestSession session(12);
    session.add(make_plane());
    const TxcTarget target = session.target(64, 64);
    const TxcLayer layer = session.layer(target, stroke_def());
    const TxcDab dab = dab_at(0, 0, 1);
    CHECK(txc_stroke_add_dabs(session.id(), layer, &dab, 0xffffffffu) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(detail().find("dab_count is 4294967295") != std::string::npos);
    CHECK(txc_stroke_add_dabs(session.id(), layer, &dab, TXC_MAX_DABS + 1) == TXC_STATUS_BAD_ARGUMENT);
    must(txc_stroke_add_dabs(session.id(), layer, &dab, 0));
    const std::vector<TxcDab> many(200000, dab);  // 20 MB
    const std::uint64_t before = allocated_bytes();
    take_allocation_peak();
    CHECK(try_add_dabs(session, layer, many) == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(take_allocation_peak() - before < 64 * 1024);
    std::uint32_t count = 9;
    must(txc_stroke_dab_count(session.id(), layer, &count));
    CHECK(count == 0);
}

TEST_CASE("A stroke that runs out of budget is painted whole once there is room") {
    const Shape sphere = make_sphere(1.0);
    std::vector<TxcDab> dabs;
    for (int i = 0; i < 5; ++i) {
        TxcDab dab = dab_at(-0.8 + 0.4 * i, 0, 1.2, 0.7);
        dab.size[2] = 4;
        dabs.push_back(dab);
    }
    TestSession plenty(sphere);
    const TxcTarget whole = plenty.target(512, 512);
    add_dabs(plenty, plenty.layer(whole, stroke_def(0.5)), dabs);
    plenty.update(whole);

    TestSession session(16);
    session.add(sphere);
    const TxcTarget target = session.target(512, 512);
    session.update(target);
    const std::uint64_t blank = session.hash(target);
    const TxcLayer layer = session.layer(target, stroke_def(0.5));
    add_dabs(session, layer, dabs);
    const std::vector<std::uint8_t> pixels(64 * 64 * 4);
    std::vector<TxcImage> ballast;
    TxcImage image = 0;
    while (txc_image_create(session.id(), 64, 64, pixels.data(), &image) == TXC_STATUS_OK) ballast.push_back(image);
    TxcUpdate update{};
    bool ran_out = false;
    std::uint32_t tries = 0;
    while (txc_target_update(session.id(), target, TXC_NONE, &update) != TXC_STATUS_OK) {
        ran_out = true;
        CHECK(session.hash(target) == blank);
        REQUIRE_FALSE(ballast.empty());
        must(txc_image_destroy(session.id(), ballast.back()));
        ballast.pop_back();
        ++tries;
    }
    CHECK(ran_out);
    CHECK(tries > 20);
    CHECK(session.hash(target) == plenty.hash(whole));
}

TEST_CASE("What a stroke allocates is counted, and given back") {
    if (!kMetersAllocations) return;
    constexpr std::uint64_t kMib = 1u << 20;
    TestSession session;
    const std::uint64_t before = allocated_bytes();
    session.add(make_sphere(1.0));
    const TxcTarget target = session.target(1024, 1024);
    session.update(target);
    const TxcSessionStats bare = session.stats();
    const auto map_kib = [&] {
        TxcMapInfo info{};
        must(txc_map_info(session.id(), target, &info));
        return info.byte_count / 1024;
    };
    const std::uint32_t map_alone = map_kib();
    const TxcLayer layer = session.layer(target, stroke_def(0.5));
    Random random(310);
    for (int step = 0; step < 20; ++step) {
        std::vector<TxcDab> dabs;
        for (int i = 0; i < 50; ++i) {
            TxcDab dab = dab_at(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 0.5));
            dab.size[2] = 3;
            dabs.push_back(dab);
        }
        take_allocation_peak();
        add_dabs(session, layer, dabs);
        session.update(target);
        const TxcSessionStats stats = session.stats();
        CHECK(allocated_bytes() - before <= stats.memory_used_kib * 1024ull * 11 / 10 + kMib / 2);
        CHECK(take_allocation_peak() - before <= stats.memory_peak_kib * 1024ull * 11 / 10 + kMib / 2);
    }
    CHECK(session.stats().memory_used_kib > bare.memory_used_kib + 1024);
    // What the map derived for the tiles it painted stays with it.
    const std::uint32_t kept = bare.memory_used_kib + map_kib() - map_alone + 64;
    must(txc_stroke_clear(session.id(), layer));
    session.update(target);
    CHECK(session.stats().memory_used_kib <= kept);
    must(txc_layer_destroy(session.id(), layer));
    session.update(target);
    CHECK(session.stats().memory_used_kib <= kept);
}

TEST_CASE("Strokes of one hardness share their tip") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    session.update(target);
    const auto memory_of = [&](double hardness) {
        const std::uint32_t before = session.stats().memory_used_kib;
        add_dabs(session, session.layer(target, stroke_def(hardness)), {dab_at(0, 0, 4)});
        session.update(target);
        return session.stats().memory_used_kib - before;
    };
    const std::uint32_t first = memory_of(0.5);
    CHECK(first > 700);
    CHECK(memory_of(0.5) < first / 2);
    CHECK(memory_of(0.75) > 700);
}

TEST_CASE("An update in steps ends where one at once ends, and the picture waits for the end unless it is asked for") {
    const auto add_layers = [](TestSession& session, TxcTarget target) {
        for (int s = 0; s < 3; ++s) {
            const TxcLayer layer = session.layer(target, stroke_def(0.5, 0.5));
            for (int d = 0; d < 5; ++d) add_dabs(session, layer, {dab_at(-0.4 + 0.2 * d, -0.3 + 0.3 * s, 0.2)});
        }
    };
    TestSession at_once(make_plane());
    const TxcTarget whole = at_once.target(64, 64);
    add_layers(at_once, whole);
    at_once.update(whole);
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    session.update(target);
    const std::uint64_t bare = session.hash(target);
    add_layers(session, target);
    TxcUpdate update{};
    for (int dab = 1; dab < 15; ++dab) {
        must(txc_target_update(session.id(), target, 1, &update));
        CHECK(update.unfinished == 1);
        CHECK(update.rect_count == 0);
        if (dab < 5) CHECK(session.hash(target) == bare);
        if (dab != 5) continue;
        must(txc_target_update(session.id(), target, 0, &update));
        CHECK(update.unfinished == 1);
        CHECK(update.projected_layers == 0);
        CHECK(update.rect_count > 0);
        CHECK(session.hash(target) != bare);
        CHECK(session.hash(target) != at_once.hash(whole));
    }
    must(txc_target_update(session.id(), target, 1, &update));
    CHECK(update.unfinished == 0);
    CHECK(session.hash(target) == at_once.hash(whole));
}
