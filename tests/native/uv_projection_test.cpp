// The flat stamp: laid on the unfolded texture, whatever surface lies under it (spec section 3).
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

double share(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    return (picture.at(x, y).red - kBase.red) / static_cast<double>(kPaint.red - kBase.red);
}

}  // namespace

TEST_CASE("Stamps magnified and minified up to eight times agree, upright and turned") {
    Comparison plane(make_plane(), 64, 64);
    for (const double pixels_a_texel : {0.125, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
        for (const double degrees : {0.0, 20.0, 200.0}) {
            CAPTURE(pixels_a_texel);
            CAPTURE(degrees);
            const auto size = static_cast<std::uint32_t>(48 * pixels_a_texel + 0.5);
            const TxcLayerDef def = uv_def(0, 0.53, 0.48, 0.75, 0.75, degrees);
            check(plane.paint(def, make_checker(size, size, 5)));
            check(plane.paint(def, make_gradient(size, size, true)));
        }
    }
}

TEST_CASE("Stamps agree on a texture that is wider than high, flipped and tiled") {
    Comparison sphere(make_sphere(1.0, 32, 16), 192, 96);
    Random random(100);
    for (int round = 0; round < 16; ++round) {
        CAPTURE(round);
        TxcLayerDef def = uv_def(0, random.between(0, 1), random.between(0, 1), random.between(0.2, 0.8),
                                 random.between(0.2, 0.8), random.between(-400, 400));
        def.flip_x = random.below(2);
        def.flip_y = random.below(2);
        def.wrap = random.below(2);
        check(sphere.paint(def, make_checker(80, 60, 10)));
    }
}

TEST_CASE("A stamp over the whole texture copies its picture byte for byte") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 12, 0);
    const Picture picture = make_noise(16, 12, 101, true);
    TxcLayerDef def = uv_def(session.image(picture), 0.5, 0.5, 1, 1, 0);
    def.filter = TXC_FILTER_NEAREST;
    CHECK(paint(session, target, def) == picture);
}

TEST_CASE("A stamp is turned clockwise as seen on the texture") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64, 0);
    Picture corners(2, 2);
    const Color top_left{255, 0, 0, 255}, top_right{0, 255, 0, 255}, low_left{0, 0, 255, 255},
        low_right{255, 255, 0, 255};
    corners.set(0, 0, top_left);
    corners.set(1, 0, top_right);
    corners.set(0, 1, low_left);
    corners.set(1, 1, low_right);
    TxcLayerDef def = uv_def(session.image(corners), 0.5, 0.5, 0.5, 0.5, 0);
    def.filter = TXC_FILTER_NEAREST;
    Picture picture = paint(session, target, def);
    CHECK(picture.at(20, 20) == top_left);
    CHECK(picture.at(44, 20) == top_right);
    CHECK(picture.at(20, 44) == low_left);
    CHECK(picture.at(15, 20) == kBase);
    for (const float quarter : {90.0f, -270.0f, 3690.0f}) {
        def.uv_angle_degrees = quarter;
        picture = paint(session, target, def);
        CHECK(picture.at(44, 20) == top_left);
        CHECK(picture.at(44, 44) == top_right);
        CHECK(picture.at(20, 20) == low_left);
    }
}

TEST_CASE("A stamp asks neither where a texel lies, nor where it looks, nor what hides it") {
    // Two plates that shade each other from the front, and one turned away: all three take the stamp, whole.
    Shape shape = make_plane(1.0, 0.0, {0.0, 0.0, 0.4, 1.0});
    shape.append(make_plane(1.0, 0.3, {0.4, 0.0, 0.7, 1.0}));
    Shape turned = make_plane(1.0, -0.3, {0.7, 0.0, 1.0, 1.0});
    for (float& part : turned.normals) part = -part;
    for (std::size_t i = 0; i < turned.indices.size(); i += 3) std::swap(turned.indices[i], turned.indices[i + 1]);
    shape.append(turned);
    TestSession session(shape);
    const TxcTarget target = session.target(60, 60, 0);
    TxcLayerDef def = uv_def(session.image(Picture(4, 4, kPaint)), 0.5, 0.5, 2, 2, 0);
    def.occlusion = TXC_OCCLUSION_SELF;
    def.angle_fade_start = def.angle_fade_end = 1.0f;
    // Its place and turn in the model count for nothing, and need not even be any.
    for (float& coordinate : def.position_model) coordinate = 1e30f;
    for (float& part : def.rotation) part = 0.0f;
    CHECK(paint(session, target, def) == Picture(60, 60, kPaint));
}

