// Painted textures against a slow painter in double precision: 40 dB or better (spec sections 3 to 6).
#include <doctest/doctest.h>

#include <string>

#include "support/comparison.h"

using namespace support;

namespace {

/// A decal on a unit plane whose picture has `scale` pixels a texel: 1/8 is magnified eight times, 8 minified.
TxcLayerDef flat_decal(double extent, double degrees) {
    TxcLayerDef def = decal_def(0);
    place(def, 0.03, -0.02, 0.0);
    resize(def, extent, extent, 0.5);
    turn(def, 0, 0, 1, degrees);
    return def;
}

}  // namespace

TEST_CASE("Decals magnified and minified up to eight times agree on a plane") {
    // 64 texels a metre; a decal of 0.75 m is 48 texels wide.
    Comparison plane(make_plane(), 64, 64);
    for (const double pixels_a_texel : {0.125, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0}) {
        for (const double degrees : {0.0, 20.0}) {
            CAPTURE(pixels_a_texel);
            CAPTURE(degrees);
            const auto size = static_cast<std::uint32_t>(48 * pixels_a_texel + 0.5);
            const TxcLayerDef def = flat_decal(0.75, degrees);
            // Squares of 5 pixels: minified, every texel holds several hard edges.
            check(plane.paint(def, make_checker(size, size, 5)));
            check(plane.paint(def, make_gradient(size, size, true)));
        }
    }
}

TEST_CASE("Pictures that are wider than high, and odd in size, agree") {
    Comparison plane(make_plane(), 128, 96);
    const std::uint32_t sizes[][2] = {{1, 1}, {2, 1}, {1, 64}, {3, 7}, {31, 5}, {255, 129}, {640, 33}};
    for (const auto& size : sizes) {
        CAPTURE(size[0]);
        CAPTURE(size[1]);
        TxcLayerDef def = flat_decal(0.6, 30.0);
        resize(def, 0.6, 0.35, 0.5);
        check(plane.paint(def, make_gradient(size[0], size[1])));
        check(plane.paint(def, make_noise(size[0], size[1], 40)));
    }
}

TEST_CASE("Decals on a sphere agree from every side") {
    Comparison sphere(make_sphere(1.0, 32, 16), 192, 96);
    Random random(41);
    for (int round = 0; round < 16; ++round) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, random.between(-0.9, 0.9), random.between(-0.9, 0.9), random.between(-0.9, 0.9));
        resize(def, random.between(0.4, 1.5), random.between(0.4, 1.5), random.between(0.4, 1.5));
        const auto size = static_cast<std::uint32_t>(16 << random.below(5));
        CAPTURE(round);
        CAPTURE(size);
        const Closeness closeness = round % 2 == 0 ? sphere.paint(def, make_checker(size, size, size / 8))
                                                   : sphere.paint(def, make_gradient(size, size, true));
        CHECK(closeness.decibel >= kAsked);
    }
}

TEST_CASE("A decal from the front agrees on a sphere and on a cylinder") {
    TxcLayerDef def = decal_def(0);
    place(def, 0.1, 0.1, 0.8);
    resize(def, 0.9, 0.9, 1.0);
    Comparison sphere(make_sphere(1.0, 48, 24), 256, 128);
    check(sphere.paint(def, make_checker(64, 64, 8)), 1500);
    check(sphere.paint(def, make_gradient(300, 300)), 1500);
    Comparison cylinder(make_cylinder(1.0, 1.6, 48), 256, 64);
    check(cylinder.paint(def, make_checker(64, 64, 8)), 1000);
    check(cylinder.paint(def, make_gradient(300, 300)), 1000);
}

TEST_CASE("The finest pictures agree on a sphere, of which a tile sees more than one facet, at any angle") {
    Comparison sphere(make_sphere(1.0, 48, 24), 256, 128);
    Random random(43);
    for (int round = 0; round < 24; ++round) {
        CAPTURE(round);
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        resize(def, random.between(0.5, 1.2), random.between(0.5, 1.2), 3.0);
        const auto size = static_cast<std::uint32_t>(random.between(20, 100));
        const Color black{0, 0, 0, 255};
        const Color white{255, 255, 255, 255};
        Picture stripes(size, size, black);
        for (std::uint32_t y = 0; y < size; ++y) {
            for (std::uint32_t x = 1; x < size; x += 2) stripes.set(x, y, white);
        }
        check(sphere.paint(def, stripes));
        check(sphere.paint(def, make_checker(size, size, 1, black, white)));
        check(sphere.paint(def, make_checker(size, size, 2, black, white)));
    }
}

