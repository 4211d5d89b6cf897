// Groups and masks (texelcast.h, "Layers"), through the C ABI.
#include <doctest/doctest.h>

#include <cmath>

#include "support/layer_tree.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 32;

TxcLayerDef group_def(bool isolated = true) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_GROUP;
    def.isolated = isolated ? 1 : 0;
    return def;
}

TxcLayerDef in_group(TxcLayerDef def, TxcLayer parent) {
    def.parent = parent;
    return def;
}
TxcLayerDef in_mask(TxcLayerDef def, TxcLayer parent) {
    def.parent = parent;
    def.role = TXC_ROLE_MASK;
    return def;
}

double worst_distance(const Pixels& expected, const Picture& painted) {
    double worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Color actual = painted.at(static_cast<std::uint32_t>(i % kSize), static_cast<std::uint32_t>(i / kSize));
        const int channels[4] = {actual.red, actual.green, actual.blue, actual.alpha};
        for (int c = 0; c < 4; ++c) {
            // Colour hardly shows where there is hardly any alpha, and there the byte below it decides.
            const double weight = c < 3 ? expected[i].alpha : 1.0;
            const double exact = c < 3 ? expected[i].color[c] : expected[i].alpha;
            worst = std::max(worst, std::fabs(exact * 255.0 - channels[c]) * weight);
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("Groups and masks by lot are within one step of the standard's formulas in double precision") {
    Random random(7);
    for (int round = 0; round < 60; ++round) {
        TestSession session(make_plane());
        const TxcTarget target = session.target(kSize, kSize);
        const bool opaque = random.coin();
        const Picture base = make_noise(kSize, kSize, random.next(), !opaque);
        session.set_base(target, base);
        std::vector<TreeLayer> layers;
        for (int i = 0; i < 4; ++i) layers.push_back(draw_layer(kSize, 3, false, random));
        make_layers(session, target, layers);
        Pixels expected = to_pixels(base);
        lay_reference(layers, expected);
        INFO("round ", round);
        CHECK(worst_distance(expected, session.paint(target)) < 1.0);
    }
}

TEST_CASE("AnIsolatedGroupOfOneLayerIsThatLayer") {
    Random random(3);
    for (const std::uint32_t opacity : {1u, 2u}) {
        TestSession session(make_plane());
        const TxcTarget target = session.target(kSize, kSize);
        session.set_base(target, make_noise(kSize, kSize, 5, true));
        TxcLayerDef def = decal_def(session.image(patchy_noise(kSize, random)));
        def.opacity = 1.0f / static_cast<float>(opacity);
        const TxcLayer alone = session.layer(target, def);
        const Picture expected = session.paint(target);
        must(txc_layer_destroy(session.id(), alone));
        for (const bool isolated : {true, false}) {
            const TxcLayer group = session.layer(target, group_def(isolated));
            session.layer(target, in_group(def, group));
            CHECK(session.paint(target) == expected);
            must(txc_layer_destroy(session.id(), group));
        }
    }
}

TEST_CASE("AGroupThatIsPassedThroughWholeIsAsIfThereWereNone") {
    Random random(11);
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, make_noise(kSize, kSize, 5, true));
    std::vector<TreeLayer> layers;
    for (int i = 0; i < 5; ++i) layers.push_back(draw_layer(kSize, 0, false, random));
    make_layers(session, target, layers);
    const Picture expected = session.paint(target);
    const TxcLayer group = session.layer(target, group_def(false));
    for (const TreeLayer& layer : layers) session.change(layer.handle, in_group(layer.def, group));
    CHECK(session.paint(target) == expected);
}

TEST_CASE(
    "An eraser in an isolated group takes away from the group alone, in one that is passed through from all below") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, Color{200, 100, 50, 255});
    TxcLayerDef eraser = fill_def(0, 0, 0);
    eraser.blend = TXC_BLEND_ERASE;
    const TxcLayer group = session.layer(target, group_def());
    session.layer(target, in_group(fill_def(0, 0, 1), group));
    session.layer(target, in_group(eraser, group));
    CHECK(session.paint(target).at(7, 7) == Color{200, 100, 50, 255});
    session.change(group, group_def(false));
    CHECK(session.paint(target).at(7, 7).alpha == 0);
}

TEST_CASE("AMaskThatShowsAllChangesNothing") {
    Random random(5);
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, make_noise(kSize, kSize, 5, true));
    std::vector<TreeLayer> layers;
    for (int i = 0; i < 6; ++i) layers.push_back(draw_layer(kSize, 2, false, random));
    for (TreeLayer& layer : layers) layer.mask.clear(), layer.def.invert_mask = 0;
    make_layers(session, target, layers);
    const Picture expected = session.paint(target);
    for (const TreeLayer& layer : layers) {
        const TxcLayerDef part = decal_def(session.image(patchy_noise(kSize, random)));
        session.layer(target, in_mask(part, layer.handle));
    }
    CHECK(session.paint(target) == expected);
}

