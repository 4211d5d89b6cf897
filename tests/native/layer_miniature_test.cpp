// Small pictures of layers, for lists (layer_miniature.h), through the C ABI.
#include "layer_miniature.h"

#include <doctest/doctest.h>

#include "support/allocation_meter.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSide = 16;

Picture miniature(const TestSession& session, TxcLayer layer, bool of_mask = false) {
    Picture picture(kSide, kSide);
    must(txc_layer_miniature(session.id(), layer, of_mask ? 1 : 0, kSide, picture.rgba.data()));
    return picture;
}

/// A red square over a part of the texture.
TxcLayerDef stamp(TestSession& session, float u, float v, float size) {
    TxcLayerDef def = decal_def(session.image(Picture(8, 8, {255, 0, 0, 255})));
    def.projector = TXC_PROJECTOR_UV;
    def.uv_center[0] = u;
    def.uv_center[1] = v;
    def.uv_size[0] = def.uv_size[1] = size;
    return def;
}

}  // namespace

TEST_CASE("A miniature shows the square of the texture around what the layer paints") {
    TestSession session(make_plane());
    // A wide texture: 16 x 8 texels at its left edge, on two by two tiles.
    const TxcTarget target = session.target(128, 64);
    const TxcLayer layer = session.layer(target, stamp(session, 0.0625f, 0.5f, 0.125f));
    session.update(target);
    const Picture picture = miniature(session, layer);
    const Color inside = picture.at(kSide / 4, kSide / 2);
    CHECK(inside.red == 255);
    CHECK(inside.alpha == 255);
    CHECK(picture.at(0, 0).alpha == 0);
    CHECK(picture.at(kSide - 1, kSide - 1).alpha == 0);
}

TEST_CASE("A mask's miniature is white where the layer shows and black where it does not") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    const TxcLayer layer = session.layer(target, stamp(session, 0.5f, 0.5f, 1.0f));
    CHECK(miniature(session, layer, true).at(3, 3).red == 255);
    TxcLayerDef hole = stamp(session, 0.25f, 0.25f, 0.5f);
    hole.parent = layer;
    hole.role = TXC_ROLE_MASK;
    hole.blend = TXC_BLEND_ERASE;
    session.layer(target, hole);
    session.update(target);
    const Picture mask = miniature(session, layer, true);
    CHECK(mask.at(3, 3).red == 0);
    CHECK(mask.at(12, 12).red == 255);
    CHECK(mask.at(3, 3).alpha == 255);
}

TEST_CASE("The square is the smallest around the marks, and all of the target without any") {
    std::vector<std::uint8_t> tiles(8 * 4);
    const txc::MiniatureArea all = txc::miniature_area(tiles, 8);
    CHECK(all.side == 128);
    CHECK(all.x == 0);
    CHECK(all.y == -32);
    tiles[1 * 8 + 2] = 1;
    tiles[3 * 8 + 2] = 1;
    const txc::MiniatureArea tall = txc::miniature_area(tiles, 8);
    CHECK(tall.side == 48);
    CHECK(tall.x == 16);
    CHECK(tall.y == 16);
}

TEST_CASE("What lies in a group is laid over another where it paints, without a picture for each of them") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(128, 128);
    TxcLayerDef group;
    txc_layer_def_default(&group);
    group.kind = TXC_LAYER_GROUP;
    const TxcLayer holder = session.layer(target, group);
    const auto put = [&](float u, float v, float size, std::uint32_t blend, float opacity) {
        TxcLayerDef def = stamp(session, u, v, size);
        def.parent = holder;
        def.blend = blend;
        def.opacity = opacity;
        session.layer(target, def);
    };
    const TxcLayer alone = session.layer(target, stamp(session, 0.5f, 0.5f, 1.0f));
    put(0.5f, 0.5f, 1.0f, TXC_BLEND_NORMAL, 0.5f);
    // The left half a second time, and a hole in the middle.
    put(0.25f, 0.5f, 0.5f, TXC_BLEND_NORMAL, 0.5f);
    put(0.5f, 0.5f, 0.25f, TXC_BLEND_ERASE, 1.0f);
    session.update(target);
    const Picture picture = miniature(session, holder);
    CHECK(picture.at(2, 5).alpha == 191);
    CHECK(picture.at(13, 8).alpha == 128);
    CHECK(picture.at(8, 8).alpha == 0);
    CHECK(picture.at(8, 2).red == 255);
    if (!support::kMetersAllocations) return;
    const auto peak_of = [&](TxcLayer layer) {
        miniature(session, layer);
        support::take_allocation_peak();
        const std::uint64_t before = support::allocated_bytes();
        miniature(session, layer);
        return support::take_allocation_peak() - before;
    };
    // Beside what the one layer's takes, the nodes of those in the group.
    CHECK(peak_of(holder) < peak_of(alone) + 2048);
}