TEST_CASE("The finest stripes agree on a sphere of coarse facets on a texture of middling size") {
    Comparison sphere(make_sphere(1.0, 48, 24), 640, 448);
    TxcLayerDef def = decal_def(0);
    place(def, 0.2, 0.1, 1.0);
    resize(def, 1.0, 1.0, 1.5);
    turn(def, 0.1, 0.1, 1, 27.0);
    def.occlusion = TXC_OCCLUSION_NONE;
    // 2.6 pixels a texel.
    Picture stripes(264, 264, {0, 0, 0, 255});
    for (std::uint32_t y = 0; y < 264; ++y) {
        for (std::uint32_t x = 1; x < 264; x += 2) stripes.set(x, y, kWhite);
    }
    check(sphere.paint(def, stripes), 18000);
}

TEST_CASE("A box turned about every axis agrees where the surface slants through it") {
    Comparison plane(make_plane(), 128, 128);
    for (const double tilt : {15.0, 40.0, 60.0, 75.0}) {
        CAPTURE(tilt);
        TxcLayerDef def = flat_decal(0.5, 0.0);
        turn(def, 0.6, 0.8, 0, tilt);
        resize(def, 0.5, 0.5, 2.0);
        check(plane.paint(def, make_checker(48, 48, 6)));
        check(plane.paint(def, make_gradient(200, 200)));
    }
}

TEST_CASE("Tiled borders, flips, back faces and half opacity agree") {
    Comparison sphere(make_sphere(1.0, 32, 16), 160, 80);
    TxcLayerDef plain = decal_def(0);
    place(plain, 0.0, 0.0, 0.9);
    resize(plain, 1.0, 0.8, 0.8);
    const Picture picture = make_gradient(40, 30, true);
    TxcLayerDef def = plain;
    def.wrap = TXC_WRAP_REPEAT;
    check(sphere.paint(def, picture));
    def = plain;
    def.flip_x = 1;
    check(sphere.paint(def, picture));
    def = plain;
    def.flip_y = 1;
    check(sphere.paint(def, picture));
    def = plain;
    def.backfaces = 1;
    resize(def, 1.0, 0.8, 4.0);
    check(sphere.paint(def, picture), 400);
    def = plain;
    def.opacity = 0.375f;
    check(sphere.paint(def, picture));
    def = plain;
    def.angle_fade_start = 10.0f;
    def.angle_fade_end = 25.0f;
    check(sphere.paint(def, picture));
}

TEST_CASE("A nearest decal agrees with the pixel under every centre") {
    Comparison plane(make_plane(), 128, 128);
    for (const double degrees : {0.0, 33.0}) {
        TxcLayerDef def = flat_decal(0.75, degrees);
        def.filter = TXC_FILTER_NEAREST;
        const Closeness coarse = plane.paint(def, make_noise(16, 16, 42, true));
        CHECK(coarse.worst <= 1);
        check(coarse, 5000);
        const Closeness fine = plane.paint(def, make_noise(300, 300, 43, true));
        CHECK(fine.worst <= 1);
        check(fine, 5000);
    }
}

TEST_CASE("Several layers over a colour agree with source over in double precision") {
    Comparison sphere(make_sphere(1.0, 32, 16), 128, 64);
    Random random(44);
    std::vector<std::pair<TxcLayerDef, Picture>> layers;
    for (int i = 0; i < 6; ++i) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
        resize(def, 1.5, 1.5, 1.5);
        def.opacity = static_cast<float>(random.between(0.3, 1.0));
        layers.emplace_back(def, make_gradient(24, 24, i % 2 == 0));
    }
    check(sphere.paint(layers, {40, 90, 200, 255}), 3000);
}

TEST_CASE("Layers over a transparent texture agree, alpha included") {
    const Shape shape = make_plane();
    const ReferenceMap map(shape, 64, 64);
    const Color base{200, 10, 60, 0};
    const Picture picture = make_gradient(32, 32, true);
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64);
    session.set_base(target, base);
    ReferencePainter expected(map, base);
    TxcLayerDef def = decal_def(session.image(picture));
    resize(def, 0.7, 0.7, 1.0);
    def.opacity = 0.8f;
    for (const double x : {-0.2, 0.1}) {
        place(def, x, x, 0.0);
        session.layer(target, def);
        expected.paint(def, picture);
    }
    const Picture actual = session.paint(target);
    const Picture wanted = expected.result();
    std::uint32_t compared = 0;
    double squares = 0.0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const Color a = wanted.at(x, y);
            const Color b = actual.at(x, y);
            if (a == base && b == base) continue;
            // Colour counts as much as it shows.
            const double differences[4] = {a.red * a.alpha / 255.0 - b.red * b.alpha / 255.0,
                                           a.green * a.alpha / 255.0 - b.green * b.alpha / 255.0,
                                           a.blue * a.alpha / 255.0 - b.blue * b.alpha / 255.0,
                                           static_cast<double>(a.alpha - b.alpha)};
            for (const double difference : differences) squares += difference * difference;
            ++compared;
        }
    }
    CHECK(compared > 2000);
    CHECK(10.0 * std::log10(255.0 * 255.0 * 4.0 * compared / squares) >= kAsked);
}
