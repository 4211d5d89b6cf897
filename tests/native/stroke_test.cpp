// What a stroke paints: flow, opacity, tips, and that only what is new is painted (texelcast.h, "Strokes").
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/strokes.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 128;
constexpr Color kWhite{255, 255, 255, 255};

/// A plane of one metre, facing +Z, on a white texture: texel (x, y) lies at ((x + 1/2) / kSize - 1/2, 1/2 - ...).
class Canvas {
public:
    explicit Canvas(Color base = kWhite) : session_(make_plane()), target_(session_.target(kSize, kSize)) {
        session_.set_base(target_, base);
        session_.update(target_);
    }

    TxcLayer stroke(const TxcLayerDef& def, const std::vector<TxcDab>& dabs) {
        const TxcLayer layer = session_.layer(target_, def);
        add_dabs(session_, layer, dabs);
        return layer;
    }
    Picture paint() { return session_.paint(target_); }
    TestSession& session() { return session_; }
    TxcTarget target() const { return target_; }

private:
    TestSession session_;
    TxcTarget target_;
};

Picture paint_stroke(const TxcLayerDef& def, const std::vector<TxcDab>& dabs, Color base = kWhite) {
    Canvas canvas(base);
    canvas.stroke(def, dabs);
    return canvas.paint();
}

/// Distance of a texel's centre from the middle of the plane, texels.
double radius_of(std::uint32_t x, std::uint32_t y) { return std::hypot(x + 0.5 - kSize / 2.0, y + 0.5 - kSize / 2.0); }

constexpr std::uint32_t kMiddle = kSize / 2;

/// Brushes and dabs of every sort.
struct AnyStroke {
    TxcLayerDef def;
    std::vector<TxcDab> dabs;
};

AnyStroke any_stroke(Random& random, TxcImage image) {
    AnyStroke stroke{stroke_def(random.unit(), random.between(0.1, 1)), {}};
    stroke.def.tip = random.below(TXC_TIP_COUNT);
    stroke.def.image = image;
    stroke.def.opacity = static_cast<float>(random.between(0.3, 1));
    draw_switches(stroke.def, random);
    for (float& channel : stroke.def.color) channel = static_cast<float>(random.unit());
    for (std::uint32_t count = 2 + random.below(30); count > 0; --count) {
        TxcDab dab =
            dab_at(random.between(-0.6, 0.6), random.between(-0.6, 0.6), random.between(0.05, 0.5), random.unit());
        dab.projector = random.below(TXC_PROJECTOR_COUNT);
        dab.position_model[2] = static_cast<float>(random.between(0, 0.1));
        dab.near_distance = 0.01f;
        dab.uv_center[0] = static_cast<float>(random.unit());
        dab.uv_size[0] = dab.uv_size[1] = 0.25f;
        stroke.dabs.push_back(dab);
    }
    return stroke;
}

}  // namespace

TEST_CASE("Opacity does not build up under the stroke itself") {
    TxcLayerDef def = stroke_def();
    def.opacity = 0.5f;
    std::vector<TxcDab> dabs;
    for (int i = 0; i < 9; ++i) dabs.push_back(dab_at(-0.2 + 0.05 * i, 0, 0.25));
    const Picture picture = paint_stroke(def, dabs);
    const Picture single = paint_stroke(def, {dab_at(0, 0, 0.25)});
    const Color inked = single.at(kMiddle, kMiddle);
    CHECK(inked == Color{128, 128, 128, 255});
    for (std::uint32_t x = 40; x < 88; ++x) CHECK(picture.at(x, kMiddle) == inked);
    // Nothing anywhere is darker than one layer of ink.
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) CHECK(picture.rgba[i] >= inked.red);
}

TEST_CASE("Flow builds up: n dabs of flow f leave (1 - f)^n of the ground") {
    for (const double flow : {1.0 / 255, 0.05, 0.2, 0.5, 0.9, 1.0}) {
        Canvas canvas;
        const TxcLayer layer = canvas.stroke(stroke_def(1.0, flow), {});
        for (int n = 1; n <= 60; ++n) {
            add_dabs(canvas.session(), layer, {dab_at(0, 0, 0.25)});
            CAPTURE(flow);
            CAPTURE(n);
            const double left = 255.0 * std::pow(1.0 - flow, n);
            CHECK(std::fabs(canvas.paint().at(kMiddle, kMiddle).red - left) <= 1.0);
        }
    }
}

