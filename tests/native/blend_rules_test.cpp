// What holds for every blend mode, whatever its formula: order, opacity, alpha, and that no texel hangs on its
// neighbours or on the way by which the compositor took it (spec section 6).
#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 64;
constexpr Color kWhite{255, 255, 255, 255};

struct Easel {
    TestSession session{make_plane()};
    TxcTarget target = session.target(kSize, kSize);

    /// A decal whose pixels are the texels, one to one.
    TxcLayerDef pixels(const Picture& picture, std::uint32_t blend = TXC_BLEND_NORMAL,
                       std::uint32_t blend_space = TXC_BLEND_SPACE_SRGB) {
        TxcLayerDef def = decal_def(session.image(picture));
        def.filter = TXC_FILTER_NEAREST;
        resize(def, 1, 1, 1);
        def.blend = blend;
        def.blend_space = blend_space;
        return def;
    }
    TxcLayer add(const TxcLayerDef& def) { return session.layer(target, def); }
    Picture paint() { return session.paint(target); }
};

template <typename Check>
void for_each_mode(Check&& check) {
    for (std::uint32_t blend = 0; blend < TXC_BLEND_COUNT; ++blend) {
        for (std::uint32_t space = 0; space < TXC_BLEND_SPACE_COUNT; ++space) {
            CAPTURE(blend);
            CAPTURE(space);
            check(blend, space);
        }
    }
}

/// Noise of which stripes are clear and stripes are solid: whole groups of texels of either kind, and their borders.
Picture make_striped_noise(std::uint64_t seed) {
    Picture picture = make_noise(kSize, kSize, seed);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::uint32_t stripe = (x + y * 5 + static_cast<std::uint32_t>(seed) * 7) / 11 % 3;
            Color color = picture.at(x, y);
            if (stripe < 2) color.alpha = stripe == 0 ? 0 : 255;
            picture.set(x, y, color);
        }
    }
    return picture;
}

}  // namespace

TEST_CASE("A layer of opacity 0 changes nothing in any mode, wherever it lies") {
    Easel easel;
    easel.session.set_base(easel.target, make_noise(kSize, kSize, 401));
    easel.add(easel.pixels(make_noise(kSize, kSize, 402), TXC_BLEND_OVERLAY));
    easel.add(easel.pixels(make_noise(kSize, kSize, 403)));
    const Picture before = easel.paint();
    TxcLayerDef def = easel.pixels(make_noise(kSize, kSize, 404));
    def.opacity = 0.0f;
    const TxcLayer layer = easel.add(def);
    TxcLayerDef fill = fill_def(1, 0, 1);
    fill.opacity = 0.0f;
    const TxcLayer filled = easel.add(fill);
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        def.blend = fill.blend = blend;
        def.blend_space = fill.blend_space = space;
        def.lock_alpha = fill.lock_alpha = blend % 2;
        easel.session.change(layer, def);
        easel.session.change(filled, fill);
        must(txc_layer_move(easel.session.id(), layer, blend % 4));
        must(txc_layer_move(easel.session.id(), filled, (blend + 2) % 4));
        CHECK(easel.paint() == before);
    });
}

TEST_CASE("Transparent texels of a layer leave colour and alpha below them, in any mode") {
    Easel easel;
    const Picture base = make_noise(kSize, kSize, 410);
    easel.session.set_base(easel.target, base);
    Picture clear = make_noise(kSize, kSize, 411);
    for (std::size_t i = 3; i < clear.rgba.size(); i += 4) clear.rgba[i] = 0;
    const TxcLayerDef def = easel.pixels(clear);
    const TxcLayer layer = easel.add(def);
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        TxcLayerDef changed = def;
        changed.blend = blend;
        changed.blend_space = space;
        easel.session.change(layer, changed);
        CHECK(easel.paint() == base);
    });
}

TEST_CASE("A locked alpha stays in any mode, and colour under zero alpha with it") {
    Easel easel;
    Picture base = make_noise(kSize, kSize, 420);
    for (std::uint32_t y = 0; y < kSize / 2; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) base.rgba[(y * kSize + x) * 4 + 3] = 0;
    }
    easel.session.set_base(easel.target, base);
    TxcLayerDef def = easel.pixels(make_noise(kSize, kSize, 421));
    def.lock_alpha = 1;
    const TxcLayer layer = easel.add(def);
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        def.blend = blend;
        def.blend_space = space;
        easel.session.change(layer, def);
        const Picture painted = easel.paint();
        std::uint32_t other_alpha = 0;
        for (std::size_t i = 3; i < base.rgba.size(); i += 4) other_alpha += base.rgba[i] != painted.rgba[i] ? 1 : 0;
        CHECK(other_alpha == 0);
        const std::size_t upper_half = base.rgba.size() / 2;
        CHECK(std::memcmp(base.rgba.data(), painted.rgba.data(), upper_half) == 0);
        // Erasing is all about alpha: locked, it does nothing.
        CHECK((painted == base) == (blend == TXC_BLEND_ERASE));
    });
}