TEST_CASE("A mask hides where it is erased, shows again where it is painted, and inverts") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, Color{0, 0, 0, 255});
    const TxcLayer white = session.layer(target, fill_def(1, 1, 1));
    TxcLayerDef hide = fill_def(0, 0, 0);
    hide.blend = TXC_BLEND_ERASE;
    const TxcLayer hiding = session.layer(target, in_mask(hide, white));
    CHECK(session.paint(target).at(4, 4) == Color{0, 0, 0, 255});
    Picture left(2, 1, {0, 0, 0, 0});
    left.set(0, 0, {90, 0, 0, 255});
    TxcLayerDef show = decal_def(session.image(left));
    show.filter = TXC_FILTER_NEAREST;
    const TxcLayer showing = session.layer(target, in_mask(show, white));
    Picture picture = session.paint(target);
    CHECK(picture.at(4, 4) == Color{255, 255, 255, 255});
    CHECK(picture.at(20, 4) == Color{0, 0, 0, 255});
    TxcLayerDef inverted = session.layer_def(white);
    inverted.invert_mask = 1;
    session.change(white, inverted);
    picture = session.paint(target);
    CHECK(picture.at(4, 4) == Color{0, 0, 0, 255});
    CHECK(picture.at(20, 4) == Color{255, 255, 255, 255});
    must(txc_layer_destroy(session.id(), showing));
    must(txc_layer_destroy(session.id(), hiding));
    CHECK(session.paint(target).at(4, 4) == Color{0, 0, 0, 255});
}

TEST_CASE("Layers that show nothing can stand in any order") {
    Random random(13);
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, make_noise(kSize, kSize, 5, true));
    std::vector<TreeLayer> layers;
    for (int i = 0; i < 5; ++i) layers.push_back(draw_layer(kSize, 2, false, random));
    layers[1].def.opacity = layers[3].def.opacity = 0;
    make_layers(session, target, layers);
    const Picture expected = session.paint(target);
    must(txc_layer_move(session.id(), layers[1].handle, 4));
    must(txc_layer_move(session.id(), layers[3].handle, 0));
    CHECK(session.paint(target) == expected);
}

TEST_CASE("A change of the tree gives what making the tree anew gives") {
    Random random(17);
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const Picture base = make_noise(kSize, kSize, 5, true);
    session.set_base(target, base);
    std::vector<TreeLayer> layers;
    for (int i = 0; i < 4; ++i) layers.push_back(draw_layer(kSize, 2, false, random));
    make_layers(session, target, layers);
    session.update(target);
    const TxcLayer group = session.layer(target, group_def());
    for (int step = 0; step < 60; ++step) {
        TreeLayer& layer = layers[random.below(4)];
        const std::uint32_t lot = random.below(6);
        if (lot == 0) layer.def.opacity = static_cast<float>(random.unit());
        if (lot == 1) layer.def.visible ^= 1;
        if (lot == 2) layer.def.invert_mask ^= 1;
        if (lot == 3) layer.def.parent = layer.def.parent == 0 ? group : 0;
        if (lot == 4) layer.def.isolated ^= 1;
        if (lot == 5) must(txc_layer_move(session.id(), layer.handle, random.below(5)));
        session.change(layer.handle, layer.def);
        const Picture changed = session.paint(target);
        session.set_base(target, base);  // composites every tile again
        session.update(target);
        CHECK(session.read(target) == changed);
    }
}

TEST_CASE("A layer's change under others projects that layer alone, whatever groups and masks there are") {
    Random random(19);
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    std::vector<TreeLayer> layers;
    for (int i = 0; i < 6; ++i) layers.push_back(draw_layer(kSize, 3, false, random));
    for (TreeLayer& layer : layers) layer.def.visible = 1;
    make_layers(session, target, layers);
    session.update(target);
    TxcLayerDef group = group_def();
    group.opacity = 0.5f;
    const TxcLayer holder = session.layer(target, group);
    TxcLayerDef def = in_group(decal_def(session.image(patchy_noise(kSize, random))), holder);
    const TxcLayer layer = session.layer(target, def);
    CHECK(session.update(target).projected_layers == 1);
    def.position_model[0] = 0.25f;
    session.change(layer, def);
    CHECK(session.update(target).projected_layers == 1);
    group.opacity = 0.75f;
    session.change(holder, group);
    CHECK(session.update(target).projected_layers == 0);
}

