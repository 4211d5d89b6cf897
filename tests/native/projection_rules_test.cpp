// Which texels a planar decal keeps, and what it gives them, rule by rule (spec sections 3 to 5).
#include <doctest/doctest.h>

#include <cmath>

#include "support/random.h"
#include "support/reference_map.h"
#include "support/reference_projector.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

/// A session on one shape with one square target and a base of one colour.
struct Easel {
    TestSession session;
    TxcTarget target;
    explicit Easel(const Shape& shape, std::uint32_t size = 64, std::uint32_t gutter = TXC_NONE)
        : session(shape), target(session.target(size, size, gutter)) {
        session.set_base(target, kBase);
    }
    TxcLayerDef solid() { return decal_def(session.image(Picture(8, 8, kPaint))); }
    Picture paint(const TxcLayerDef& def) {
        const TxcLayer layer = session.layer(target, def);
        Picture picture = session.paint(target);
        must(txc_layer_destroy(session.id(), layer));
        return picture;
    }
};

/// How much of the paint lies on a texel, 0 to 1.
double share(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    return (picture.at(x, y).red - kBase.red) / static_cast<double>(kPaint.red - kBase.red);
}

/// A unit plane turned about the X axis so that its normal stands `degrees` from +Z.
Shape make_tilted_plane(double degrees) {
    Shape plane = make_plane();
    const double c = std::cos(degrees * kPi / 180.0);
    const double s = std::sin(degrees * kPi / 180.0);
    for (std::size_t v = 0; v < plane.positions.size(); v += 3) {
        const double y = plane.positions[v + 1];
        plane.positions[v + 1] = static_cast<float>(y * c);
        plane.positions[v + 2] = static_cast<float>(y * s);
        plane.normals[v + 1] = static_cast<float>(-s);
        plane.normals[v + 2] = static_cast<float>(c);
    }
    return plane;
}

/// Slopes from left to right and from top to bottom are painted on a shape in the plane of X and Y: how far the worst covered
/// texel is from the colour at its own place, in steps of 255.
double farthest_from_slope(const Shape& shape) {
    constexpr std::uint32_t kSize = 160;
    constexpr double kWidth = 1.25;
    double worst = 0.0;
    for (const std::uint32_t side : {24u, 64u, 128u}) {
        Picture slope(side, side);
        const auto channel = [&](std::uint32_t at) { return static_cast<std::uint8_t>((at * 510 + 255) / (2 * side)); };
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) slope.set(x, y, {channel(x), channel(y), 128, 255});
        Easel easel(shape, kSize, 0);
        TxcLayerDef def = decal_def(easel.session.image(slope));
        def.size[0] = def.size[1] = static_cast<float>(kWidth);
        const Picture painted = easel.paint(def);
        const MapArrays map = easel.session.map(easel.target);
        std::uint32_t covered = 0;
        for (std::uint32_t y = 0; y < kSize; ++y) {
            for (std::uint32_t x = 0; x < kSize; ++x) {
                if (map.coverage_at(x, y) == 0) continue;
                ++covered;
                const float* place = map.position(x, y);
                const double right = static_cast<double>(place[0]) / kWidth + 0.5;
                const double down = 0.5 - static_cast<double>(place[1]) / kWidth;
                worst = std::fmax(worst, std::fabs(painted.at(x, y).red - right * 255));
                worst = std::fmax(worst, std::fabs(painted.at(x, y).green - down * 255));
            }
        }
        CHECK(covered > kSize * kSize * 2 / 5);
    }
    return worst;
}

}  // namespace

TEST_CASE("Every texel of a slanted chart takes a smooth picture's colour at its own place, up to the last one") {
    // The chart's rims cut rows of texels anywhere, so that runs of four are there only in part.
    constexpr double kTurn = 20 * kPi / 180.0;
    Shape plane = make_plane();
    for (std::size_t v = 0; v < plane.uvs.size(); v += 2) {
        const double u = plane.uvs[v] - 0.5;
        const double w = plane.uvs[v + 1] - 0.5;
        plane.uvs[v] = static_cast<float>(0.5 + 0.7 * (u * std::cos(kTurn) - w * std::sin(kTurn)));
        plane.uvs[v + 1] = static_cast<float>(0.5 + 0.7 * (u * std::sin(kTurn) + w * std::cos(kTurn)));
    }
    CHECK(farthest_from_slope(plane) <= 2.5);
}