TEST_CASE("A stamp paints covered and gutter texels alone") {
    TestSession session(make_plane(0.5, 0.0, {0.25, 0.25, 0.75, 0.75}));
    const TxcTarget target = session.target(64, 64, 6);
    const TxcLayerDef def = uv_def(session.image(Picture(4, 4, kPaint)), 0.5, 0.5, 2, 2, 0);
    const Picture picture = paint(session, target, def);
    const MapArrays map = session.map(target);
    std::uint32_t empty = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            CHECK_UNARY(picture.at(x, y) == (map.coverage_at(x, y) == 0 ? kBase : kPaint));
            empty += map.coverage_at(x, y) == 0 ? 1 : 0;
        }
    }
    CHECK(empty > 1000);
}

TEST_CASE("A stamp that reaches beyond the texture's edge does not come in again at the other side") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64, 0);
    const TxcLayerDef def = uv_def(session.image(Picture(64, 64, kPaint)), 1.0, 0.5, 0.5, 0.5, 0);
    const Picture picture = paint(session, target, def);
    CHECK(picture.at(60, 32) == kPaint);
    CHECK(picture.at(50, 32) == kPaint);
    CHECK(picture.at(46, 32) == kBase);
    CHECK(picture.at(0, 32) == kBase);
    CHECK(picture.at(12, 32) == kBase);
}

TEST_CASE("A design's stamp covers the same part of the texture at every size") {
    TestSession session(make_plane());
    TxcLayerDef def = uv_def(session.image(Picture(256, 256, kPaint)), 0.4, 0.6, 0.5, 0.3, 30);
    const Picture large = paint(session, session.target(256, 128, 0), def);
    const Picture small = paint(session, session.target(64, 128, 0), def);
    double painted = 0.0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            double mean = 0.0;
            for (std::uint32_t i = 0; i < 4; ++i) mean += share(large, x * 4 + i, y) / 4;
            CHECK(std::fabs(share(small, x, y) - mean) < 0.05);
            painted += mean;
        }
    }
    CHECK(painted / (64 * 128) == doctest::Approx(0.5 * 0.3).epsilon(0.01));
}

TEST_CASE("Stamps of every size and place are survived") {
    TestSession session(make_sphere(1.0, 8, 4));
    const TxcTarget target = session.target(48, 32);
    const TxcImage images[] = {session.image(make_checker(64, 64, 3)), session.image(make_noise(1, 700, 102))};
    Random random(103);
    const auto draw = [&random](double low, double high) { return std::pow(10.0, random.between(low, high)); };
    std::uint32_t painted = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        const bool far = round % 4 == 0;
        TxcLayerDef def =
            uv_def(images[round % 2], far ? draw(-3, 11.9) : random.unit(), far ? -draw(-3, 11.9) : random.unit(),
                   draw(-11.9, 11.9), draw(-11.9, 11.9), round % 2 == 0 ? draw(-9, 11.9) : -draw(-9, 11.9));
        def.filter = random.below(2);
        def.wrap = random.below(2);
        const Picture picture = paint(session, target, def);
        std::uint32_t opaque = 0;
        for (std::size_t i = 3; i < picture.rgba.size(); i += 4) opaque += picture.rgba[i] == 255 ? 1 : 0;
        CHECK(opaque == 48 * 32);
        painted += picture == Picture(48, 32, kBase) ? 0 : 1;
    }
    CHECK(painted > 20);
}
