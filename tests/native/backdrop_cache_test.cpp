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

/// Layers by lot over a noisy picture, painted.
struct TreeByLot {
    TestSession session{make_plane()};
    TxcTarget target = session.target(kSize, kSize);
    Picture base;
    std::vector<TreeLayer> layers;

    explicit TreeByLot(Random& random) : base(make_noise(kSize, kSize, random.next(), random.coin())) {
        session.set_base(target, base);
        for (int i = 0; i < 8; ++i) layers.push_back(draw_layer(kSize, 3, false, random));
        make_layers(session, target, layers);
        session.update(target);
    }
};

}  // namespace

TEST_CASE("Drags by lot through trees by lot give the bytes that painting anew gives") {
    Random random(23);
    for (int round = 0; round < 12; ++round) {
        TreeByLot by_lot(random);
        TestSession& session = by_lot.session;
        const TxcTarget target = by_lot.target;
        const Picture& base = by_lot.base;
        std::vector<TreeLayer>& layers = by_lot.layers;
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

namespace {

/// Everything that can be held for a layer, in steps of so many tiles.
void prepare(TestSession& session, TxcLayer layer, bool inside, std::uint32_t tiles_a_call = 7) {
    for (std::uint32_t tile = 0; tile != TXC_NONE;)
        must(txc_layer_prepare(session.id(), layer, inside ? 1 : 0, tile, tiles_a_call, &tile));
}

/// All layers of a tree, groups too.
void list_all(std::vector<TreeLayer>& layers, std::vector<TreeLayer*>& out) {
    for (TreeLayer& layer : layers) {
        out.push_back(&layer);
        list_all(layer.mask, out);
        list_all(layer.content, out);
    }
}

/// Ten layers over a whole target of 256 tiles, of which the topmost, a group, holds four.
struct Stack {
    TestSession session{64};
    TxcTarget target;
    TxcLayerDef def = decal_def(0);
    TxcLayer group;
    TxcLayer mask = 0;
    TxcLayer top = 0;

    explicit Stack(bool isolated) {
        Random random(37);
        session.add(make_plane());
        target = session.target(256, 256);
        def.image = session.image(make_noise(16, 16, random.next(), true));
        for (int i = 0; i < 9; ++i) session.layer(target, def);
        TxcLayerDef holder = decal_def(0);
        holder.kind = TXC_LAYER_GROUP;
        holder.isolated = isolated ? 1 : 0;
        group = session.layer(target, holder);
        for (int i = 0; i < 4; ++i) top = add(TXC_ROLE_CONTENT);
        session.update(target);
    }

    TxcLayer add(std::uint32_t role) {
        TxcLayerDef held = def;
        held.parent = group;
        held.role = role;
        return session.layer(target, held);
    }

    std::uint32_t used_kib() { return session.stats().memory_used_kib; }
};

constexpr std::uint32_t kGroundKib = 256 * 4;  // of one ground on all tiles

}  // namespace

TEST_CASE("What is held for changes that are expected, and for others, never shows") {
    Random random(41);
    for (int round = 0; round < 10; ++round) {
        TreeByLot by_lot(random);
        TestSession& session = by_lot.session;
        const TxcTarget target = by_lot.target;
        const Picture& base = by_lot.base;
        std::vector<TreeLayer>& layers = by_lot.layers;
        std::vector<TreeLayer*> all;
        list_all(layers, all);
        std::vector<TxcLayer> added;
        for (int act = 0; act < 40; ++act) {
            TreeLayer& some = *all[random.below(static_cast<std::uint32_t>(all.size()))];
            if (random.below(3) == 0) prepare(session, some.handle, random.coin(), 1 + random.below(9));
            for (int step = random.below(3); step >= 0; --step) {
                some.def.position_model[0] = static_cast<float>(random.between(-0.5, 0.5));
                if (random.below(4) == 0) some.def.opacity = static_cast<float>(random.unit());
                if (random.below(6) == 0) some.def.visible ^= 1;
                if (random.below(6) == 0) some.def.invert_mask ^= 1;
                session.change(some.handle, some.def);
                if (random.coin()) session.update(target);
            }
            TxcLayerDef def = decal_def(all[0]->def.image);
            def.image = session.image(patchy_noise(16, random));
            def.role = some.def.kind == TXC_LAYER_GROUP && random.coin() ? TXC_ROLE_CONTENT : TXC_ROLE_MASK;
            def.parent = some.handle;
            if (random.coin()) added.push_back(session.layer(target, def));
            if (!added.empty() && random.below(4) == 0) {
                must(txc_layer_destroy(session.id(), added.back()));
                added.pop_back();
            }
            if (random.below(8) == 0) must(txc_layer_move(session.id(), some.handle, random.below(4)));
            session.update(target);
            if (act % 4 != 3) continue;
            const Picture after = session.read(target);
            INFO("round ", round, ", act ", act);
            CHECK(painted_anew(session, target, base) == after);
        }
    }
}

TEST_CASE("Getting ready for a layer holds what lies below it, so that the first step of its drag finds it") {
    Stack stack(true);
    const Picture before = stack.session.read(stack.target);
    const std::uint32_t used = stack.used_kib();
    prepare(stack.session, stack.top, false);
    CHECK(stack.session.read(stack.target) == before);
    const std::uint32_t held = stack.used_kib();
    CHECK(held >= used + 2 * kGroundKib);
    stack.def.parent = stack.group;
    stack.def.opacity = 0.5f;
    stack.session.change(stack.top, stack.def);
    CHECK(stack.session.update(stack.target).composited_texels == 256 * 256);
    CHECK(stack.used_kib() == held);
}

TEST_CASE("A new base shows through all that was held over the old one, be it a colour or a picture") {
    const Picture picture = make_noise(256, 256, 41);
    for (const bool is_picture : {false, true}) {
        const auto change_base = [&](Stack& stack) {
            if (is_picture)
                stack.session.set_base(stack.target, picture);
            else
                stack.session.set_base(stack.target, Color{200, 10, 30, 255});
        };
        Stack held(true);
        prepare(held.session, held.top, false);
        change_base(held);
        Stack fresh(true);
        change_base(fresh);
        CHECK_UNARY(held.session.paint(held.target) == fresh.session.paint(fresh.target));
    }
}

TEST_CASE("What is put on top in a group, and what hides it, begins on what is held of the group") {
    for (const bool isolated : {true, false}) {
        for (const std::uint32_t role : {std::uint32_t{TXC_ROLE_CONTENT}, std::uint32_t{TXC_ROLE_MASK}}) {
            Stack stack(isolated);
            // A mask that shows nothing yet leaves a group that is passed through without a ground of its own.
            if (role == TXC_ROLE_MASK) stack.add(role);
            stack.session.update(stack.target);
            prepare(stack.session, stack.group, true);
            const std::uint32_t held = stack.used_kib();
            for (int stroke = 0; stroke < 3; ++stroke) {
                const std::uint32_t before = stack.used_kib();
                stack.add(role);
                stack.session.update(stack.target);
                INFO("isolated ", isolated, ", role ", role, ", stroke ", stroke);
                // The new layer's own tiles, 2 KiB each, and nothing given up for them.
                CHECK(stack.used_kib() >= before + 512);
                CHECK(stack.used_kib() <= before + 516);
            }
            CHECK(stack.used_kib() >= held + 3 * 512);
        }
    }
}

TEST_CASE("Getting ready goes by as many tiles as asked, and waits for updates and for what is not shown") {
    Stack stack(true);
    std::uint32_t next = 0;
    stack.def.parent = stack.group;
    stack.def.opacity = 0.25f;
    stack.session.change(stack.top, stack.def);
    const std::uint32_t used = stack.used_kib();
    must(txc_layer_prepare(stack.session.id(), stack.top, 0, 0, 1000, &next));
    CHECK(next == TXC_NONE);
    CHECK(stack.used_kib() == used);
    stack.def.visible = 0;
    stack.session.change(stack.top, stack.def);
    stack.session.update(stack.target);
    must(txc_layer_prepare(stack.session.id(), stack.top, 0, 0, 1000, &next));
    CHECK(next == TXC_NONE);
    Stack fresh(true);
    must(txc_layer_prepare(fresh.session.id(), fresh.top, 0, 0, 10, &next));
    CHECK(next == 10);
    CHECK(txc_layer_prepare(stack.session.id(), 987654, 0, 0, 10, &next) == TXC_STATUS_STALE_HANDLE);
    CHECK(txc_layer_prepare(stack.session.id(), stack.top, 0, 0, 10, nullptr) == TXC_STATUS_BAD_ARGUMENT);
}
