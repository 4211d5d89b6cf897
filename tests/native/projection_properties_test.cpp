// What must hold of any decal on any model, whatever its texels turn out to be.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "support/test_session.h"

using namespace support;

namespace {

Shape make_scene() {
    Shape shape = make_sphere(1.0, 28, 14, {0.0, 0.0, 0.5, 1.0});
    shape.append(moved(make_cylinder(0.4, 1.6, 20, {0.52, 0.0, 1.0, 0.6}), 1.1, 0.2, 0.3));
    return shape;
}

Shape scaled(Shape shape, float by) {
    for (float& coordinate : shape.positions) coordinate *= by;
    return shape;
}

TxcLayerDef random_decal(TxcImage image, Random& random) {
    TxcLayerDef def = decal_def(image);
    place(def, random.between(-0.8, 0.8), random.between(-0.8, 0.8), random.between(-0.8, 0.8));
    random.rotation(def.rotation);
    resize(def, random.between(0.4, 2.0), random.between(0.4, 2.0), random.between(0.5, 3.0));
    return def;
}

/// A part of a picture, from (x, y) on.
Picture cut(const Picture& picture, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
    Picture part(width, height);
    for (std::uint32_t row = 0; row < height; ++row) {
        for (std::uint32_t column = 0; column < width; ++column) part.set(column, row, picture.at(x + column, y + row));
    }
    return part;
}

bool is_near(Color a, Color b) {
    return std::abs(a.red - b.red) <= 1 && std::abs(a.green - b.green) <= 1 && std::abs(a.blue - b.blue) <= 1 &&
           std::abs(a.alpha - b.alpha) <= 1;
}

}  // namespace

TEST_CASE("A decal cut into four quarters of its picture paints what the whole one paints, but at the cuts") {
    // On a plane, where a texel's distance from a cut is plain to see. 256 texels a metre, 48 pixels a side.
    const std::uint32_t size = 256;
    const Picture whole = make_noise(48, 48, 200, true);
    Random random(201);
    for (int round = 0; round < 6; ++round) {
        const double x = random.between(-0.1, 0.1);
        const double y = random.between(-0.1, 0.1);
        const double angle = random.between(0.0, 360.0) * kPi / 180.0;
        const double side = random.between(0.2, 0.7);
        TestSession one(make_plane());
        TestSession four(make_plane());
        const TxcTarget one_target = one.target(size, size);
        const TxcTarget four_target = four.target(size, size);
        const auto make = [&](TestSession& session, const Picture& picture, double right, double up, double extent) {
            TxcLayerDef def = decal_def(session.image(picture));
            place(def, x + right * std::cos(angle) - up * std::sin(angle),
                  y + right * std::sin(angle) + up * std::cos(angle), 0.0);
            turn(def, 0, 0, 1, angle * 180.0 / kPi);
            resize(def, extent, extent, 1.0);
            return def;
        };
        one.layer(one_target, make(one, whole, 0, 0, side));
        for (int quarter = 0; quarter < 4; ++quarter) {
            const bool right = quarter % 2 == 1;
            const bool lower = quarter / 2 == 1;
            const Picture part = cut(whole, right ? 24 : 0, lower ? 24 : 0, 24, 24);
            four.layer(four_target,
                       make(four, part, (right ? 1 : -1) * side / 4, (lower ? -1 : 1) * side / 4, side / 2));
        }
        const Picture expected = one.paint(one_target);
        const Picture actual = four.paint(four_target);
        const double pixel = side / 48;
        std::uint32_t compared = 0;
        for (std::uint32_t row = 0; row < size; ++row) {
            for (std::uint32_t column = 0; column < size; ++column) {
                const double px = (column + 0.5) / size - 0.5 - x;
                const double py = 0.5 - (row + 0.5) / size - y;
                const double along = px * std::cos(angle) + py * std::sin(angle);
                const double across = -px * std::sin(angle) + py * std::cos(angle);
                // Two pixels from the cuts and from the rim, and the texel's own reach.
                const double clear = 2 * pixel + 1.0 / size;
                if (std::fabs(along) < clear || std::fabs(across) < clear) continue;
                if (std::fabs(along) > side / 2 - clear || std::fabs(across) > side / 2 - clear) continue;
                CHECK_UNARY(is_near(actual.at(column, row), expected.at(column, row)));
                ++compared;
            }
        }
        CHECK(compared > 500);
    }
}

TEST_CASE("A design scaled with its model paints the same") {
    const Shape scene = make_scene();
    // Powers of two scale every number exactly; other factors round, so that a texel at an edge may flip.
    for (const float factor : {0.0009765625f, 0.25f, 16.0f, 3.0f}) {
        CAPTURE(factor);
        TestSession here(scene);
        TestSession there(scaled(scene, factor));
        const TxcTarget here_target = here.target(160, 160);
        const TxcTarget there_target = there.target(160, 160);
        Random random(202);
        for (int k = 0; k < 6; ++k) {
            const Picture picture = make_gradient(40, 30, true);
            TxcLayerDef def = random_decal(here.image(picture), random);
            here.layer(here_target, def);
            def.image = there.image(picture);
            for (float& coordinate : def.position_model) coordinate *= factor;
            for (float& extent : def.size) extent *= factor;
            there.layer(there_target, def);
        }
        const Picture expected = here.paint(here_target);
        const Picture actual = there.paint(there_target);
        CHECK(count_color(expected, expected.at(0, 0)) < 160 * 160 - 3000);
        std::uint32_t different = 0;
        for (std::uint32_t y = 0; y < 160; ++y) {
            for (std::uint32_t x = 0; x < 160; ++x) different += is_near(actual.at(x, y), expected.at(x, y)) ? 0 : 1;
        }
        CHECK(different <= (factor == 3.0f ? 160u * 160u / 500u : 0u));
    }
}

TEST_CASE("A model and its decals turned together paint the same") {
    // A quarter turn about Y maps (x, y, z) to (z, y, -x), without rounding.
    const Shape scene = make_scene();
    Shape turned = scene;
    for (auto* list : {&turned.positions, &turned.normals}) {
        for (std::size_t i = 0; i + 2 < list->size(); i += 3) {
            const float x = (*list)[i];
            (*list)[i] = (*list)[i + 2];
            (*list)[i + 2] = -x;
        }
    }
    TestSession here(scene);
    TestSession there(turned);
    const TxcTarget here_target = here.target(128, 128);
    const TxcTarget there_target = there.target(128, 128);
    Random random(203);
    for (int k = 0; k < 6; ++k) {
        const Picture picture = make_gradient(40, 30, true);
        TxcLayerDef def = random_decal(here.image(picture), random);
        here.layer(here_target, def);
        const float x = def.position_model[0];
        def.image = there.image(picture);
        def.position_model[0] = def.position_model[2];
        def.position_model[2] = -x;
        // (0, s, 0, s) * q with s the half turn's root: the turn after the decal's own.
        const float* q = def.rotation;
        const float s = 0.70710678f;
        const float r[4] = {s * (q[0] + q[2]), s * (q[1] + q[3]), s * (q[2] - q[0]), s * (q[3] - q[1])};
        for (int i = 0; i < 4; ++i) def.rotation[i] = r[i];
        there.layer(there_target, def);
    }
    const Picture expected = here.paint(here_target);
    const Picture actual = there.paint(there_target);
    std::uint32_t different = 0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) different += is_near(actual.at(x, y), expected.at(x, y)) ? 0 : 1;
    }
    CHECK(different <= 128 * 128 / 500);
}