TEST_CASE("Where charts meet that lie apart on the model, each side takes a smooth picture's colour at its own place") {
    // Nine pieces of a plane, shuffled in the texture without room between them, so that tiles hold several.
    Shape shuffled;
    for (std::uint32_t piece = 0; piece < 9; ++piece) {
        const std::uint32_t cell = piece * 5 % 9;
        const double left = cell % 3 / 3.0;
        const double top = cell / 3 / 3.0;
        shuffled.append(make_grid(1, 1, {left, top, left + 1 / 3.0, top + 1 / 3.0},
                                  [=](double s, double t, double(&p)[3], double(&n)[3]) {
                                      p[0] = (piece % 3 + s) / 3 - 0.5;
                                      p[1] = 0.5 - (piece / 3 + t) / 3;
                                      p[2] = n[0] = n[1] = 0.0;
                                      n[2] = 1.0;
                                  }));
    }
    CHECK(farthest_from_slope(shuffled) <= 2.5);
}

TEST_CASE("A decal stands upright: its top towards +Y, its left towards -X, its front towards +Z") {
    Easel easel(make_plane(), 64);
    Picture corners(2, 2);
    const Color top_left{255, 0, 0, 255}, top_right{0, 255, 0, 255}, low_left{0, 0, 255, 255},
        low_right{255, 255, 0, 255};
    corners.set(0, 0, top_left);
    corners.set(1, 0, top_right);
    corners.set(0, 1, low_left);
    corners.set(1, 1, low_right);
    TxcLayerDef def = decal_def(easel.session.image(corners));
    def.filter = TXC_FILTER_NEAREST;
    Picture picture = easel.paint(def);
    CHECK(picture.at(16, 16) == top_left);
    CHECK(picture.at(48, 16) == top_right);
    CHECK(picture.at(16, 48) == low_left);
    CHECK(picture.at(48, 48) == low_right);

    SUBCASE("flip_x mirrors it left to right") {
        def.flip_x = 1;
        picture = easel.paint(def);
        CHECK(picture.at(16, 16) == top_right);
        CHECK(picture.at(48, 48) == low_left);
    }
    SUBCASE("flip_y mirrors it top to bottom") {
        def.flip_y = 1;
        picture = easel.paint(def);
        CHECK(picture.at(16, 16) == low_left);
        CHECK(picture.at(48, 48) == top_right);
    }
    SUBCASE("a quarter turn about +Z turns it counter-clockwise") {
        turn(def, 0, 0, 1, 90);
        picture = easel.paint(def);
        CHECK(picture.at(16, 48) == top_left);
        CHECK(picture.at(16, 16) == top_right);
    }
    SUBCASE("a quaternion need not be of unit length") {
        turn(def, 0, 0, 1, 90);
        for (float& part : def.rotation) part *= 37.0f;
        CHECK(easel.paint(def).at(16, 48) == top_left);
    }
}

TEST_CASE("Texels beyond the box's depth keep their colour") {
    // A ramp: z rises from -1/2 at the bottom to 1/2 at the top.
    Easel easel(make_tilted_plane(45.0), 64);
    TxcLayerDef def = easel.solid();
    resize(def, 10, 10, 0.2);
    place(def, 0, 0, 0.1);
    const Picture picture = easel.paint(def);
    std::uint32_t painted = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        const double z = (0.5 - (y + 0.5) / 64) * std::sin(kPi / 4);
        const bool inside = std::fabs(z - 0.1) <= 0.1;
        for (std::uint32_t x = 0; x < 64; ++x) CHECK_UNARY((picture.at(x, y) != kBase) == inside);
        painted += inside ? 1 : 0;
    }
    CHECK(painted > 15);
}

TEST_CASE("Texels that face away are left alone unless back faces are asked for") {
    Easel easel(make_plane(), 32);
    TxcLayerDef def = easel.solid();
    CHECK(easel.paint(def).at(16, 16) == kPaint);
    turn(def, 0, 1, 0, 180);
    CHECK(easel.paint(def) == Picture(32, 32, kBase));
    def.backfaces = 1;
    CHECK(easel.paint(def).at(16, 16) == kPaint);
}

TEST_CASE("On a sphere back faces are painted by the size of their angle, whichever its side") {
    Easel easel(make_sphere(1.0, 32, 16), 64);
    TxcLayerDef def = easel.solid();
    resize(def, 3, 3, 3);
    def.backfaces = 1;
    const Picture both = easel.paint(def);
    def.backfaces = 0;
    const Picture front = easel.paint(def);
    turn(def, 0, 1, 0, 180);
    const Picture back = easel.paint(def);
    std::uint32_t differences = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const double either = std::fmax(share(front, x, y), share(back, x, y));
            differences += std::fabs(share(both, x, y) - either) > 0.02 ? 1 : 0;
        }
    }
    CHECK(differences == 0);
    CHECK(count_color(front, kPaint) > 800);
}