TEST_CASE("A dab's own flow is a share of the brush's, and one of 0 paints nothing") {
    const Picture by_brush = paint_stroke(stroke_def(0.5, 0.25), {dab_at(0, 0, 0.5)});
    const Picture by_dab = paint_stroke(stroke_def(0.5, 1.0), {dab_at(0, 0, 0.5, 0.25)});
    const Picture by_both = paint_stroke(stroke_def(0.5, 0.5), {dab_at(0, 0, 0.5, 0.5)});
    CHECK(count_differences(by_brush, by_dab) == 0);
    CHECK(count_differences(by_brush, by_both) == 0);
    CHECK(count_color(paint_stroke(stroke_def(), {dab_at(0, 0, 0.5, 0.0)}), kWhite) == kSize * kSize);
    CHECK(count_color(paint_stroke(stroke_def(1.0, 0.0), {dab_at(0, 0, 0.5)}), kWhite) == kSize * kSize);
}

TEST_CASE("Of a picture at full flow one dab paints what a decal paints") {
    Canvas canvas;
    const TxcImage image = canvas.session().image(make_gradient(20, 30, true));
    for (std::uint32_t projector = 0; projector < TXC_PROJECTOR_COUNT; ++projector) {
        TxcLayerDef decal = decal_def(image);
        decal.projector = projector;
        resize(decal, 0.5, 0.25, 0.5);
        // The eye before the plane, the cylinder's axis behind it.
        const double z = projector == TXC_PROJECTOR_PERSPECTIVE ? 0.125 : -0.2;
        place(decal, 0, 0, z);
        const TxcLayer layer = canvas.session().layer(canvas.target(), decal);
        const Picture expected = canvas.paint();
        must(txc_layer_destroy(canvas.session().id(), layer));
        TxcLayerDef def = stroke_def();
        def.tip = TXC_TIP_PICTURE;
        def.image = image;
        TxcDab dab = dab_at(0, 0, 0.5);
        dab.projector = projector;
        dab.size[1] = 0.25f;
        dab.position_model[2] = static_cast<float>(z);
        const TxcLayer stroke = canvas.stroke(def, {dab});
        CAPTURE(projector);
        CHECK(count_color(expected, kWhite) < kSize * kSize);
        CHECK(count_differences(canvas.paint(), expected) == 0);
        must(txc_layer_destroy(canvas.session().id(), stroke));
    }
}

TEST_CASE("A mask paints its picture's alpha in the brush's colour") {
    Canvas canvas;
    Picture picture = make_noise(16, 16, 300);
    TxcLayerDef def = stroke_def();
    def.tip = TXC_TIP_MASK;
    def.image = canvas.session().image(picture);
    const Color ink{51, 102, 204, 255};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        picture.rgba[i] = ink.red;
        picture.rgba[i + 1] = ink.green;
        picture.rgba[i + 2] = ink.blue;
    }
    for (int c = 0; c < 3; ++c) def.color[c] = static_cast<float>(c == 0 ? 0.2 : c == 1 ? 0.4 : 0.8);
    const TxcLayer layer = canvas.stroke(def, {dab_at(0, 0, 0.75)});
    const Picture masked = canvas.paint();
    def.tip = TXC_TIP_PICTURE;
    def.image = canvas.session().image(picture);
    canvas.session().change(layer, def);
    const Picture coloured = canvas.paint();
    CHECK(count_color(masked, kWhite) < kSize * kSize);
    for (std::size_t i = 0; i < masked.rgba.size(); ++i) CHECK(std::abs(masked.rgba[i] - coloured.rgba[i]) <= 1);
}

TEST_CASE("Hardness 1 is a disc with an antialiased edge") {
    const Picture picture = paint_stroke(stroke_def(), {dab_at(0, 0, 0.5)});
    double area = 0.0;
    std::uint32_t between = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::uint8_t value = picture.at(x, y).red;
            const double radius = radius_of(x, y);
            if (radius < 30.5) CHECK(value == 0);
            if (radius > 33.5) CHECK(value == 255);
            between += value != 0 && value != 255 ? 1 : 0;
            area += (255 - value) / 255.0;
        }
    }
    CHECK(between > 150);
    CHECK(std::fabs(area / (kPi * 32 * 32) - 1.0) < 0.003);
}

