// Layers on a target: their order, edits, blending, and that an edit costs no more than it must (spec section 6).
#include <doctest/doctest.h>

#include <cmath>

#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kRed{255, 0, 0, 255};
constexpr Color kGreen{0, 255, 0, 255};
constexpr Color kBlue{0, 0, 255, 255};

struct Easel {
    TestSession session;
    TxcTarget target;
    explicit Easel(const Shape& shape = make_plane(), std::uint32_t size = 64, std::uint32_t mip_levels = 1)
        : session(shape), target(session.target(size, size, TXC_NONE, mip_levels)) {
        session.set_base(target, kBase);
    }
    /// A hard-edged square of one colour, `size` metres wide, around (x, y).
    TxcLayerDef square(Color color, double x, double y, double size) {
        TxcLayerDef def = decal_def(session.image(Picture(1, 1, color)));
        def.filter = TXC_FILTER_NEAREST;
        place(def, x, y, 0);
        resize(def, size, size, 1);
        return def;
    }
    TxcLayer add(const TxcLayerDef& def) { return session.layer(target, def); }
    Picture paint() { return session.paint(target); }
};

}  // namespace

TEST_CASE("Layers lie on each other in the order in which they were made") {
    Easel easel;
    easel.add(easel.square(kRed, -0.1, 0, 0.5));
    easel.add(easel.square(kGreen, 0, 0, 0.5));
    easel.add(easel.square(kBlue, 0.1, 0, 0.5));
    const Picture picture = easel.paint();
    CHECK(picture.at(11, 32) == kRed);
    CHECK(picture.at(18, 32) == kGreen);
    CHECK(picture.at(32, 32) == kBlue);
    CHECK(picture.at(53, 32) == kBlue);
    CHECK(picture.at(4, 32) == kBase);
}

TEST_CASE("Moving a layer in the order changes what lies on top") {
    Easel easel;
    const TxcLayer red = easel.add(easel.square(kRed, 0, 0, 0.5));
    const TxcLayer green = easel.add(easel.square(kGreen, 0, 0, 0.5));
    const TxcLayer blue = easel.add(easel.square(kBlue, 0, 0, 0.5));
    CHECK(easel.paint().at(32, 32) == kBlue);
    must(txc_layer_move(easel.session.id(), blue, 0));
    CHECK(easel.paint().at(32, 32) == kGreen);
    must(txc_layer_move(easel.session.id(), red, 99));  // past the top is the top
    CHECK(easel.paint().at(32, 32) == kRed);
    must(txc_layer_move(easel.session.id(), red, 1));
    CHECK(easel.paint().at(32, 32) == kGreen);
    must(txc_layer_destroy(easel.session.id(), green));
    CHECK(easel.paint().at(32, 32) == kRed);
}

TEST_CASE("A hundred layers blend in order") {
    Easel easel(make_plane(), 16);
    double red = kBase.red;
    for (int i = 0; i < 100; ++i) {
        const auto shade = static_cast<std::uint8_t>(i * 37);
        TxcLayerDef def = easel.square({shade, shade, shade, 255}, 0, 0, 2);
        def.opacity = 0.1f;
        easel.add(def);
        red = red * (1.0 - static_cast<double>(0.1f)) + shade * static_cast<double>(0.1f);
    }
    CHECK(std::abs(easel.paint().at(8, 8).red - red) <= 1.0);
}

TEST_CASE("Removing every layer gives the base bytes back") {
    Easel easel(make_sphere(1.0));
    const Picture base = make_noise(64, 64, 80);
    easel.session.set_base(easel.target, base);
    CHECK(easel.paint() == base);
    std::vector<TxcLayer> layers;
    Random random(81);
    for (int i = 0; i < 10; ++i) {
        TxcLayerDef def = decal_def(easel.session.image(make_gradient(32, 32, true)));
        random.rotation(def.rotation);
        resize(def, 1.5, 1.5, 2);
        layers.push_back(easel.add(def));
    }
    layers.push_back(easel.add(fill_def(0.5f, 0.25f, 0.75f, 0.5f)));
    CHECK(easel.paint() != base);
    for (const TxcLayer layer : layers) must(txc_layer_destroy(easel.session.id(), layer));
    CHECK(easel.paint() == base);
}