TEST_CASE("On a sphere just those texels are painted that lie in the box's depth and face the viewer, gutters too") {
    // Horizons and both ends of the box cut tiles of coarse and of fine meshes anywhere.
    constexpr std::uint32_t kSize = 192;
    Random random(34);
    for (const int segments : {12, 48, 160}) {
        CAPTURE(segments);
        Easel easel(make_sphere(1.0, segments, segments / 2, {0.1, 0.1, 0.9, 0.9}), kSize);
        const MapArrays map = easel.session.map(easel.target);
        std::uint32_t wrong = 0;
        std::uint32_t painted = 0;
        std::uint32_t left = 0;
        for (int round = 0; round < 8; ++round) {
            TxcLayerDef def = easel.solid();
            def.angle_fade_start = def.angle_fade_end = 90.0f;
            random.rotation(def.rotation);
            place(def, 0, 0, random.between(-0.3, 0.3));
            resize(def, 5, 5, random.between(0.7, 2.2));
            def.backfaces = round % 4 == 3 ? 1 : 0;
            const Vec3 towards = out_of_box(def, {0.0, 0.0, 1.0});
            const Vec3 middle{def.position_model[0], def.position_model[1], def.position_model[2]};
            const Picture picture = easel.paint(def);
            for (std::uint32_t y = 0; y < kSize; ++y) {
                for (std::uint32_t x = 0; x < kSize; ++x) {
                    if (map.coverage_at(x, y) == 0) continue;
                    const float* p = map.position(x, y);
                    const float* n = map.normal(x, y);
                    const double depth = dot(towards, Vec3{p[0], p[1], p[2]} - middle) / def.size[2];
                    const double facing = dot(towards, Vec3{n[0], n[1], n[2]});
                    // What lies on the very limit may fall on either side of it.
                    if (std::fabs(std::fabs(depth) - 0.5) < 1e-5 || std::fabs(facing) < 1e-5) continue;
                    const bool is_met = std::fabs(depth) < 0.5 && (facing > 0.0 || def.backfaces != 0);
                    wrong += picture.at(x, y) != (is_met ? kPaint : kBase) ? 1 : 0;
                    (is_met ? painted : left) += 1;
                }
            }
        }
        CHECK(wrong == 0);
        CHECK(painted > kSize * kSize);
        CHECK(left > kSize * kSize);
    }
}

TEST_CASE("The angle fade is linear in the cosine between its two angles") {
    for (double degrees = 0.0; degrees < 90.0; degrees += 4.0) {
        CAPTURE(degrees);
        Easel easel(make_tilted_plane(degrees), 16);
        TxcLayerDef def = easel.solid();
        resize(def, 4, 4, 4);
        const float fades[][2] = {{70, 90}, {0, 90}, {30, 60}, {45, 45}, {90, 90}};
        for (const auto& fade : fades) {
            const float start = fade[0];
            const float end = fade[1];
            CAPTURE(start);
            CAPTURE(end);
            def.angle_fade_start = start;
            def.angle_fade_end = end;
            const double f = std::cos(degrees * kPi / 180.0);
            const double cos_start = std::cos(start * kPi / 180.0);
            const double cos_end = std::cos(end * kPi / 180.0);
            const double expected = f >= cos_start ? 1.0 : f <= cos_end ? 0.0 : (f - cos_end) / (cos_start - cos_end);
            CHECK(std::fabs(share(easel.paint(def), 8, 8) - expected) < 0.006);
        }
    }
}