TEST_CASE("Erasing takes alpha alone, and what comes after paints on what is left") {
    Easel easel;
    easel.session.set_base(easel.target, {10, 200, 90, 200});
    TxcLayerDef eraser = fill_def(1, 1, 1, 0.5f);
    eraser.blend = TXC_BLEND_ERASE;
    const TxcLayer layer = easel.add(eraser);
    CHECK(easel.paint() == Picture(kSize, kSize, {10, 200, 90, 100}));
    eraser.color[3] = 1.0f;
    easel.session.change(layer, eraser);
    CHECK(easel.paint() == Picture(kSize, kSize, {10, 200, 90, 0}));
    easel.add(fill_def(1, 0, 0, 0.2f));
    CHECK(easel.paint() == Picture(kSize, kSize, {255, 0, 0, 51}));
}

TEST_CASE("Where there is nothing below, every mode but erase lays the source down as it is") {
    Easel easel;
    easel.session.set_base(easel.target, {77, 88, 99, 0});
    const TxcLayer layer = easel.add(fill_def(1, 0.2f, 0.4f, 0.6f));
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        TxcLayerDef def = fill_def(1, 0.2f, 0.4f, 0.6f);
        def.blend = blend;
        def.blend_space = space;
        easel.session.change(layer, def);
        const Color expected = blend == TXC_BLEND_ERASE ? Color{77, 88, 99, 0} : Color{255, 51, 102, 153};
        CHECK(easel.paint() == Picture(kSize, kSize, expected));
    });
}

TEST_CASE("A solid layer covers without a trace, whatever lies below") {
    Easel easel;
    easel.session.set_base(easel.target, make_noise(kSize, kSize, 430));
    easel.add(easel.pixels(make_noise(kSize, kSize, 431), TXC_BLEND_DIFFERENCE, TXC_BLEND_SPACE_LINEAR));
    easel.add(easel.pixels(make_noise(kSize, kSize, 432)));
    const Picture cover = make_noise(kSize, kSize, 433, true);
    easel.add(easel.pixels(cover));
    CHECK(easel.paint() == cover);
}

TEST_CASE("A transparent texel in a tile changes no other texel of it") {
    // Over an opaque tile, normal layers take a way of their own; one hole sends the tile the general way.
    for (const std::uint32_t layers : {1u, 2u, 5u}) {
        CAPTURE(layers);
        Easel easel;
        const Picture base = make_noise(kSize, kSize, 440, true);
        Picture holed = base;
        for (std::uint32_t y = 3; y < kSize; y += 16) {
            for (std::uint32_t x = 7; x < kSize; x += 16) holed.rgba[(y * kSize + x) * 4 + 3] = 254;
        }
        easel.session.set_base(easel.target, base);
        for (std::uint32_t k = 0; k < layers; ++k) {
            TxcLayerDef def = easel.pixels(make_striped_noise(441 + k));
            def.opacity = k % 2 == 0 ? 1.0f : 0.7f;
            def.lock_alpha = k % 3 == 2 ? 1 : 0;
            easel.add(def);
            if (k == 2) easel.add(fill_def(0.3f, 0.6f, 0.9f, 0.1f));
        }
        const Picture whole = easel.paint();
        CHECK(whole != base);
        easel.session.set_base(easel.target, holed);
        const Picture with_holes = easel.paint();
        std::uint32_t others = 0;
        for (std::uint32_t y = 0; y < kSize; ++y) {
            for (std::uint32_t x = 0; x < kSize; ++x) {
                if (x % 16 == 7 && y % 16 == 3) continue;
                others += with_holes.at(x, y) == whole.at(x, y) ? 0 : 1;
            }
        }
        CHECK(others == 0);
    }
}

