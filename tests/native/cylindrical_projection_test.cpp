// The cylindrical projector: a label's place, its shell, its back and its closeness to 8 x 8 samples (spec sections 3 to
// 5).
#include <doctest/doctest.h>

#include <cmath>

#include "support/comparison.h"
#include "support/projector_defs.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

Picture paint(TestSession& session, TxcTarget target, const TxcLayerDef& def) {
    session.set_base(target, kBase);
    const TxcLayer layer = session.layer(target, def);
    Picture picture = session.paint(target);
    must(txc_layer_destroy(session.id(), layer));
    return picture;
}

/// A cylinder so finely cut that a texel's angle follows from its column.
Shape round_cylinder() { return make_cylinder(1.0, 1.0, 256); }

/// The angle of a column's centre on make_cylinder, degrees, from +Z towards +X.
double column_degrees(std::uint32_t x, std::uint32_t width) {
    const double degrees = 360.0 * (x + 0.5) / width - 180.0;
    return degrees;
}

double share(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    return (picture.at(x, y).red - kBase.red) / static_cast<double>(kPaint.red - kBase.red);
}

/// A picture that goes on where it ends: its right border continues at its left one.
Picture make_round_picture(std::uint32_t width, std::uint32_t height) {
    Picture picture(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double turn = 2.0 * kPi * (x + 0.5) / width;
            const auto wave = [&](double phase) {
                return static_cast<std::uint8_t>(127.5 + 127.0 * std::sin(3 * turn + phase + 0.1 * y));
            };
            picture.set(x, y, {wave(0), wave(2), wave(4), 255});
        }
    }
    return picture;
}

Picture shifted(const Picture& picture, std::uint32_t columns) {
    Picture out(picture.width, picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) out.set((x + columns) % picture.width, y, picture.at(x, y));
    }
    return out;
}

int largest_difference(const Picture& a, const Picture& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
    return largest;
}

}  // namespace