TEST_CASE("On a sphere every texel fades by its own angle, gutters too") {
    constexpr std::uint32_t kSize = 192;
    Random random(35);
    const float fades[][2] = {{70, 90}, {10, 80}, {45, 45}};
    for (const int segments : {12, 48, 160}) {
        CAPTURE(segments);
        Easel easel(make_sphere(1.0, segments, segments / 2, {0.1, 0.1, 0.9, 0.9}), kSize);
        const MapArrays map = easel.session.map(easel.target);
        double worst = 0.0;
        std::uint32_t fading = 0;
        for (int round = 0; round < 9; ++round) {
            TxcLayerDef def = easel.solid();
            def.angle_fade_start = fades[round % 3][0];
            def.angle_fade_end = fades[round % 3][1];
            random.rotation(def.rotation);
            resize(def, 5, 5, 5);
            def.backfaces = round % 4 == 3 ? 1 : 0;
            const double start = std::cos(def.angle_fade_start * kPi / 180.0);
            const double end = std::cos(def.angle_fade_end * kPi / 180.0);
            const Vec3 towards = out_of_box(def, {0.0, 0.0, 1.0});
            const Picture picture = easel.paint(def);
            for (std::uint32_t y = 0; y < kSize; ++y) {
                for (std::uint32_t x = 0; x < kSize; ++x) {
                    if (map.coverage_at(x, y) == 0) continue;
                    const float* n = map.normal(x, y);
                    const Vec3 normal{n[0], n[1], n[2]};
                    double cosine = dot(towards, normal) / std::sqrt(dot(normal, normal));
                    if (def.backfaces != 0) cosine = std::fabs(cosine);
                    // Where one angle decides, what lies on it may fall on either side.
                    if (start == end && std::fabs(cosine - end) < 1e-5) continue;
                    const double weight = cosine >= start ? 1.0 : cosine <= end ? 0.0 : (cosine - end) / (start - end);
                    worst = std::fmax(worst, std::fabs(share(picture, x, y) - weight));
                    fading += weight > 0.0 && weight < 1.0 ? 1 : 0;
                }
            }
        }
        CHECK(worst < 0.006);
        CHECK(fading > kSize * kSize / 2);
    }
}

TEST_CASE("A fade of 90 to 90 degrees paints everything that faces the viewer fully") {
    Easel easel(make_tilted_plane(89.5), 16);
    TxcLayerDef def = easel.solid();
    resize(def, 4, 4, 4);
    def.angle_fade_start = def.angle_fade_end = 90.0f;
    CHECK(easel.paint(def).at(8, 8) == kPaint);
    Easel beyond(make_tilted_plane(90.5), 16);
    TxcLayerDef same = beyond.solid();
    resize(same, 4, 4, 4);
    same.angle_fade_start = same.angle_fade_end = 90.0f;
    CHECK(beyond.paint(same).at(8, 8) == kBase);
}

TEST_CASE("An opaque nearest decal copies its bytes exactly") {
    // Sixteen pixels over sixteen texels, one for one, in every alignment that has a pixel under each centre.
    Easel easel(make_plane(1.0), 16, 0);
    const Picture picture = make_noise(16, 16, 50, true);
    TxcLayerDef def = decal_def(easel.session.image(picture));
    def.filter = TXC_FILTER_NEAREST;
    for (const Color base : {kBase, Color{0, 0, 0, 0}, Color{9, 8, 7, 128}}) {
        easel.session.set_base(easel.target, base);
        CHECK(easel.paint(def) == picture);
    }
}

TEST_CASE("Every byte survives an opaque nearest decal") {
    Easel easel(make_plane(1.0), 16, 0);
    Picture picture(16, 16);
    for (std::uint32_t i = 0; i < 256; ++i) {
        const auto byte = static_cast<std::uint8_t>(i);
        picture.set(i % 16, i / 16,
                    {byte, static_cast<std::uint8_t>(255 - byte), static_cast<std::uint8_t>(byte ^ 0x55), 255});
    }
    TxcLayerDef def = decal_def(easel.session.image(picture));
    def.filter = TXC_FILTER_NEAREST;
    CHECK(easel.paint(def) == picture);
}

TEST_CASE("A nearest decal takes the pixel under the centre, and its edge is hard") {
    Easel easel(make_plane(), 64);
    Picture picture = make_noise(5, 3, 51, true);
    TxcLayerDef def = decal_def(easel.session.image(picture));
    def.filter = TXC_FILTER_NEAREST;
    resize(def, 0.61, 0.37, 1.0);
    place(def, 0.05, -0.03, 0.0);
    const Picture painted = easel.paint(def);
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const double px = (((x + 0.5) / 64 - 0.5 - 0.05) / 0.61 + 0.5) * 5;
            const double py = (0.5 - (0.5 - (y + 0.5) / 64 + 0.03) / 0.37) * 3;
            const bool inside = px >= 0 && px <= 5 && py >= 0 && py <= 3;
            const Color expected =
                inside ? picture.at(static_cast<std::uint32_t>(px), static_cast<std::uint32_t>(py)) : kBase;
            CHECK_UNARY(painted.at(x, y) == expected);
        }
    }
}

