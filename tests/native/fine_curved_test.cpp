// Perspective and cylindrical projectors on textures so fine that their maps are as good as affine over a tile: whole tiles are
// painted at once there, and must come as near to 8 x 8 samples, and tell the same texels apart, as texel by texel.
#include <doctest/doctest.h>

#include <cmath>

#include "support/comparison.h"
#include "support/projector_defs.h"

using namespace support;

namespace {

constexpr std::uint32_t kWidth = 1024;
constexpr std::uint32_t kHeight = 576;
constexpr UvRect kChart{0.0, 0.0, 0.1875, 0.25};  // 192 x 144 texels

/// A part of the unit sphere about +Z, some 20 degrees wide, and of a cylinder about Y: a tile is a degree or two.
Shape make_sphere_part() {
    return make_grid(12, 9, kChart, [](double s, double t, double(&p)[3], double(&n)[3]) {
        const double around = (s - 0.5) * 0.35;
        const double up = (0.5 - t) * 0.25;
        n[0] = p[0] = std::sin(around) * std::cos(up);
        n[1] = p[1] = std::sin(up);
        n[2] = p[2] = std::cos(around) * std::cos(up);
    });
}
Shape make_cylinder_part() {
    return make_grid(12, 1, kChart, [](double s, double t, double(&p)[3], double(&n)[3]) {
        const double around = (s - 0.5) * 0.35;
        n[0] = p[0] = std::sin(around);
        n[1] = 0.0;
        n[2] = p[2] = std::cos(around);
        p[1] = (0.5 - t) * 0.25;
    });
}

/// With plates far away that have the rest of the texture: a fine one is one of many tiles.
Shape with_far_plates(Shape shape) {
    shape.append(make_plane(0.01, -40.0, {0.2, 0.0, 1.0, 1.0}));
    shape.append(make_plane(0.01, -40.0, {0.0, 0.3, 0.1875, 1.0}));
    return shape;
}

/// As Comparison, over a shape whose chart is kChart; the slow painter knows of no plates.
class FineComparison {
public:
    explicit FineComparison(const Shape& shape)
        : shape_(shape),
          reference_(shape_, kWidth, kHeight),
          session_(with_far_plates(shape)),
          target_(session_.target(kWidth, kHeight)) {
        session_.set_base(target_, kWhite);
    }

    void check(TxcLayerDef def, const Picture& picture, std::uint32_t at_least) {
        ReferencePainter expected(reference_, kWhite);
        expected.paint(def, picture);
        def.image = session_.image(picture);
        const TxcLayer layer = session_.layer(target_, def);
        support::check(compare(expected, session_.paint(target_), kWhite), at_least);
        must(txc_layer_destroy(session_.id(), layer));
    }

private:
    Shape shape_;
    ReferenceMap reference_;
    TestSession session_;
    TxcTarget target_;
};

}  // namespace

TEST_CASE("A slide thrown at a finely textured sphere agrees, straight and aslant, magnified and minified") {
    FineComparison sphere(make_sphere_part());
    for (const auto& checker : {make_checker(24, 24, 5), make_checker(96, 96, 3), make_checker(240, 240, 5)}) {
        CAPTURE(checker.width);
        for (const bool is_aslant : {false, true}) {
            CAPTURE(is_aslant);
            TxcLayerDef def = perspective_def(0, is_aslant ? 6.0 : 5.0, 1.0, 0.5, 6.0);
            place(def, is_aslant ? 2.2 : 0.2, 0.4, is_aslant ? 1.7 : 2.6);
            look_at(def, 0.05, 0.02, 1.0);
            def.flip_x = is_aslant ? 1 : 0;
            sphere.check(def, checker, 4000);
        }
    }
}

TEST_CASE("A slide agrees on a finely textured sphere where its far plane cuts it, and from within") {
    FineComparison sphere(make_sphere_part());
    TxcLayerDef def = perspective_def(0, 6.0, 1.0, 0.5, 1.625);
    place(def, 0.1, 0.2, 2.6);
    look_at(def, 0, 0, 1);
    sphere.check(def, make_gradient(128, 128), 2000);
    def = perspective_def(0, 50.0, 1.0, 0.1, 3.0);
    place(def, 0.1, -0.1, 0.4);
    look_at(def, 0.05, 0.02, 1.0);
    def.backfaces = 1;
    sphere.check(def, make_gradient(128, 128), 4000);
}