TEST_CASE("Hiding a layer is as good as removing it, and showing it brings it back") {
    Easel easel(make_sphere(1.0));
    TxcLayerDef def = decal_def(easel.session.image(make_gradient(32, 32, true)));
    resize(def, 1.5, 1.5, 2);
    const Picture before = easel.paint();
    const TxcLayer layer = easel.add(def);
    const Picture shown = easel.paint();
    CHECK(shown != before);
    def.visible = 0;
    easel.session.change(layer, def);
    CHECK(easel.paint() == before);
    def.visible = 1;
    easel.session.change(layer, def);
    const TxcUpdate update = easel.session.update(easel.target);
    CHECK(easel.session.read(easel.target) == shown);
    CHECK(update.projected_layers == 0);
}

TEST_CASE("A layer that changes while it is hidden is shown as it then is") {
    Easel easel;
    TxcLayerDef def = easel.square(kRed, -0.25, 0, 0.25);
    const TxcLayer layer = easel.add(def);
    easel.paint();
    def.visible = 0;
    easel.session.change(layer, def);
    CHECK(easel.paint() == Picture(64, 64, kBase));
    place(def, 0.25, 0, 0);
    easel.session.change(layer, def);
    CHECK(easel.session.update(easel.target).projected_layers == 0);  // it can wait
    def.visible = 1;
    easel.session.change(layer, def);
    const Picture picture = easel.paint();
    CHECK(picture.at(48, 32) == kRed);
    CHECK(picture.at(16, 32) == kBase);
}

TEST_CASE("Moving a decal away and back gives the first bytes") {
    Easel easel(make_sphere(1.0), 128);
    easel.session.set_base(easel.target, make_noise(128, 128, 82));
    TxcLayerDef under = decal_def(easel.session.image(make_checker(64, 64, 8)));
    resize(under, 1.2, 1.2, 2);
    easel.add(under);
    TxcLayerDef def = decal_def(easel.session.image(make_gradient(64, 64, true)));
    resize(def, 0.8, 0.8, 2);
    const TxcLayer layer = easel.add(def);
    const Picture first = easel.paint();
    Random random(83);
    for (int step = 0; step < 20; ++step) {
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        random.rotation(def.rotation);
        easel.session.change(layer, def);
        easel.session.update(easel.target);
    }
    place(def, 0, 0, 0);
    turn(def, 0, 0, 1, 0);
    easel.session.change(layer, def);
    CHECK(easel.paint() == first);
}

TEST_CASE("Moving one decal projects that decal alone, and composites only where it was and is") {
    Easel easel(make_plane(), 512);
    std::vector<TxcLayer> layers;
    std::vector<TxcLayerDef> defs;
    for (int i = 0; i < 12; ++i) {
        defs.push_back(easel.square(kRed, -0.4 + 0.07 * i, 0.3, 0.06));
        layers.push_back(easel.add(defs.back()));
    }
    const TxcUpdate all = easel.session.update(easel.target);
    CHECK(all.projected_layers == 12);
    CHECK(all.composited_texels == 512 * 512);
    CHECK(easel.session.stats().projection_count == 12);

    place(defs[5], 0.0, -0.3, 0.0);
    easel.session.change(layers[5], defs[5]);
    const TxcUpdate moved = easel.session.update(easel.target);
    CHECK(moved.projected_layers == 1);
    CHECK(easel.session.stats().projection_count == 13);
    // 31 texels wide: at most 3 x 3 tiles of 16 x 16 where it was, and as many where it is.
    CHECK(moved.composited_texels <= 2 * 9 * 256);
    CHECK(moved.composited_texels >= 2 * 31 * 31);
    CHECK(moved.projected_texels >= 30 * 30);
    CHECK(moved.projected_texels <= 32 * 32);
    const TxcSessionStats stats = easel.session.stats();
    CHECK(stats.composited_texels == moved.composited_texels);
    CHECK(stats.projected_texels == moved.projected_texels);
}

