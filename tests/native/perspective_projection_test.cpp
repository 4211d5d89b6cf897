// The perspective projector: what it keeps, where it puts it, and how near it comes to 8 x 8 samples (spec sections 3
// to 5).
#include <doctest/doctest.h>

#include <cmath>

#include "support/comparison.h"
#include "support/projector_defs.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

/// The field of view in which `extent` metres fill the picture's height at a distance.
double fov_over(double extent, double distance) { return 2.0 * std::atan(0.5 * extent / distance) * 180.0 / kPi; }

Picture paint(TestSession& session, TxcTarget target, const TxcLayerDef& def) {
    session.set_base(target, kBase);
    const TxcLayer layer = session.layer(target, def);
    Picture picture = session.paint(target);
    must(txc_layer_destroy(session.id(), layer));
    return picture;
}

}  // namespace

TEST_CASE("A slide thrown at a plane agrees magnified and minified up to eight times") {
    Comparison plane(make_plane(), 64, 64);
    for (const double pixels_a_texel : {0.125, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
        for (const double degrees : {0.0, 20.0}) {
            CAPTURE(pixels_a_texel);
            CAPTURE(degrees);
            const auto size = static_cast<std::uint32_t>(48 * pixels_a_texel + 0.5);
            TxcLayerDef def = perspective_def(0, fov_over(0.75, 2.0), 1.0, 0.5, 4.0);
            place(def, 0.03, -0.02, 2.0);
            turn(def, 0, 0, 1, degrees);
            check(plane.paint(def, make_checker(size, size, 5)));
            check(plane.paint(def, make_gradient(size, size, true)));
        }
    }
}

TEST_CASE("A slide thrown slantwise, from near and far, wide and narrow, agrees") {
    Comparison plane(make_plane(), 160, 120);
    Random random(80);
    for (int round = 0; round < 24; ++round) {
        CAPTURE(round);
        TxcLayerDef def = perspective_def(0, random.between(15, 100), random.between(0.5, 2.0), 0.05, 5.0);
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(0.5, 1.5));
        look_at(def, random.between(-0.2, 0.2), random.between(-0.2, 0.2), 0);
        def.flip_x = round % 5 == 0 ? 1 : 0;
        def.flip_y = round % 7 == 0 ? 1 : 0;
        def.wrap = round % 4 == 3 ? TXC_WRAP_REPEAT : TXC_WRAP_NONE;
        const auto size = static_cast<std::uint32_t>(24 << random.below(4));
        check(round % 2 == 0 ? plane.paint(def, make_checker(size, size, size / 8))
                             : plane.paint(def, make_gradient(size, size, true)));
    }
}

TEST_CASE("Slides thrown at a sphere agree from every side, from outside and from within") {
    Comparison sphere(make_sphere(1.0, 32, 16), 192, 96);
    Random random(81);
    for (int round = 0; round < 20; ++round) {
        CAPTURE(round);
        TxcLayerDef def = perspective_def(0, random.between(20, 80), random.between(0.6, 1.6), 0.2, 4.0);
        const double distance = round % 4 == 0 ? 0.3 : random.between(1.5, 3.0);
        random.rotation(def.rotation);
        // Back along its own +Z, so that it looks at the middle.
        const Vec3 eye = out_of_box(def, {0, 0, distance});
        place(def, eye.x, eye.y, eye.z);
        def.backfaces = round % 4 == 0 ? 1 : 0;
        const auto size = static_cast<std::uint32_t>(16 << random.below(5));
        const Closeness closeness = round % 2 == 0 ? sphere.paint(def, make_checker(size, size, size / 8))
                                                   : sphere.paint(def, make_gradient(size, size, true));
        check(closeness, 60);
    }
}

TEST_CASE("A nearest slide agrees with the pixel under every centre") {
    Comparison plane(make_plane(), 128, 128);
    TxcLayerDef def = perspective_def(0, 40, 1.3, 0.1, 4.0);
    place(def, 0.3, -0.4, 1.0);
    look_at(def, 0.05, 0.02, 0);
    def.filter = TXC_FILTER_NEAREST;
    const Closeness closeness = plane.paint(def, make_noise(32, 24, 82, true));
    CHECK(closeness.worst <= 1);
    check(closeness, 3000);
}

