// What the layers lie on: a picture at any size, or one colour (texelcast.h, "Base picture").
#include <doctest/doctest.h>

#include <cmath>

#include "support/glb_builder.h"
#include "support/test_session.h"

using namespace support;

namespace {

Picture shown(const Picture& base, std::uint32_t width, std::uint32_t height,
              std::uint32_t filter = TXC_FILTER_LINEAR) {
    TestSession session(make_plane());
    const TxcTarget target = session.target(width, height);
    session.set_base(target, base, filter);
    return session.paint(target);
}

}  // namespace

TEST_CASE("A base of the target's own size comes through byte for byte") {
    const Picture base = make_noise(61, 47, 120);
    CHECK(shown(base, 61, 47) == base);
    CHECK(shown(base, 61, 47, TXC_FILTER_NEAREST) == base);
}

TEST_CASE("A flat colour stays flat at every size, transparent colours too") {
    for (const Color color : {Color{1, 128, 254, 255}, {77, 3, 200, 1}, {9, 99, 199, 0}}) {
        for (const std::uint32_t size : {1u, 7u, 32u, 100u, 257u}) {
            CHECK(shown(Picture(32, 32, color), size, size + 3) == Picture(size, size + 3, color));
            CHECK(shown(Picture(1, 1, color), size, size) == Picture(size, size, color));
        }
    }
}

TEST_CASE("Enlarging by nearest repeats pixels") {
    const Picture base = make_noise(5, 3, 121);
    const Picture large = shown(base, 20, 12, TXC_FILTER_NEAREST);
    for (std::uint32_t y = 0; y < 12; ++y) {
        for (std::uint32_t x = 0; x < 20; ++x) CHECK_UNARY(large.at(x, y) == base.at(x / 4, y / 4));
    }
}

TEST_CASE("Shrinking by nearest picks pixels") {
    const Picture base = make_noise(12, 12, 122);
    const Picture small = shown(base, 4, 4, TXC_FILTER_NEAREST);
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) CHECK_UNARY(small.at(x, y) == base.at(x * 3 + 1, y * 3 + 1));
    }
}

TEST_CASE("Enlarging interpolates between pixel centres and holds the border") {
    Picture base(2, 1, {0, 0, 0, 255});
    base.set(1, 0, {200, 100, 40, 255});
    const Picture large = shown(base, 8, 1);
    // Centres at 1/4 and 3/4: texel 2 is a quarter of the way, less half a texel.
    const double shares[8] = {0, 0, 0.125, 0.375, 0.625, 0.875, 1, 1};
    for (std::uint32_t x = 0; x < 8; ++x) CHECK(std::fabs(large.at(x, 0).red - 200 * shares[x]) <= 0.5);
}

TEST_CASE("Shrinking averages the area under each texel") {
    const Picture base = make_noise(12, 9, 123, true);
    const Picture small = shown(base, 4, 3);
    for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) {
            double green = 0;
            for (std::uint32_t j = 0; j < 3; ++j) {
                for (std::uint32_t i = 0; i < 3; ++i) green += base.at(x * 3 + i, y * 3 + j).green / 9.0;
            }
            CHECK_UNARY(std::fabs(small.at(x, y).green - green) <= 0.5 + 1e-9);
        }
    }
    // A ratio that cuts pixels: 3 to 2.
    Picture three(3, 1, {0, 0, 0, 255});
    three.set(0, 0, {90, 0, 0, 255});
    three.set(1, 0, {30, 0, 0, 255});
    const Picture two = shown(three, 2, 1);
    CHECK(two.at(0, 0).red == 70);
    CHECK(two.at(1, 0).red == 10);
}

TEST_CASE("Transparent pixels lend no colour when a base is resampled") {
    Picture base(2, 2, {255, 0, 0, 0});
    base.set(0, 0, {0, 0, 255, 255});
    base.set(0, 1, {0, 0, 255, 255});
    const Picture one = shown(base, 1, 1);
    CHECK(one.at(0, 0) == Color{0, 0, 255, 128});
    const Picture large = shown(base, 16, 2);
    for (std::uint32_t x = 0; x < 12; ++x) CHECK(large.at(x, 0).blue == 255);
    CHECK(large.at(15, 0) == Color{255, 0, 0, 0});
}

TEST_CASE("The axes are resampled apart: wider and lower at once") {
    const Picture base = make_noise(6, 8, 124, true);
    const Picture both = shown(base, 12, 2);
    CHECK(both.width == 12);
    double mean = 0;
    for (std::uint32_t y = 0; y < 4; ++y) mean += base.at(0, y).red / 4.0;
    CHECK(std::fabs(both.at(0, 0).red - mean) <= 0.5 + 1e-9);
}

TEST_CASE("A new target's base is the material's colour factor as sRGB, or white") {
    TestSession plain(make_plane());
    const TxcTarget white = plain.target(8, 8);
    CHECK(plain.paint(white) == Picture(8, 8, {255, 255, 255, 255}));

    GlbBuilder glb;
    glb.mesh(glb.primitive(make_plane(), R"(,"material":0)"));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("materials", R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.0,1.0,0.25]}})");
    TestSession session;
    session.load(glb.glb());
    const TxcTarget target = session.target(8, 8);
    CHECK(session.paint(target) == Picture(8, 8, {188, 0, 255, 64}));
}

TEST_CASE("Factors out of range are brought into it") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_plane(), R"(,"material":0)"));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("materials", R"({"pbrMetallicRoughness":{"baseColorFactor":[-3,1e300,2,7]}})");
    TestSession session;
    session.load(glb.glb());
    const TxcTarget target = session.target(4, 4);
    CHECK(session.paint(target) == Picture(4, 4, {0, 255, 255, 255}));
}

TEST_CASE("A colour takes the picture's place, and a picture the colour's") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(8, 8);
    const Picture picture = make_noise(8, 8, 125);
    session.set_base(target, picture);
    CHECK(session.paint(target) == picture);
    const std::uint32_t with_picture = session.stats().memory_used_kib;
    session.set_base(target, {1, 2, 3, 4});
    CHECK(session.paint(target) == Picture(8, 8, {1, 2, 3, 4}));
    CHECK(session.stats().memory_used_kib <= with_picture);
    session.set_base(target, picture);
    CHECK(session.paint(target) == picture);
}

TEST_CASE("The caller's picture may be gone after the call") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(8, 8);
    Picture picture = make_noise(8, 8, 126, true);
    const Picture copy = picture;
    session.set_base(target, picture);
    std::fill(picture.rgba.begin(), picture.rgba.end(), std::uint8_t{0});
    CHECK(session.paint(target) == copy);
}