TEST_CASE("A volume's ends cut what bulges amid tiles whose own ends lie inside") {
    // Ridges of 2 mm, each along the middle of a tile.
    const auto ridge = [](double s) { return std::lround(s * 24) % 2 == 1 ? 0.002 : 0.0; };
    FineComparison plate(make_grid(24, 9, kChart, [&](double s, double t, double(&p)[3], double(&n)[3]) {
        p[0] = (s - 0.5) * 0.35;
        p[1] = (0.5 - t) * 0.25;
        p[2] = 1.0 + ridge(s);
        n[0] = n[1] = 0.0;
        n[2] = 1.0;
    }));
    TxcLayerDef def = perspective_def(0, 6.0, 1.0, 1.9989, 6.0);
    place(def, 0, 0, 3);
    plate.check(def, make_gradient(128, 128), 4000);
    FineComparison label(make_grid(24, 9, kChart, [&](double s, double t, double(&p)[3], double(&n)[3]) {
        const double around = (s - 0.5) * 0.35;
        n[0] = std::sin(around);
        n[1] = 0.0;
        n[2] = std::cos(around);
        p[0] = n[0] * (1.0 + ridge(s));
        p[1] = (0.5 - t) * 0.25;
        p[2] = n[2] * (1.0 + ridge(s));
    }));
    label.check(cylindrical_def(0, 0.9, 0.12, 16.0, 0.1011), make_gradient(128, 128), 4000);
}

TEST_CASE("A slide thrown from so near that no tile is flat to it agrees on a fine texture, too") {
    FineComparison sphere(make_sphere_part());
    TxcLayerDef def = perspective_def(0, 100.0, 1.0, 0.02, 3.0);
    place(def, 0.02, 0.01, 1.08);
    look_at(def, 0, 0, 1);
    sphere.check(def, make_checker(96, 96, 3), 4000);
    // From within the axis's neighbourhood a cylinder's tiles are as wide.
    def = cylindrical_def(0, 0.1, 0.12, 300, 0.12);
    place(def, 0, 0, 0.9);
    sphere.check(def, make_checker(600, 60, 5), 4000);
}

TEST_CASE("A label on a finely textured cylinder agrees, by itself and where it closes on itself") {
    FineComparison cylinder(make_cylinder_part());
    // Where it closes upon an edge of tiles, and amid one.
    struct Label {
        double arc, turned;
        std::uint32_t wrap;
    };
    const Label labels[] = {{16.0, 0.0, TXC_WRAP_NONE},
                            {360.0, 180.0, TXC_WRAP_NONE},
                            {360.0, 178.0, TXC_WRAP_NONE},
                            {360.0, 178.0, TXC_WRAP_REPEAT}};
    for (const Label& label : labels) {
        CAPTURE(label.arc);
        CAPTURE(label.wrap);
        TxcLayerDef def = cylindrical_def(0, 0.95, 0.12, label.arc, 0.3);
        turn(def, 0, 1, 0, label.turned);
        def.wrap = label.wrap;
        cylinder.check(def, make_checker(label.arc > 100.0 ? 2400 : 110, 60, 5), 4000);
    }
}

TEST_CASE("A slide is as dim as its texels' angles say, tile by tile and texel by texel alike") {
    // On the coarse texture no tile is painted at once. Each of its centres lies amid four of the fine one's.
    const auto painted = [](std::uint32_t width, std::uint32_t height) {
        TestSession session(with_far_plates(make_sphere_part()));
        const TxcTarget target = session.target(width, height);
        session.set_base(target, {0, 0, 0, 255});
        TxcLayerDef def = perspective_def(session.image(Picture(8, 8, {240, 240, 240, 255})), 60, 1, 0.5, 6);
        place(def, 2.0, 0.3, 1.6);
        look_at(def, 0, 0, 1);
        def.angle_fade_start = 30.0f;
        def.angle_fade_end = 80.0f;
        session.layer(target, def);
        return session.paint(target);
    };
    const Picture fine = painted(kWidth, kHeight);
    const Picture coarse = painted(kWidth / 4, kHeight / 4);
    std::uint32_t dimmed = 0;
    for (std::uint32_t y = 2; y < kHeight / 16 - 2; ++y) {
        for (std::uint32_t x = 2; x < kWidth * 3 / 64 - 2; ++x) {
            int sum = 0;
            for (const std::uint32_t dy : {1u, 2u}) {
                for (const std::uint32_t dx : {1u, 2u}) sum += fine.at(4 * x + dx, 4 * y + dy).red;
            }
            const int expected = coarse.at(x, y).red;
            CHECK_UNARY(std::abs(sum - 4 * expected) <= 4);
            dimmed += expected > 20 && expected < 220 ? 1 : 0;
        }
    }
    CHECK(dimmed > 800);
}