TEST_CASE("A label round a cylinder agrees magnified and minified up to eight times") {
    Comparison cylinder(make_cylinder(1.0, 1.0, 48), 256, 48);
    for (const double pixels_a_texel : {0.125, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
        for (const double tilt : {0.0, 12.0}) {
            CAPTURE(pixels_a_texel);
            CAPTURE(tilt);
            // 128 texels of 256 round, 36 of 48 high.
            const auto width = static_cast<std::uint32_t>(128 * pixels_a_texel + 0.5);
            const auto height = static_cast<std::uint32_t>(36 * pixels_a_texel + 0.5);
            TxcLayerDef def = cylindrical_def(0, 1.0, 0.75, 180, 0.3);
            turn(def, 0, 0, 1, tilt);
            check(cylinder.paint(def, make_checker(width, height, 5)), 2000);
            check(cylinder.paint(def, make_gradient(width, height, true)), 2000);
        }
    }
}

TEST_CASE("Labels of every arc agree on a cylinder and on a sphere, their backs included") {
    Comparison cylinder(make_cylinder(1.0, 1.0, 48), 256, 40);
    Comparison sphere(make_sphere(1.0, 48, 24), 192, 96);
    Random random(90);
    for (int round = 0; round < 24; ++round) {
        const double arc = round % 3 == 0 ? 360.0 : random.between(20, 359);
        CAPTURE(round);
        CAPTURE(arc);
        TxcLayerDef def = cylindrical_def(0, 1.0, random.between(0.3, 1.4), arc, 0.35);
        turn(def, 0, 1, 0, random.between(0, 360));
        def.wrap = round % 2 == 0 ? TXC_WRAP_REPEAT : TXC_WRAP_NONE;
        def.flip_x = random.below(2);
        def.flip_y = random.below(2);
        const auto size = static_cast<std::uint32_t>(24 << random.below(4));
        const Picture picture =
            random.coin() ? make_checker(size * 3, size, size / 4) : make_gradient(size * 3, size, true);
        check(cylinder.paint(def, picture), 300);
        check(sphere.paint(def, picture), 300);
    }
}

TEST_CASE("A label about any axis agrees") {
    Comparison sphere(make_sphere(1.0, 48, 24), 192, 96);
    Random random(91);
    for (int round = 0; round < 12; ++round) {
        CAPTURE(round);
        TxcLayerDef def = cylindrical_def(0, 0.9, 1.0, random.between(60, 360), 0.5);
        random.rotation(def.rotation);
        place(def, random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.between(-0.2, 0.2));
        check(sphere.paint(def, make_checker(96, 32, 8)), 300);
    }
}

TEST_CASE("A nearest label agrees with the pixel under every centre, all the way round") {
    Comparison cylinder(make_cylinder(1.0, 1.0, 48), 250, 48);
    for (const double arc : {120.0, 360.0}) {
        TxcLayerDef def = cylindrical_def(0, 1.0, 0.8, arc, 0.3);
        turn(def, 0, 1, 0, 77);
        def.filter = TXC_FILTER_NEAREST;
        const Closeness closeness = cylinder.paint(def, make_noise(61, 17, 92, true));
        CHECK(closeness.worst <= 1);
        check(closeness, 2500);
    }
}

TEST_CASE("A label is read from outside: its left towards -X, its top towards +Y, its middle at +Z") {
    TestSession session(round_cylinder());
    const TxcTarget target = session.target(256, 32, 0);
    Picture corners(2, 2);
    const Color top_left{255, 0, 0, 255}, top_right{0, 255, 0, 255}, low_left{0, 0, 255, 255},
        low_right{255, 255, 0, 255};
    corners.set(0, 0, top_left);
    corners.set(1, 0, top_right);
    corners.set(0, 1, low_left);
    corners.set(1, 1, low_right);
    TxcLayerDef def = cylindrical_def(session.image(corners), 1.0, 0.5, 90, 0.1);
    def.filter = TXC_FILTER_NEAREST;
    const Picture picture = paint(session, target, def);
    for (std::uint32_t x = 0; x < 256; ++x) {
        // -X is at -90 degrees.
        const double degrees = column_degrees(x, 256);
        const bool inside = std::fabs(degrees) < 45.0;
        CHECK_UNARY(picture.at(x, 12) == (!inside ? kBase : degrees < 0 ? top_left : top_right));
        CHECK_UNARY(picture.at(x, 20) == (!inside ? kBase : degrees < 0 ? low_left : low_right));
        CHECK_UNARY(picture.at(x, 6) == kBase);
        CHECK_UNARY(picture.at(x, 25) == kBase);
    }
}

TEST_CASE("A label all the way round has no seam at its back, however it is turned") {
    TestSession session(round_cylinder());
    const TxcTarget target = session.target(300, 40, 0);
    for (const std::uint32_t wrap : {TXC_WRAP_NONE, TXC_WRAP_REPEAT}) {
        for (const std::uint32_t width : {1u, 4u, 7u, 64u, 301u, 2048u}) {
            // One colour is one colour, at the back as well.
            TxcLayerDef def = cylindrical_def(session.image(Picture(width, 4, kPaint)), 1.0, 4.0, 360, 0.1);
            def.wrap = wrap;
            for (const double degrees : {0.0, 60.0, 90.0, 90.1, 91.5, 211.0}) {
                CAPTURE(wrap);
                CAPTURE(width);
                CAPTURE(degrees);
                turn(def, 0, 1, 0, degrees);
                CHECK(count_color(paint(session, target, def), kPaint) == 300 * 40);
            }
        }
    }
}

TEST_CASE("A round picture lies the same wherever its ends meet") {
    TestSession session(round_cylinder());
    const TxcTarget target = session.target(250, 40, 0);
    for (const std::uint32_t wrap : {TXC_WRAP_NONE, TXC_WRAP_REPEAT}) {
        for (const std::uint32_t width : {24u, 120u, 240u, 1200u}) {
            CAPTURE(wrap);
            CAPTURE(width);
            const Picture picture = make_round_picture(width, 16);
            TxcLayerDef def = cylindrical_def(session.image(picture), 1.0, 0.8, 360, 0.1);
            def.wrap = wrap;
            const Picture expected = paint(session, target, def);
            // Turned by three eighths of a turn, and the picture as much back.
            def.image = session.image(shifted(picture, width / 8 * 5));
            turn(def, 0, 1, 0, 135);
            CHECK(largest_difference(paint(session, target, def), expected) <= 2);
        }
    }
}

TEST_CASE("Both ends of a label that nearly closes are antialiased, and nothing shows between them") {
    TestSession session(round_cylinder());
    const TxcTarget target = session.target(256, 8, 0);
    for (const std::uint32_t wrap : {TXC_WRAP_NONE, TXC_WRAP_REPEAT}) {
        CAPTURE(wrap);
        TxcLayerDef def = cylindrical_def(session.image(Picture(4096, 4, kPaint)), 1.0, 4.0, 360, 0.1);
        def.wrap = wrap;
        const auto painted = [&](double gap_texels, double degrees) {
            def.arc_degrees = static_cast<float>(360.0 - gap_texels * 360 / 256);
            turn(def, 0, 1, 0, degrees);
            return paint(session, target, def);
        };
        // The gap's middle is at the middle of texel 64 at first, half a texel further in the end. A plain picture fades
        // over the half of its pixels, of which 16 make a texel.
        const double fade = 0.02;
        const double step = 360.0 / 256;
        Picture picture = painted(3.0, 90 + 0.5 * step);
        CHECK(share(picture, 62, 4) >= 1.0 - fade);
        CHECK(share(picture, 63, 4) <= fade);
        CHECK(share(picture, 64, 4) == 0.0);
        CHECK(share(picture, 65, 4) <= fade);
        CHECK(share(picture, 66, 4) >= 1.0 - fade);
        picture = painted(3.0, 90.0 + step);
        CHECK(std::fabs(share(picture, 63, 4) - 0.5) < 0.03);
        CHECK(share(picture, 64, 4) == 0.0);
        CHECK(share(picture, 65, 4) == 0.0);
        CHECK(std::fabs(share(picture, 66, 4) - 0.5) < 0.03);
        // A gap in the middle of one texel, which sees both ends.
        picture = painted(0.5, 90 + 0.5 * step);
        CHECK(share(picture, 63, 4) == 1.0);
        CHECK(std::fabs(share(picture, 64, 4) - 0.5) < 0.03);
        CHECK(share(picture, 65, 4) == 1.0);
    }
}

TEST_CASE("Only texels in the shell about the radius are painted, the inner wall when back faces are asked for") {
    // Three walls in one texture, each facing outward: at 0.5, 1 and 1.5 m; and one at 0.9 that faces inward.
    Shape shape = make_cylinder(0.5, 1.0, 48, {0.0, 0.0, 1.0, 0.25});
    shape.append(make_cylinder(1.0, 1.0, 48, {0.0, 0.25, 1.0, 0.5}));
    shape.append(make_cylinder(1.5, 1.0, 48, {0.0, 0.5, 1.0, 0.75}));
    Shape inward = make_cylinder(0.9, 1.0, 48, {0.0, 0.75, 1.0, 1.0});
    for (float& part : inward.normals) part = -part;
    for (std::size_t i = 0; i < inward.indices.size(); i += 3) std::swap(inward.indices[i], inward.indices[i + 1]);
    shape.append(inward);
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64, 0);
    const TxcImage image = session.image(Picture(4, 4, kPaint));
    const auto walls = [&](double radius, double depth, std::uint32_t backfaces) {
        TxcLayerDef def = cylindrical_def(image, radius, 2.0, 360, depth);
        def.backfaces = backfaces;
        const Picture picture = paint(session, target, def);
        std::uint32_t painted = 0;
        for (std::uint32_t wall = 0; wall < 4; ++wall) {
            std::uint32_t texels = 0;
            for (std::uint32_t x = 0; x < 64; ++x) texels += picture.at(x, wall * 16 + 8) == kPaint ? 1 : 0;
            CHECK((texels == 0 || texels == 64));
            painted |= texels == 64 ? 1u << wall : 0;
        }
        return painted;
    };
    CHECK(walls(1.0, 0.2, 0) == 0b0010);
    CHECK(walls(1.0, 0.2, 1) == 0b1010);
    CHECK(walls(1.0, 0.6, 0) == 0b0111);
    CHECK(walls(0.5, 0.1, 1) == 0b0001);
    CHECK(walls(1.5, 0.1, 1) == 0b0100);
    CHECK(walls(0.2, 0.1, 1) == 0);
    // Deeper than the radius: the shell is then the whole inside.
    CHECK(walls(0.2, 0.5, 0) == 0b0001);
    CHECK(walls(3.0, 0.5, 1) == 0);
}