TEST_CASE("Opacity, order and visibility do not project again; what changes the paint does") {
    Easel easel(make_plane(), 64);
    TxcLayerDef def = easel.square(kRed, 0, 0, 0.5);
    const TxcLayer layer = easel.add(def);
    const TxcLayer other = easel.add(easel.square(kBlue, 0.1, 0, 0.5));
    easel.session.update(easel.target);
    const auto projections = [&](auto&& edit) {
        edit();
        easel.session.change(layer, def);
        return easel.session.update(easel.target).projected_layers;
    };
    CHECK(projections([&] { def.opacity = 0.5f; }) == 0);
    CHECK(projections([&] { def.lock_alpha = 1; }) == 0);
    CHECK(projections([&] { def.color[0] = 0.5f; }) == 0);
    CHECK(projections([&] { must(txc_layer_move(easel.session.id(), other, 0)); }) == 0);
    CHECK(projections([&] {}) == 0);
    CHECK(projections([&] { def.position_model[0] = 0.1f; }) == 1);
    CHECK(projections([&] { def.size[1] = 0.4f; }) == 1);
    CHECK(projections([&] { turn(def, 0, 0, 1, 5); }) == 1);
    CHECK(projections([&] { def.filter = TXC_FILTER_LINEAR; }) == 1);
    CHECK(projections([&] { def.wrap = TXC_WRAP_REPEAT; }) == 1);
    CHECK(projections([&] { def.flip_x = 1; }) == 1);
    CHECK(projections([&] { def.flip_y = 1; }) == 1);
    CHECK(projections([&] { def.backfaces = 1; }) == 1);
    CHECK(projections([&] { def.angle_fade_start = 10.0f; }) == 1);
    CHECK(projections([&] { def.angle_fade_end = 80.0f; }) == 1);
    CHECK(projections([&] { def.occlusion = TXC_OCCLUSION_SELF; }) == 1);
    CHECK(projections([&] { def.image = easel.session.image(Picture(1, 1, kGreen)); }) == 1);
}

TEST_CASE("Every field of a change shows") {
    Easel easel(make_sphere(1.0), 96);
    TxcLayerDef def = decal_def(easel.session.image(make_noise(8, 8, 84, true)));
    resize(def, 1.5, 1.2, 1.5);
    place(def, 0.1, 0.1, 0.9);
    const TxcLayer layer = easel.add(def);
    Picture before = easel.paint();
    const auto changes = [&](auto&& edit) {
        edit();
        easel.session.change(layer, def);
        const Picture after = easel.paint();
        const bool differs = after != before;
        before = after;
        return differs;
    };
    CHECK(changes([&] { def.opacity = 0.5f; }));
    CHECK(changes([&] { def.blend = TXC_BLEND_MULTIPLY; }));
    CHECK(changes([&] { def.blend_space = TXC_BLEND_SPACE_LINEAR; }));
    CHECK(changes([&] { def.filter = TXC_FILTER_NEAREST; }));
    CHECK(changes([&] { def.flip_x = 1; }));
    CHECK(changes([&] { def.flip_y = 1; }));
    CHECK(changes([&] { def.angle_fade_start = 0.0f; }));
    CHECK(changes([&] { def.angle_fade_end = 30.0f; }));
    CHECK(changes([&] {
        resize(def, 1.5, 1.2, 9);
        def.backfaces = 1;
    }));
    CHECK(changes([&] { def.occlusion = TXC_OCCLUSION_SELF; }));
    CHECK(changes([&] { def.position_model[0] = 0.4f; }));
    CHECK(changes([&] { turn(def, 0, 1, 0, 30); }));
    CHECK(changes([&] { def.image = easel.session.image(Picture(1, 1, kGreen)); }));
    CHECK(changes([&] { def.kind = TXC_LAYER_FILL; }));
    CHECK(changes([&] { def.color[1] = 0.75f; }));
    CHECK(changes([&] { def.visible = 0; }));
}