TEST_CASE("A slide stands upright before its eye, and its aspect is width by height") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    Picture corners(2, 2);
    const Color top_left{255, 0, 0, 255}, top_right{0, 255, 0, 255}, low_left{0, 0, 255, 255},
        low_right{255, 255, 0, 255};
    corners.set(0, 0, top_left);
    corners.set(1, 0, top_right);
    corners.set(0, 1, low_left);
    corners.set(1, 1, low_right);
    TxcLayerDef def = perspective_def(session.image(corners), fov_over(0.5, 1.0), 2.0, 0.5, 2.0);
    def.filter = TXC_FILTER_NEAREST;
    place(def, 0, 0, 1);
    const Picture picture = paint(session, target, def);
    CHECK(picture.at(1, 17) == top_left);
    CHECK(picture.at(62, 17) == top_right);
    CHECK(picture.at(1, 46) == low_left);
    CHECK(picture.at(62, 46) == low_right);
    CHECK(picture.at(1, 15) == kBase);
    CHECK(picture.at(62, 48) == kBase);
}

TEST_CASE("Only texels between near and far are painted, measured along the eye's own axis") {
    // The plane lies 1 m before the eye everywhere, though its corners are further from the eye.
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    const TxcImage image = session.image(Picture(8, 8, kPaint));
    const auto painted = [&](double near_distance, double far_distance) {
        TxcLayerDef def = perspective_def(image, 90, 1.0, near_distance, far_distance);
        place(def, 0, 0, 1);
        return count_color(paint(session, target, def), kPaint);
    };
    CHECK(painted(0.5, 2.0) == 64 * 64);
    CHECK(painted(0.99, 1.01) == 64 * 64);
    CHECK(painted(1.01, 2.0) == 0);
    CHECK(painted(0.5, 0.99) == 0);
    CHECK(painted(0.5, 0.5) == 0);
}

TEST_CASE("What lies behind the eye is never painted") {
    // The eye stands in the middle of a cube and looks along -Z; back faces are painted too.
    const Shape cube = make_cube();
    TestSession session(cube);
    const TxcTarget target = session.target(96, 64, 0);
    TxcLayerDef def = perspective_def(session.image(Picture(4, 4, kPaint)), 170, 1.0, 1e-6, 10.0);
    def.filter = TXC_FILTER_NEAREST;
    def.backfaces = 1;
    def.angle_fade_start = def.angle_fade_end = 90.0f;
    const Picture picture = paint(session, target, def);
    const MapArrays map = session.map(target);
    std::uint32_t painted = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 96; ++x) {
            if (map.coverage_at(x, y) == 0) continue;
            if (map.position(x, y)[2] > -0.001f) CHECK_UNARY(picture.at(x, y) == kBase);
            painted += picture.at(x, y) == kPaint ? 1 : 0;
        }
    }
    CHECK(painted > 1000);
}

TEST_CASE("Each texel's angle is that of its own ray, not of the eye's axis") {
    // From 1 m above the plane's middle the ray to a texel x metres away stands atan(x) from the normal.
    TestSession session(make_plane(4.0));
    const TxcTarget target = session.target(128, 128, 0);
    TxcLayerDef def = perspective_def(session.image(Picture(4, 4, kPaint)), 150, 1.0, 0.1, 4.0);
    place(def, 0, 0, 1);
    def.angle_fade_start = 30.0f;
    def.angle_fade_end = 60.0f;
    const Picture picture = paint(session, target, def);
    for (std::uint32_t x = 0; x < 128; ++x) {
        const double off_x = (x + 0.5) / 32 - 2.0;
        const double off_y = 0.5 / 32;
        const double f = 1.0 / std::sqrt(1.0 + off_x * off_x + off_y * off_y);
        const double cos_start = std::cos(kPi / 6);
        const double expected = f >= cos_start ? 1.0 : f <= 0.5 ? 0.0 : (f - 0.5) / (cos_start - 0.5);
        const double share = (picture.at(x, 64).red - kBase.red) / static_cast<double>(kPaint.red - kBase.red);
        CHECK(std::fabs(share - expected) < 0.006);
    }
}