TEST_CASE("The angle is that between the normal and the way straight out from the axis") {
    // Flat walls of a hexagon: the ray turns within a wall, its normal does not.
    Shape hexagon = make_cylinder(1.0, 1.0, 6);
    hexagon.normals.clear();
    // Unshared corners, so that each wall has its own flat normal.
    TestSession session(hexagon);
    const TxcTarget target = session.target(192, 8, 0);
    TxcLayerDef def = cylindrical_def(session.image(Picture(4, 4, kPaint)), 0.95, 2.0, 360, 0.2);
    def.angle_fade_start = 10.0f;
    def.angle_fade_end = 25.0f;
    const Picture picture = paint(session, target, def);
    const MapArrays map = session.map(target);
    for (std::uint32_t x = 0; x < 192; ++x) {
        const float* p = map.position(x, 4);
        const float* n = map.normal(x, 4);
        const double from_axis = std::hypot(static_cast<double>(p[0]), static_cast<double>(p[2]));
        const double f = (static_cast<double>(n[0]) * p[0] + static_cast<double>(n[2]) * p[2]) / from_axis;
        const double start = std::cos(10 * kPi / 180);
        const double end = std::cos(25 * kPi / 180);
        const double expected = f >= start ? 1.0 : f <= end ? 0.0 : (f - end) / (start - end);
        CHECK(std::fabs(share(picture, x, 4) - expected) < 0.006);
    }
}