TEST_CASE("A fill colours the whole target, empty texels too") {
    Easel easel(make_plane(0.5, 0.0, {0.25, 0.25, 0.75, 0.75}));
    easel.add(fill_def(1.0f, 0.5f, 0.0f));
    CHECK(easel.paint() == Picture(64, 64, {255, 128, 0, 255}));
}

TEST_CASE("A fill blends by its alpha and opacity, and keeps a locked alpha") {
    Easel easel;
    easel.session.set_base(easel.target, {0, 100, 200, 128});
    TxcLayerDef def = fill_def(1.0f, 0.0f, 0.0f, 0.5f);
    def.opacity = 0.5f;
    const TxcLayer layer = easel.add(def);
    // Source alpha 1/4 over alpha 128/255.
    const double below = 128.0 / 255 * 0.75;
    const double alpha = 0.25 + below;
    Color color = easel.paint().at(5, 5);
    CHECK(std::fabs(color.red - 255 * 0.25 / alpha) <= 1.0);
    CHECK(std::fabs(color.green - 100 * below / alpha) <= 1.0);
    CHECK(std::fabs(color.alpha - 255 * alpha) <= 1.0);
    def.lock_alpha = 1;
    easel.session.change(layer, def);
    color = easel.paint().at(5, 5);
    CHECK(std::fabs(color.red - 255 * 0.25) <= 1.0);
    CHECK(std::fabs(color.green - 100 * 0.75) <= 1.0);
    CHECK(color.alpha == 128);
}

TEST_CASE("A fill can become a decal and a decal a fill") {
    Easel easel;
    TxcLayerDef def = easel.square(kRed, 0, 0, 0.5);
    const TxcLayer layer = easel.add(def);
    const Picture as_decal = easel.paint();
    TxcLayerDef fill = fill_def(0.0f, 1.0f, 0.0f);
    easel.session.change(layer, fill);
    CHECK(easel.paint() == Picture(64, 64, kGreen));
    easel.session.change(layer, def);
    CHECK(easel.paint() == as_decal);
}

TEST_CASE("A decal on a locked layer leaves the target's alpha as it was") {
    Easel easel;
    Picture base(64, 64, {100, 100, 100, 0});
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 32; x < 64; ++x) base.set(x, y, {100, 100, 100, 200});
    }
    easel.session.set_base(easel.target, base);
    TxcLayerDef def = easel.square(kRed, 0, 0, 0.5);
    def.lock_alpha = 1;
    easel.add(def);
    const Picture picture = easel.paint();
    CHECK(picture.at(24, 32) == Color{100, 100, 100, 0});
    CHECK(picture.at(40, 32) == Color{255, 0, 0, 200});
}

TEST_CASE("Colour under zero alpha is kept, until something is painted there") {
    Easel easel;
    const Color ghost{12, 34, 56, 0};
    easel.session.set_base(easel.target, ghost);
    easel.add(easel.square({255, 255, 255, 0}, 0, 0, 0.9));
    TxcLayerDef faint = easel.square(kRed, 0.25, 0, 0.25);
    faint.opacity = 0.0f;
    easel.add(faint);
    easel.add(easel.square({0, 255, 0, 128}, -0.25, 0, 0.25));
    const Picture picture = easel.paint();
    CHECK(picture.at(48, 32) == ghost);
    CHECK(picture.at(2, 2) == ghost);
    CHECK(picture.at(16, 32) == Color{0, 255, 0, 128});
}

TEST_CASE("A layer whose picture is destroyed turns transparent, and takes another") {
    Easel easel;
    TxcLayerDef def = easel.square(kRed, 0, 0, 0.5);
    const TxcLayer layer = easel.add(def);
    CHECK(easel.paint().at(32, 32) == kRed);
    must(txc_image_destroy(easel.session.id(), def.image));
    CHECK(easel.paint() == Picture(64, 64, kBase));
    def.image = easel.session.image(Picture(1, 1, kBlue));
    easel.session.change(layer, def);
    CHECK(easel.paint().at(32, 32) == kBlue);
}