TEST_CASE("A change of a mask composites no further than it reaches") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    const TxcLayer fill = session.layer(target, fill_def(1, 0, 0));
    session.update(target);
    TxcLayerDef part = decal_def(session.image(Picture(2, 2, {0, 0, 0, 255})));
    part.blend = TXC_BLEND_ERASE;
    part.projector = TXC_PROJECTOR_UV;
    part.uv_size[0] = part.uv_size[1] = 0.1f;
    session.layer(target, in_mask(part, fill));
    CHECK(session.update(target).composited_texels <= 16 * 16 * 16);
    // A fill of a mask reaches as far as the layer that is masked.
    TxcLayerDef stamp = part;
    stamp.blend = TXC_BLEND_NORMAL;
    const TxcLayer stamped = session.layer(target, stamp);
    session.update(target);
    session.layer(target, in_mask(fill_def(0, 0, 0, 0.5f), stamped));
    CHECK(session.update(target).composited_texels <= 16 * 16 * 16);
}

TEST_CASE("What a tree cannot be is refused by name, and nothing changes") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcTarget other = session.target(16, 16);
    const TxcLayer group = session.layer(target, group_def());
    const TxcLayer inner = session.layer(target, in_group(group_def(), group));
    const TxcLayer fill = session.layer(target, fill_def(1, 0, 0));
    TxcLayer made = 0;
    const auto refuses = [&](TxcTarget on, TxcLayerDef def, TxcStatus status, const char* words) {
        CHECK(txc_layer_create(session.id(), on, &def, &made) == status);
        INFO(txc_error_detail());
        CHECK(std::string(txc_error_detail()).find(words) != std::string::npos);
    };
    refuses(target, in_group(fill_def(1, 0, 0), fill), TXC_STATUS_BAD_ARGUMENT, "is not a group");
    refuses(target, in_group(fill_def(1, 0, 0), 9999), TXC_STATUS_STALE_HANDLE, "no layer 9999");
    refuses(target, in_mask(fill_def(1, 0, 0), 0), TXC_STATUS_BAD_ARGUMENT, "role is 1");
    refuses(target, in_mask(group_def(), fill), TXC_STATUS_BAD_ARGUMENT, "cannot be part of a mask");
    refuses(other, in_group(fill_def(1, 0, 0), group), TXC_STATUS_BAD_ARGUMENT, "of another target");
    const TxcLayerDef loop = in_group(group_def(), inner);
    CHECK(txc_layer_update(session.id(), group, &loop) == TXC_STATUS_BAD_ARGUMENT);
    const TxcLayerDef kind = fill_def(1, 0, 0);
    CHECK(txc_layer_update(session.id(), group, &kind) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(session.layer_def(group).kind == TXC_LAYER_GROUP);
    TxcLayer parent = inner;
    for (std::uint32_t depth = 3; depth <= TXC_MAX_DEPTH; ++depth)
        parent = session.layer(target, in_group(group_def(), parent));
    refuses(target, in_group(fill_def(1, 0, 0), parent), TXC_STATUS_BAD_ARGUMENT, "18 deep");
    const TxcLayer deep = session.layer(target, group_def());
    session.layer(target, in_group(fill_def(1, 0, 0), deep));
    const TxcLayerDef too_deep = in_group(group_def(), session.layer_def(parent).parent);
    CHECK(txc_layer_update(session.id(), deep, &too_deep) == TXC_STATUS_BAD_ARGUMENT);
}

TEST_CASE("A group ends with all that is in it") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcLayer group = session.layer(target, group_def());
    const TxcLayer inside = session.layer(target, in_group(fill_def(1, 0, 0), group));
    const TxcLayer masking = session.layer(target, in_mask(fill_def(1, 0, 0), inside));
    must(txc_layer_destroy(session.id(), group));
    TxcLayerDef def;
    CHECK(txc_layer_def(session.id(), inside, &def) == TXC_STATUS_STALE_HANDLE);
    CHECK(txc_layer_def(session.id(), masking, &def) == TXC_STATUS_STALE_HANDLE);
    CHECK(session.paint(target).at(3, 3) == Color{255, 255, 255, 255});
}

TEST_CASE("A group that is passed through and locks alpha leaves what is below as it was where its layers erase all") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const Picture base = make_noise(kSize, kSize, 29);
    session.set_base(target, base);
    for (const std::uint32_t space : {TXC_BLEND_SPACE_SRGB, TXC_BLEND_SPACE_LINEAR}) {
        TxcLayerDef def = group_def(false);
        def.lock_alpha = 1;
        def.blend_space = space;
        const TxcLayer group = session.layer(target, def);
        TxcLayerDef eraser = fill_def(0, 0, 0);
        eraser.blend = TXC_BLEND_ERASE;
        session.layer(target, in_group(eraser, group));
        CAPTURE(space);
        CHECK(count_differences(session.paint(target), base) == 0);
        must(txc_layer_destroy(session.id(), group));
    }
}
