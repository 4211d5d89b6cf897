// A drag over many layers (wasm/backdrop_cache.h): what is held below the dragged layer may never show.
#include <doctest/doctest.h>

#include <cmath>

#include "support/layer_tree.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 64;

/// All layers of a tree that are no groups.
void list_leaves(std::vector<TreeLayer>& layers, std::vector<TreeLayer*>& out) {
    for (TreeLayer& layer : layers) {
        if (layer.def.kind != TXC_LAYER_GROUP) out.push_back(&layer);
        list_leaves(layer.mask, out);
        list_leaves(layer.content, out);
    }
}

/// The texture with nothing held from before.
Picture painted_anew(TestSession& session, TxcTarget target, const Picture& base) {
    session.set_base(target, base);
    return session.paint(target);
}

}  // namespace

TEST_CASE("Drags by lot through trees by lot give the bytes that painting anew gives") {
    Random random(23);
    for (int round = 0; round < 12; ++round) {
        TestSession session(make_plane());
        const TxcTarget target = session.target(kSize, kSize);
        const Picture base = make_noise(kSize, kSize, random.next(), random.coin());
        session.set_base(target, base);
        std::vector<TreeLayer> layers;
        for (int i = 0; i < 8; ++i) layers.push_back(draw_layer(kSize, 3, false, random));
        make_layers(session, target, layers);
        session.update(target);
        std::vector<TreeLayer*> leaves;
        list_leaves(layers, leaves);
        if (leaves.empty()) continue;
        for (int drag = 0; drag < 6; ++drag) {
            TreeLayer& dragged = *leaves[random.below(static_cast<std::uint32_t>(leaves.size()))];
            for (int step = 0; step < 5; ++step) {
                dragged.def.position_model[0] = static_cast<float>(random.between(-0.5, 0.5));
                session.change(dragged.handle, dragged.def);
                if (random.below(6) == 0) {
                    TreeLayer& other = *leaves[random.below(static_cast<std::uint32_t>(leaves.size()))];
                    other.def.opacity = static_cast<float>(random.unit());
                    session.change(other.handle, other.def);
                }
                if (random.below(12) == 0) must(txc_layer_move(session.id(), layers[0].handle, random.below(8)));
                session.update(target);
            }
            const Picture dragged_to = session.read(target);
            INFO("round ", round, ", drag ", drag);
            CHECK(painted_anew(session, target, base) == dragged_to);
        }
    }
}

TEST_CASE("A drag over many layers holds what lies below it, and gives it up when room is short") {
    Random random(29);
    TestSession session(16);
    session.add(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    for (int i = 0; i < 8; ++i) {
        def.image = session.image(make_noise(16, 16, random.next(), true));
        session.layer(target, def);
    }
    def.size[0] = def.size[1] = 0.5f;
    const TxcLayer top = session.layer(target, def);
    session.update(target);
    const std::uint32_t before = session.stats().memory_used_kib;
    for (int step = 1; step <= 4; ++step) {
        def.position_model[0] = static_cast<float>(step) / 64;
        session.change(top, def);
        session.update(target);
    }
    const std::uint32_t held = session.stats().memory_used_kib;
    CHECK(held > before + 64 * 4);
    CHECK(held <= before + 16 * 1024 / 4 + 256);
    // Pictures until the room is short: the last of them fits only where the backdrops were.
    const Picture picture(64, 64, {1, 2, 3, 255});
    bool gave_up = false;
    for (std::uint32_t used = held; !gave_up;) {
        session.image(picture);
        gave_up = session.stats().memory_used_kib < used;
        used = session.stats().memory_used_kib;
    }
    CHECK(session.stats().memory_used_kib < session.stats().memory_budget_kib);
    const Picture dragged = session.paint(target);
    session.set_base(target, Color{255, 255, 255, 255});
    CHECK(session.paint(target) == dragged);
}

TEST_CASE("A session without room to spare drags all the same") {
    Random random(31);
    const auto drag = [&](std::uint32_t budget_mib) {
        Random same(31);
        TestSession session(budget_mib);
        session.add(make_plane());
        const TxcTarget target = session.target(512, 512);
        TxcLayerDef def = decal_def(0);
        TxcLayer top = 0;
        for (int i = 0; i < 5; ++i) {
            def.image = session.image(make_noise(16, 16, same.next(), true));
            def.size[0] = def.size[1] = 0.4f;
            top = session.layer(target, def);
        }
        for (int step = 1; step <= 5; ++step) {
            def.position_model[0] = static_cast<float>(step) / 32;
            session.change(top, def);
            session.update(target);
        }
        return session.read(target);
    };
    CHECK(drag(10) == drag(512));
}