TEST_CASE("Texels that face away from the eye are left alone unless back faces are asked for") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(32, 32);
    TxcLayerDef def = perspective_def(session.image(Picture(4, 4, kPaint)), 90, 1.0, 0.1, 4.0);
    place(def, 0, 0, -1);
    turn(def, 0, 1, 0, 180);
    CHECK(paint(session, target, def) == Picture(32, 32, kBase));
    def.backfaces = 1;
    CHECK(paint(session, target, def).at(16, 16) == kPaint);
}

TEST_CASE("A slide's edge is antialiased by the part of the texel that it covers") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    // From texel 16.25 to texel 47.75 across.
    TxcLayerDef def =
        perspective_def(session.image(Picture(1024, 1024, kPaint)), fov_over(31.5 / 64, 1.0), 1.0, 0.1, 2.0);
    place(def, 0, 0, 1);
    const Picture picture = paint(session, target, def);
    const auto share = [&](std::uint32_t x) {
        return (picture.at(x, 32).red - kBase.red) / static_cast<double>(kPaint.red - kBase.red);
    };
    CHECK(share(15) == 0.0);
    CHECK(std::fabs(share(16) - 0.75) < 0.02);
    CHECK(share(17) == 1.0);
    CHECK(share(46) == 1.0);
    CHECK(std::fabs(share(47) - 0.75) < 0.02);
    CHECK(share(48) == 0.0);
}

TEST_CASE("The gutter is painted as its chart's continuation by a slide, too") {
    const Shape chart = make_plane(0.5, 0.0, {0.25, 0.25, 0.75, 0.75});
    TestSession cut(chart);
    TestSession whole(make_plane(1.0));
    Picture painted[2];
    MapArrays map;
    for (TestSession* session : {&cut, &whole}) {
        const TxcTarget target = session->target(64, 64, 6);
        TxcLayerDef def =
            perspective_def(session->image(make_checker(32, 32, 3, kPaint, {0, 0, 0, 255})), 60, 1, 0.1, 4);
        place(def, 0.2, 0.3, 1.0);
        look_at(def, 0, 0, 0);
        painted[session == &cut ? 0 : 1] = paint(*session, target, def);
        if (session == &cut) map = session->map(target);
    }
    std::uint32_t gutter = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const Color a = painted[0].at(x, y);
            const Color b = map.coverage_at(x, y) == 0 ? kBase : painted[1].at(x, y);
            CHECK_UNARY(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) <= 3);
            gutter += map.coverage_at(x, y) == 2 ? 1 : 0;
        }
    }
    CHECK(gutter > 700);
}

TEST_CASE("Eyes of every kind and place are survived") {
    Shape shape = make_sphere(1.0, 8, 4, {0.0, 0.0, 0.5, 1.0});
    shape.append(make_plane(1e-6, 0.0, {0.5, 0.0, 1.0, 0.5}));
    shape.append(make_plane(1e6, 0.0, {0.5, 0.5, 1.0, 1.0}));
    TestSession session(shape);
    const TxcTarget target = session.target(32, 32);
    const TxcImage images[] = {session.image(make_checker(64, 64, 3)), session.image(make_noise(1, 700, 83))};
    Random random(84);
    const auto draw = [&random](double low, double high) { return std::pow(10.0, random.between(low, high)); };
    std::uint32_t painted = 0;
    for (int round = 0; round < 400; ++round) {
        CAPTURE(round);
        const double near_distance = draw(-11.9, 2);
        TxcLayerDef def =
            perspective_def(images[round % 2], round % 2 == 0 ? draw(-20, 2.25) : random.between(1, 179.99),
                            draw(-8, 8), near_distance, near_distance + draw(-3, 11.9));
        random.rotation(def.rotation);
        for (float& coordinate : def.position_model)
            coordinate = static_cast<float>(round % 3 == 0 ? draw(-6, 11.9) : random.between(-2, 2));
        draw_switches(def, random);
        const Picture picture = paint(session, target, def);
        CHECK(count_opaque(picture) == 32 * 32);
        painted += picture == Picture(32, 32, kBase) ? 0 : 1;
    }
    CHECK(painted > 40);
}
