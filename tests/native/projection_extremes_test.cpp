// Planar decals far away, very large and very small (spec sections 3 to 5).
#include <doctest/doctest.h>

#include <cmath>

#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

Picture paint(TestSession& session, TxcTarget target, const TxcLayerDef& def) {
    const TxcLayer layer = session.layer(target, def);
    Picture picture = session.paint(target);
    must(txc_layer_destroy(session.id(), layer));
    return picture;
}

}  // namespace

TEST_CASE("A decal far from the model, or the model far from the origin, keeps its place") {
    TestSession session(moved(make_plane(), 1000, 2000, -500));
    const TxcTarget target = session.target(64, 64);
    session.set_base(target, kBase);
    TxcLayerDef def = decal_def(session.image(Picture(8, 8, kPaint)));
    place(def, 1000, 2000, -500);
    resize(def, 0.5, 0.5, 0.01);
    const Picture picture = paint(session, target, def);
    CHECK(picture.at(32, 32) == kPaint);
    CHECK(picture.at(18, 32) == kPaint);
    CHECK(picture.at(12, 32) == kBase);
    place(def, 0, 0, 0);
    CHECK(paint(session, target, def) == Picture(64, 64, kBase));
}

TEST_CASE("Boxes of every size and place are survived") {
    // Footprints from nothing to far beyond all pixels: no number may overflow (UBSan looks on), and what is opaque on
    // opaque stays so.
    Shape shape = make_sphere(1.0, 8, 4, {0.0, 0.0, 0.5, 1.0});
    shape.append(make_plane(1e-6, 0.0, {0.5, 0.0, 1.0, 0.5}));
    shape.append(make_plane(1e6, 0.0, {0.5, 0.5, 1.0, 1.0}));
    TestSession session(shape);
    const TxcTarget target = session.target(32, 32);
    session.set_base(target, kBase);
    const TxcImage images[] = {session.image(make_checker(64, 64, 3)), session.image(make_noise(1, 700, 52))};
    Random random(53);
    const auto draw = [&random](double low, double high) {
        return static_cast<float>(std::pow(10.0, random.between(low, high)));
    };
    std::uint32_t painted = 0;
    for (int round = 0; round < 400; ++round) {
        CAPTURE(round);
        TxcLayerDef def = decal_def(images[round % 2]);
        random.rotation(def.rotation);
        // Most near enough to paint, whatever their size; some anywhere.
        for (float& coordinate : def.position_model)
            coordinate = round % 3 == 0 ? draw(-6, 11.9) : static_cast<float>(random.between(-0.5, 0.5));
        for (float& extent : def.size) extent = round % 2 == 0 ? draw(-11.9, 11.9) : draw(-1, 11.9);
        draw_switches(def, random);
        const Picture picture = paint(session, target, def);
        CHECK(count_opaque(picture) == 32 * 32);
        painted += picture == Picture(32, 32, kBase) ? 0 : 1;
    }
    CHECK(painted > 40);
}