TEST_CASE("A linear decal's edge is antialiased by the part of the texel that it covers") {
    Easel easel(make_plane(), 64);
    // A picture of many pixels, so that its own soft border is far less than a texel wide.
    TxcLayerDef def = decal_def(easel.session.image(Picture(1024, 1024, kPaint)));
    // From texel 16.25 to texel 47.75 across; the whole height.
    resize(def, 31.5 / 64, 2.0, 1.0);
    const Picture painted = easel.paint(def);
    CHECK(painted.at(15, 32) == kBase);
    CHECK(std::fabs(share(painted, 16, 32) - 0.75) < 0.02);
    CHECK(painted.at(17, 32) == kPaint);
    CHECK(painted.at(46, 32) == kPaint);
    CHECK(std::fabs(share(painted, 47, 32) - 0.75) < 0.02);
    CHECK(painted.at(48, 32) == kBase);
}

TEST_CASE("A decal smaller than a texel gives it its share of colour") {
    Easel easel(make_plane(), 16);
    TxcLayerDef def = decal_def(easel.session.image(Picture(256, 256, kPaint)));
    // A quarter of the texel (8, 8) by area, wholly inside it.
    resize(def, 0.5 / 16, 0.5 / 16, 1.0);
    place(def, 0.5 / 16, -0.5 / 16, 0.0);
    const Picture painted = easel.paint(def);
    CHECK(std::fabs(share(painted, 8, 8) - 0.25) < 0.03);
    CHECK(painted.at(7, 8) == kBase);
    CHECK(painted.at(9, 8) == kBase);
}

TEST_CASE("Opacity scales what the decal gives") {
    Easel easel(make_plane(), 16);
    TxcLayerDef def = easel.solid();
    resize(def, 2, 2, 2);
    for (const float opacity : {0.0f, 0.25f, 0.5f, 1.0f}) {
        def.opacity = opacity;
        CHECK(std::fabs(share(easel.paint(def), 8, 8) - opacity) < 0.005);
    }
}

TEST_CASE("A tiled picture meets itself at its border, a plain one fades out there") {
    // Magnified: 4 pixels over 64 texels, so that a pixel's blending is 8 texels wide.
    Easel easel(make_plane(), 64);
    Picture picture(4, 4, kPaint);
    TxcLayerDef def = decal_def(easel.session.image(picture));
    const Picture plain = easel.paint(def);
    CHECK(share(plain, 0, 32) < 0.6);
    CHECK(share(plain, 32, 32) > 0.999);
    def.wrap = TXC_WRAP_REPEAT;
    CHECK(easel.paint(def) == Picture(64, 64, kPaint));
}

TEST_CASE("Gutters are painted as their chart's continuation") {
    // A chart in the middle; the decal's stripes run on into the gutter as if the plane did.
    const Shape chart = make_plane(0.5, 0.0, {0.25, 0.25, 0.75, 0.75});
    Easel cut(chart, 64, 6);
    Easel whole(make_plane(1.0), 64, 6);
    for (Easel* easel : {&cut, &whole}) {
        TxcLayerDef def = decal_def(easel->session.image(make_checker(32, 32, 3, kPaint, {0, 0, 0, 255})));
        resize(def, 0.9, 0.9, 1.0);
        easel->session.layer(easel->target, def);
    }
    const Picture continued = cut.session.paint(cut.target);
    const Picture expected = whole.session.paint(whole.target);
    const MapArrays map = cut.session.map(cut.target);
    std::uint32_t gutter = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            if (map.coverage_at(x, y) == 0) {
                CHECK_UNARY(continued.at(x, y) == kBase);
                continue;
            }
            const Color a = continued.at(x, y);
            const Color b = expected.at(x, y);
            // The two meshes' vertices round differently.
            CHECK_UNARY(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) <= 3);
            gutter += map.coverage_at(x, y) == 2 ? 1 : 0;
        }
    }
    CHECK(gutter > 700);
}

TEST_CASE("A transparent picture paints nothing, and a layer without a picture neither") {
    Easel easel(make_plane(), 32);
    TxcLayerDef def = decal_def(easel.session.image(Picture(4, 4, {255, 0, 255, 0})));
    CHECK(easel.paint(def) == Picture(32, 32, kBase));
    def.image = 0;
    CHECK(easel.paint(def) == Picture(32, 32, kBase));
}

TEST_CASE("Colour under a picture's transparent pixels does not leak at its soft edges") {
    Easel easel(make_plane(), 64);
    easel.session.set_base(easel.target, {255, 255, 255, 255});
    // White paint beside transparent black: on white nothing may darken.
    Picture picture(8, 8, {0, 0, 0, 0});
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) picture.set(x, y, {255, 255, 255, 255});
    }
    CHECK(easel.paint(decal_def(easel.session.image(picture))) == Picture(64, 64, {255, 255, 255, 255}));
}