TEST_CASE("A hard edge is as sharp under a small dab as under a large one") {
    for (const double texels : {6.0, 15.0, 40.0, 77.0, 110.0}) {
        CAPTURE(texels);
        const Picture picture = paint_stroke(stroke_def(), {dab_at(0, 0, texels / kSize)});
        double area = 0.0;
        std::uint32_t between = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
            area += (255 - picture.rgba[i]) / 255.0;
            between += picture.rgba[i] != 0 && picture.rgba[i] != 255 ? 1 : 0;
        }
        // A band of three texels or less along the rim.
        CHECK(between < 3 * kPi * texels);
        CHECK(std::fabs(area / (kPi * texels * texels / 4) - 1.0) < 0.01);
    }
}

TEST_CASE("Hardness 0 falls smoothly from the middle to the rim") {
    const Picture picture = paint_stroke(stroke_def(0.0), {dab_at(0, 0, 0.5)});
    CHECK(picture.at(kMiddle, kMiddle).red <= 1);
    for (std::uint32_t x = kMiddle; x + 1 < kSize; ++x) {
        const int step = picture.at(x + 1, kMiddle).red - picture.at(x, kMiddle).red;
        CHECK(step >= 0);
        CHECK(step <= 13);  // at its steepest 3/2 of 255 / 32
    }
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const double t = std::min(radius_of(x, y) / 32.0, 1.0);
            CHECK(std::fabs(picture.at(x, y).red - 255.0 * t * t * (3 - 2 * t)) <= 2.0);
        }
    }
}

TEST_CASE("Hardness is the share of the radius that is solid") {
    const Picture picture = paint_stroke(stroke_def(0.5), {dab_at(0, 0, 0.5)});
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            if (radius_of(x, y) < 15) CHECK(picture.at(x, y).red == 0);
            if (radius_of(x, y) > 33) CHECK(picture.at(x, y).red == 255);
        }
    }
    CHECK(picture.at(kMiddle + 24, kMiddle).red > 100);
    CHECK(picture.at(kMiddle + 24, kMiddle).red < 155);
}

TEST_CASE("A round tip is the same from all sides") {
    const Picture picture = paint_stroke(stroke_def(0.3), {dab_at(0, 0, 0.5)});
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            CHECK(std::abs(picture.at(x, y).red - picture.at(y, x).red) <= 1);
            CHECK(std::abs(picture.at(x, y).red - picture.at(kSize - 1 - x, y).red) <= 1);
        }
    }
}

TEST_CASE("An erasing stroke takes alpha away, as far as its flow and its opacity go, and leaves colour") {
    TxcLayerDef def = stroke_def(1.0, 0.5);
    def.blend = TXC_BLEND_ERASE;
    const Color base{200, 100, 50, 255};
    const Color half = paint_stroke(def, {dab_at(0, 0, 0.25)}, base).at(kMiddle, kMiddle);
    CHECK(half.red == base.red);
    CHECK(std::abs(half.alpha - 128) <= 1);
    const Color quarter = paint_stroke(def, {dab_at(0, 0, 0.25), dab_at(0, 0, 0.25)}, base).at(kMiddle, kMiddle);
    CHECK(std::abs(quarter.alpha - 64) <= 1);
    def.flow = 1.0f;
    const Picture erased = paint_stroke(def, {dab_at(0, 0, 0.25)}, base);
    CHECK(erased.at(kMiddle, kMiddle) == Color{200, 100, 50, 0});
    CHECK(erased.at(2, 2) == base);
    def.opacity = 0.25f;
    CHECK(paint_stroke(def, {dab_at(0, 0, 0.25), dab_at(0, 0, 0.25)}, base).at(kMiddle, kMiddle) ==
          Color{200, 100, 50, 191});
}

TEST_CASE("Dabs in many calls, with updates between them or not, give the bytes of one call") {
    Random random(301);
    for (int round = 0; round < 20; ++round) {
        Canvas whole;
        Canvas parts;
        const TxcImage image = whole.session().image(make_noise(9, 7, 302));
        const TxcImage same_image = parts.session().image(make_noise(9, 7, 302));
        AnyStroke stroke = any_stroke(random, image);
        whole.stroke(stroke.def, stroke.dabs);
        stroke.def.image = same_image;
        const TxcLayer layer = parts.stroke(stroke.def, {});
        for (std::size_t done = 0; done < stroke.dabs.size();) {
            const std::size_t count = std::min<std::size_t>(1 + random.below(5), stroke.dabs.size() - done);
            const auto first = stroke.dabs.begin() + static_cast<std::ptrdiff_t>(done);
            add_dabs(parts.session(), layer, std::vector<TxcDab>(first, first + static_cast<std::ptrdiff_t>(count)));
            if (random.coin()) parts.session().update(parts.target());
            done += count;
        }
        CHECK(count_differences(parts.paint(), whole.paint()) == 0);
    }
}