TEST_CASE("On the axis nothing is painted, and beside it no number overflows") {
    // A plane across the axis whose normals all point to +Z, so that its +Z half faces outward.
    Shape plane = make_plane();
    for (std::size_t v = 0; v < plane.positions.size(); v += 3) plane.positions[v + 2] = plane.positions[v + 1];
    TestSession session(plane);
    // An odd number of texels: one lies on the axis.
    const TxcTarget target = session.target(65, 65, 0);
    for (const std::uint32_t filter : {TXC_FILTER_LINEAR, TXC_FILTER_NEAREST}) {
        for (const std::uint32_t wrap : {TXC_WRAP_NONE, TXC_WRAP_REPEAT}) {
            for (const double arc : {360.0, 200.0}) {
                TxcLayerDef def = cylindrical_def(session.image(Picture(64, 64, kPaint)), 0.5, 4.0, arc, 0.5);
                def.filter = filter;
                def.wrap = wrap;
                def.backfaces = 1;
                def.angle_fade_start = def.angle_fade_end = 90.0f;
                const Picture picture = paint(session, target, def);
                CHECK(picture.at(32, 32) == kBase);
                CHECK(picture.at(32, 20) == kPaint);
            }
        }
    }
}

TEST_CASE("Labels of every kind and place are survived") {
    Shape shape = make_sphere(1.0, 8, 4, {0.0, 0.0, 0.5, 1.0});
    shape.append(make_plane(1e-6, 0.0, {0.5, 0.0, 1.0, 0.5}));
    shape.append(make_plane(1e6, 0.0, {0.5, 0.5, 1.0, 1.0}));
    TestSession session(shape);
    const TxcTarget target = session.target(32, 32);
    const TxcImage images[] = {session.image(make_checker(64, 64, 3)), session.image(make_noise(1, 700, 93))};
    Random random(94);
    const auto draw = [&random](double low, double high) { return std::pow(10.0, random.between(low, high)); };
    std::uint32_t painted = 0;
    for (int round = 0; round < 400; ++round) {
        CAPTURE(round);
        TxcLayerDef def = cylindrical_def(images[round % 2], draw(-12, 11.9), draw(-12, 11.9),
                                          round % 4 == 0 ? 360.0 : draw(-20, 2.5), draw(-12, 11.9));
        random.rotation(def.rotation);
        for (float& coordinate : def.position_model)
            coordinate = static_cast<float>(round % 3 == 0 ? draw(-6, 11.9) : random.between(-1, 1));
        draw_switches(def, random);
        const Picture picture = paint(session, target, def);
        CHECK(count_opaque(picture) == 32 * 32);
        painted += picture == Picture(32, 32, kBase) ? 0 : 1;
    }
    CHECK(painted > 20);
}