TEST_CASE("One picture serves many layers and targets") {
    TestSession session(make_plane());
    const TxcTarget first = session.target(32, 32);
    const TxcTarget second = session.target(64, 64);
    TxcLayerDef def = decal_def(session.image(Picture(1, 1, kRed)));
    def.filter = TXC_FILTER_NEAREST;
    session.layer(first, def);
    session.layer(first, def);
    session.layer(second, def);
    CHECK(session.paint(first).at(16, 16) == kRed);
    CHECK(session.paint(second).at(32, 32) == kRed);
}

TEST_CASE("Two targets of one material have layers of their own") {
    TestSession session(make_plane());
    const TxcTarget first = session.target(32, 32);
    const TxcTarget second = session.target(32, 32);
    CHECK(session.stats().bake_count == 1);
    session.layer(first, fill_def(1, 0, 0));
    CHECK(session.paint(first).at(3, 3) == kRed);
    CHECK(session.paint(second).at(3, 3) == Color{255, 255, 255, 255});
}

TEST_CASE("Layers made before the bake has finished are painted after it") {
    TestSession session(make_plane());
    const TxcTarget target = session.open_target(32, 32);
    session.layer(target, fill_def(0, 0, 1));
    session.bake(target);
    CHECK(session.paint(target).at(3, 3) == kBlue);
}

TEST_CASE("A layer that is hidden and shown again is not projected again") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(128, 128);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, kRed)));
    const TxcLayer layer = session.layer(target, def);
    const Picture shown = session.paint(target);
    def.visible = 0;
    must(txc_layer_update(session.id(), layer, &def));
    CHECK(session.paint(target) != shown);
    def.visible = 1;
    must(txc_layer_update(session.id(), layer, &def));
    CHECK(session.paint(target) == shown);
    CHECK(session.stats().projection_count == 1);
}

TEST_CASE("What hidden layers paint makes room for others, and comes back when they are shown") {
    TestSession session(24);
    session.add(make_plane());
    const TxcTarget target = session.target(512, 512);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, kRed)));
    resize(def, 2, 2, 2);
    const TxcLayer layer = session.layer(target, def);
    const Picture shown = session.paint(target);
    def.visible = 0;
    must(txc_layer_update(session.id(), layer, &def));
    session.paint(target);
    const std::uint32_t held = session.stats().memory_used_kib;
    std::vector<TxcImage> ballast;
    const Picture picture(256, 256);
    TxcImage image = 0;
    while (txc_image_create(session.id(), 256, 256, picture.rgba.data(), &image) == TXC_STATUS_OK)
        ballast.push_back(image);
    // The pictures took the place of the layer's tiles, 8 bytes a texel.
    for (const TxcImage one : ballast) must(txc_image_destroy(session.id(), one));
    CHECK(session.stats().memory_used_kib + 512 * 512 * 8 / 1024 <= held);
    def.visible = 1;
    must(txc_layer_update(session.id(), layer, &def));
    CHECK(session.paint(target) == shown);
    CHECK(session.stats().projection_count == 2);
}

TEST_CASE("An update that runs out of budget changes nothing, and works once there is room") {
    TestSession session(24);
    session.add(make_plane());
    const TxcTarget target = session.target(512, 512);
    const Picture before = session.paint(target);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, kRed)));
    resize(def, 2, 2, 2);
    session.layer(target, def);
    // Images until none fits: less is left than the layer's tiles take.
    std::vector<TxcImage> ballast;
    const Picture picture(256, 256);
    TxcImage image = 0;
    while (txc_image_create(session.id(), 256, 256, picture.rgba.data(), &image) == TXC_STATUS_OK)
        ballast.push_back(image);
    TxcUpdate update{};
    REQUIRE(txc_target_update(session.id(), target, TXC_NONE, &update) == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(session.read(target) == before);
    for (const TxcImage one : ballast) must(txc_image_destroy(session.id(), one));
    CHECK(session.paint(target).at(256, 256) == kRed);
}