TEST_CASE("A dab that is added is painted alone, and only its tiles are composited") {
    Canvas canvas;
    std::vector<TxcDab> dabs;
    for (int i = 0; i < 40; ++i) dabs.push_back(dab_at(-0.4 + 0.02 * i, -0.3, 0.2));
    const TxcLayer layer = canvas.stroke(stroke_def(), dabs);
    canvas.paint();
    const TxcDab added = dab_at(0.3, 0.3, 0.1);
    add_dabs(canvas.session(), layer, {added});
    const TxcUpdate update = canvas.session().update(canvas.target());
    CHECK(update.projected_layers == 1);
    CHECK(update.projected_texels < 16 * 16);
    CHECK(update.composited_texels <= 4 * 16 * 16);
    CHECK(update.rect_count == 1);
    const TxcUpdate quiet = canvas.session().update(canvas.target());
    CHECK(quiet.projected_layers == 0);
    CHECK(quiet.composited_texels == 0);
}

TEST_CASE("A brush that changes repaints the whole stroke, and opacity and blend do not") {
    Canvas canvas;
    const TxcImage image = canvas.session().image(make_noise(9, 7, 303));
    const std::vector<TxcDab> dabs = {dab_at(-0.2, 0, 0.4), dab_at(0, 0.1, 0.4), dab_at(0.2, 0, 0.4)};
    TxcLayerDef def = stroke_def();
    def.image = image;
    const TxcLayer layer = canvas.stroke(def, dabs);
    canvas.paint();
    const auto projects = [&](auto&& change) {
        change();
        canvas.session().change(layer, def);
        const bool projected = canvas.session().update(canvas.target()).projected_layers == 1;
        Canvas fresh;
        TxcLayerDef same = def;
        same.image = fresh.session().image(make_noise(9, 7, 303));
        fresh.stroke(same, dabs);
        CHECK(count_differences(canvas.session().read(canvas.target()), fresh.paint()) == 0);
        return projected;
    };
    CHECK(projects([&] { def.hardness = 0.25f; }));
    CHECK(projects([&] { def.flow = 0.75f; }));
    CHECK(projects([&] { def.color[0] = 0.5f; }));
    CHECK(projects([&] { def.tip = TXC_TIP_MASK; }));
    CHECK(projects([&] { def.tip = TXC_TIP_PICTURE; }));
    CHECK(projects([&] { def.filter = TXC_FILTER_NEAREST; }));
    CHECK(projects([&] { def.flip_x = 1; }));
    CHECK(projects([&] { def.backfaces = 1; }));
    CHECK_FALSE(projects([&] { def.opacity = 0.5f; }));
    CHECK_FALSE(projects([&] { def.blend = TXC_BLEND_MULTIPLY; }));
    CHECK_FALSE(projects([&] { def.position_model[0] = 9; }));
}

TEST_CASE("A stroke without dabs, cleared or without its picture leaves the texture as it was") {
    Canvas canvas;
    const Picture before = canvas.paint();
    TxcLayerDef def = stroke_def();
    const TxcLayer layer = canvas.stroke(def, {});
    CHECK(count_differences(canvas.paint(), before) == 0);
    add_dabs(canvas.session(), layer, {dab_at(0, 0, 0.5)});
    CHECK(count_differences(canvas.paint(), before) > 500);
    must(txc_stroke_clear(canvas.session().id(), layer));
    CHECK(count_differences(canvas.paint(), before) == 0);
    const TxcImage image = canvas.session().image(make_noise(4, 4, 304));
    def.tip = TXC_TIP_PICTURE;
    def.image = image;
    canvas.session().change(layer, def);
    add_dabs(canvas.session(), layer, {dab_at(0, 0, 0.5)});
    const Picture painted = canvas.paint();
    CHECK(count_differences(painted, before) > 500);
    must(txc_image_destroy(canvas.session().id(), image));
    CHECK(count_differences(canvas.paint(), before) == 0);
    def.image = canvas.session().image(make_noise(4, 4, 304));
    canvas.session().change(layer, def);
    CHECK(count_differences(canvas.paint(), painted) == 0);
}