TEST_CASE("A layer changes no texel that it does not paint, in any mode") {
    Easel easel;
    easel.session.set_base(easel.target, make_noise(kSize, kSize, 450));
    for (std::uint32_t k = 0; k < 3; ++k) {
        TxcLayerDef def = easel.pixels(make_noise(kSize, kSize, 451 + k), k == 1 ? TXC_BLEND_SCREEN : TXC_BLEND_NORMAL);
        def.opacity = 0.4f;
        easel.add(def);
    }
    const Picture before = easel.paint();
    const Picture striped = make_striped_noise(454);
    const TxcLayerDef def = easel.pixels(striped);
    const TxcLayer layer = easel.add(def);
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        TxcLayerDef changed = def;
        changed.blend = blend;
        changed.blend_space = space;
        easel.session.change(layer, changed);
        const Picture after = easel.paint();
        std::uint32_t strays = 0;
        for (std::uint32_t y = 0; y < kSize; ++y) {
            for (std::uint32_t x = 0; x < kSize; ++x) {
                if (striped.at(x, y).alpha == 0) strays += after.at(x, y) == before.at(x, y) ? 0 : 1;
            }
        }
        CHECK(strays == 0);
    });
}

TEST_CASE("Blend mode and space do not project again") {
    Easel easel;
    TxcLayerDef def = easel.pixels(make_noise(kSize, kSize, 460));
    const TxcLayer layer = easel.add(def);
    easel.paint();
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        def.blend = blend;
        def.blend_space = space;
        easel.session.change(layer, def);
        CHECK(easel.session.update(easel.target).projected_layers == 0);
    });
}

TEST_CASE("White painted onto white by halves stays white for the modes that jump there") {
    Easel easel;
    easel.session.set_base(easel.target, kWhite);
    for (int k = 0; k < 40; ++k) {
        TxcLayerDef def = fill_def(1, 1, 1);
        def.opacity = static_cast<float>(1 + k) / 41.0f;
        easel.add(def);
    }
    TxcLayerDef burn = fill_def(0, 0, 0);
    burn.blend = TXC_BLEND_COLOR_BURN;
    const TxcLayer layer = easel.add(burn);
    CHECK(easel.paint() == Picture(kSize, kSize, kWhite));
    burn.blend_space = TXC_BLEND_SPACE_LINEAR;
    easel.session.change(layer, burn);
    CHECK(easel.paint() == Picture(kSize, kSize, kWhite));
}

TEST_CASE("Tiles that the target's edge cuts are painted like whole ones") {
    // 37 x 29 texels have cut tiles on both sides; each texel of a fill hangs on its own base alone.
    const Picture base = make_noise(37, 29, 470, true);
    Picture room = Picture(kSize, kSize, kWhite);
    for (std::uint32_t y = 0; y < 29; ++y) {
        for (std::uint32_t x = 0; x < 37; ++x) room.set(x, y, base.at(x, y));
    }
    TestSession session(make_plane());
    const TxcTarget cut = session.target(37, 29);
    const TxcTarget whole = session.target(kSize, kSize);
    session.set_base(cut, base);
    session.set_base(whole, room);
    TxcLayerDef def = fill_def(0.9f, 0.3f, 0.5f, 0.7f);
    const TxcLayer layers[2] = {session.layer(cut, def), session.layer(whole, def)};
    for_each_mode([&](std::uint32_t blend, std::uint32_t space) {
        def.blend = blend;
        def.blend_space = space;
        for (const TxcLayer layer : layers) session.change(layer, def);
        const Picture small = session.paint(cut);
        const Picture large = session.paint(whole);
        std::uint32_t differences = 0;
        for (std::uint32_t y = 0; y < 29; ++y) {
            for (std::uint32_t x = 0; x < 37; ++x) differences += small.at(x, y) == large.at(x, y) ? 0 : 1;
        }
        CHECK(differences == 0);
    });
}

TEST_CASE("The one transparent texel of a white tile is painted as such, wherever in the tile it lies") {
    Easel easel;
    easel.add(fill_def(1, 1, 1, 0.4f));
    std::uint32_t wrong = 0;
    for (std::uint32_t step = 0; step < 256; ++step) {
        // In each tile at another place.
        Picture base(kSize, kSize, kWhite);
        Picture expected = base;
        for (std::uint32_t tile = 0; tile < 16; ++tile) {
            const std::uint32_t place = (step + tile * 37) % 256;
            const std::uint32_t x = tile % 4 * 16 + place % 16;
            const std::uint32_t y = tile / 4 * 16 + place / 16;
            base.set(x, y, {255, 255, 255, 0});
            expected.set(x, y, {255, 255, 255, 102});
        }
        easel.session.set_base(easel.target, base);
        wrong += count_differences(easel.paint(), expected);
    }
    CHECK(wrong == 0);
}
