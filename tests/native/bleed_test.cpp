// Colour bled outward from charts in what is exported (spec section 6).
#include "bleed.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSide = 128;

Picture read_bled(const TestSession& session, TxcTarget target, std::uint32_t rows_at_once = kSide) {
    Picture picture(kSide, kSide);
    for (std::uint32_t row = 0; row < kSide; row += rows_at_once)
        must(txc_target_read_bled(session.id(), target, row, std::min(rows_at_once, kSide - row),
                                  picture.rgba.data() + row * kSide * 4));
    return picture;
}

/// A chart of texels 40 to 87 either way, painted red all over by a decal.
struct Painted {
    TestSession session{make_plane(1.0, 0.0, {40.0 / kSide, 40.0 / kSide, 88.0 / kSide, 88.0 / kSide})};
    TxcTarget target = session.target(kSide, kSide);
    TxcLayer layer = 0;

    explicit Painted(const Picture* base = nullptr) {
        if (base != nullptr) session.set_base(target, *base, TXC_FILTER_NEAREST);
        TxcLayerDef def = decal_def(session.image(Picture(4, 4, {255, 0, 0, 255})));
        resize(def, 4.0, 4.0, 1.0);
        layer = session.layer(target, def);
        session.update(target);
    }
};

/// Texels beyond the chart, by the larger of the distances along both axes; 0 on it.
std::int32_t beyond(std::uint32_t x, std::uint32_t y) {
    const auto outside = [](std::uint32_t at) {
        const auto place = static_cast<std::int32_t>(at);
        return place < 40 ? 40 - place : place > 87 ? place - 87 : 0;
    };
    return std::max(outside(x), outside(y));
}

}  // namespace

TEST_CASE("Exported colour reaches 16 texels beyond the gutter, and no texel further") {
    const Painted painted;
    const Picture live = painted.session.read(painted.target);
    const Picture exported = read_bled(painted.session, painted.target);
    const Color red{255, 0, 0, 255};
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            // The gutter of 2 is round at the corners, where the bleeding begins a texel nearer.
            if (beyond(x, y) <= 17) CHECK_UNARY(exported.at(x, y) == red);
            if (beyond(x, y) > 18) CHECK_UNARY(exported.at(x, y) == live.at(x, y));
        }
    }
    CHECK(live.at(64, 35) == Color{255, 255, 255, 255});
}

TEST_CASE("Bleeding leaves the live texture as it was, and is found anew after an update") {
    Painted painted;
    const std::uint64_t before = painted.session.hash(painted.target);
    const Picture first = read_bled(painted.session, painted.target);
    CHECK(painted.session.hash(painted.target) == before);
    CHECK_UNARY(first == read_bled(painted.session, painted.target, 7));
    TxcLayerDef def = painted.session.layer_def(painted.layer);
    def.opacity = 0.5f;
    painted.session.change(painted.layer, def);
    painted.session.update(painted.target);
    const Color faded = painted.session.read(painted.target).at(64, 64);
    CHECK_FALSE(faded == Color{255, 0, 0, 255});
    CHECK_UNARY(read_bled(painted.session, painted.target).at(64, 30) == faded);
    CHECK_UNARY(first.at(64, 30) == Color{255, 0, 0, 255});
}

TEST_CASE("Beside a chart that no layer changed the base picture stays") {
    const Picture base = make_noise(kSide, kSide, 70);
    Painted painted(&base);
    const std::uint32_t held = painted.session.stats().memory_used_kib;
    CHECK_FALSE(read_bled(painted.session, painted.target) == base);
    CHECK(painted.session.stats().memory_used_kib >= held);
    must(txc_layer_destroy(painted.session.id(), painted.layer));
    painted.session.update(painted.target);
    CHECK_UNARY(read_bled(painted.session, painted.target) == base);
}

TEST_CASE("Colour under transparent texels does not bleed into colour that shows") {
    // Half of the chart is transparent green, half opaque red; beyond their border only red may show.
    Picture base(kSide, kSide, {0, 255, 0, 0});
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) base.set(x, y, {200, 0, 0, 255});
    }
    TestSession session(make_plane(1.0, 0.0, {40.0 / kSide, 40.0 / kSide, 88.0 / kSide, 88.0 / kSide}));
    const TxcTarget target = session.target(kSide, kSide);
    session.set_base(target, base, TXC_FILTER_NEAREST);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, {255, 0, 0, 255})));
    def.lock_alpha = 1;
    resize(def, 4.0, 4.0, 1.0);
    session.layer(target, def);
    session.update(target);
    const Picture exported = read_bled(session, target);
    std::uint32_t mixed = 0;
    for (std::uint32_t x = 50; x < 80; ++x) {
        const Color color = exported.at(x, 30);
        if (color.alpha == 0) continue;
        CHECK_UNARY(color.green == 0);
        mixed += color.alpha < 255 ? 1 : 0;
    }
    CHECK(mixed > 0);
}

TEST_CASE("Colour bleeds 16 texels at 1024, in proportion above, never less") {
    CHECK(txc::bleed_reach(16, 16) == 16);
    CHECK(txc::bleed_reach(1024, 512) == 16);
    CHECK(txc::bleed_reach(512, 2048) == 32);
    CHECK(txc::bleed_reach(8192, 8192) == 128);
}