TEST_CASE("A hidden stroke takes dabs and paints them when it is shown") {
    Canvas canvas;
    TxcLayerDef def = stroke_def();
    def.visible = 0;
    const TxcLayer layer = canvas.stroke(def, {dab_at(0, 0, 0.5)});
    CHECK(canvas.session().update(canvas.target()).projected_layers == 0);
    add_dabs(canvas.session(), layer, {dab_at(0.2, 0, 0.5)});
    def.visible = 1;
    canvas.session().change(layer, def);
    const Picture expected = paint_stroke(def, {dab_at(0, 0, 0.5), dab_at(0.2, 0, 0.5)});
    CHECK(count_differences(canvas.paint(), expected) == 0);
}

TEST_CASE("A layer that stops being a stroke loses its dabs") {
    Canvas canvas;
    const TxcLayer layer = canvas.stroke(stroke_def(), {dab_at(0, 0, 0.5)});
    canvas.paint();
    canvas.session().change(layer, fill_def(0, 0, 0, 0));
    CHECK(count_color(canvas.paint(), kWhite) == kSize * kSize);
    canvas.session().change(layer, stroke_def());
    std::uint32_t count = 9;
    must(txc_stroke_dab_count(canvas.session().id(), layer, &count));
    CHECK(count == 0);
    CHECK(count_color(canvas.paint(), kWhite) == kSize * kSize);
}

TEST_CASE("A stroke across a seam is whole on both charts") {
    // Two halves of one plane, apart in the texture.
    Shape halves;
    for (const double side : {-1.0, 1.0}) {
        const double left = side < 0 ? 0.05 : 0.55;
        halves.append(
            make_grid(1, 1, {left, 0.05, left + 0.4, 0.95}, [=](double s, double t, double(&p)[3], double(&n)[3]) {
                p[0] = (side < 0 ? s - 1.0 : s) * 0.4;
                p[1] = (0.5 - t) * 0.9;
                p[2] = n[0] = n[1] = 0.0;
                n[2] = 1.0;
            }));
    }
    TestSession session(halves);
    const TxcTarget target = session.target(200, 200);
    const TxcLayer layer = session.layer(target, stroke_def());
    std::vector<TxcDab> dabs;
    for (int i = 0; i <= 60; ++i) dabs.push_back(dab_at(-0.3 + 0.01 * i, 0.1, 0.2));
    add_dabs(session, layer, dabs);
    const Picture picture = session.paint(target);
    const MapArrays map = session.map(target);
    std::uint32_t inside[2] = {0, 0};
    for (std::uint32_t y = 0; y < 200; ++y) {
        for (std::uint32_t x = 0; x < 200; ++x) {
            if (map.coverage_at(x, y) != 1) continue;
            const float* p = map.position(x, y);
            const double along = std::clamp(static_cast<double>(p[0]), -0.3, 0.3);
            const double distance = std::hypot(p[0] - along, p[1] - 0.1);
            if (distance < 0.09) {
                CHECK(picture.at(x, y) == Color{0, 0, 0, 255});
                ++inside[p[0] < 0 ? 0 : 1];
            }
            if (distance > 0.11) CHECK(picture.at(x, y) == kWhite);
        }
    }
    CHECK(inside[0] > 2500);
    CHECK(std::abs(static_cast<int>(inside[0] - inside[1])) < 300);
}

TEST_CASE("A dab stays on the surface that it sees: what lies behind is hidden unless occlusion is off") {
    Shape shape = make_plane(1.0, 0.0, {0, 0, 0.5, 1});
    shape.append(make_plane(1.0, 0.3, {0.5, 0, 1, 1}));
    TestSession session(shape);
    const TxcTarget target = session.target(128, 64);
    TxcLayerDef def = stroke_def();
    def.occlusion = TXC_OCCLUSION_SELF;
    const TxcLayer layer = session.layer(target, def);
    TxcDab dab = dab_at(0, 0, 0.5);
    dab.size[2] = 2.0f;
    add_dabs(session, layer, {dab});
    Picture picture = session.paint(target);
    CHECK(picture.at(32, 32) == kWhite);
    CHECK(picture.at(96, 32) == Color{0, 0, 0, 255});
    def.occlusion = TXC_OCCLUSION_NONE;
    session.change(layer, def);
    picture = session.paint(target);
    CHECK(picture.at(32, 32) == Color{0, 0, 0, 255});
    CHECK(picture.at(96, 32) == Color{0, 0, 0, 255});
}
