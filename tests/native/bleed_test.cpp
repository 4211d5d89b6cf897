// Colour bled outward from charts in what is exported (spec section 6).
#include "bleed.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"
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

/// The texture as it is exported, found ring by ring on whole copies of it.
Picture bled_by_rings(const Picture& live, const Picture& base, const std::vector<std::uint8_t>& coverage) {
    Picture out = live;
    const std::uint32_t width = live.width;
    std::vector<bool> filled(coverage.size());
    std::vector<bool> touched(coverage.size());
    for (std::uint32_t i = 0; i < coverage.size(); ++i) {
        filled[i] = coverage[i] != 0;
        touched[i] = filled[i] && !(live.at(i % width, i / width) == base.at(i % width, i / width));
    }
    for (std::uint32_t ring = 0; ring < 16; ++ring) {
        const std::vector<bool> filled_before = filled;
        const std::vector<bool> touched_before = touched;
        const Picture before = out;
        for (std::uint32_t i = 0; i < coverage.size(); ++i) {
            if (filled_before[i]) continue;
            std::uint32_t count = 0;
            std::uint32_t sum[4] = {};
            std::uint32_t weighted[3] = {};
            bool is_reached = false;
            for (std::uint32_t n = 0; n < coverage.size(); ++n) {
                const auto apart = [](std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; };
                if (apart(n % width, i % width) > 1 || apart(n / width, i / width) > 1 || !filled_before[n]) continue;
                const std::uint8_t* texel = before.rgba.data() + std::size_t{n} * 4;
                for (int c = 0; c < 4; ++c) sum[c] += texel[c];
                for (int c = 0; c < 3; ++c) weighted[c] += std::uint32_t{texel[c]} * texel[3];
                is_reached = is_reached || touched_before[n];
                ++count;
            }
            if (count > 0) filled[i] = true;
            if (!is_reached) continue;
            touched[i] = true;
            const auto rounded = [](double value) { return static_cast<std::uint8_t>(value + 0.5); };
            std::uint8_t* to = out.rgba.data() + std::size_t{i} * 4;
            for (int c = 0; c < 3; ++c)
                to[c] = rounded(sum[3] > 0 ? static_cast<double>(weighted[c]) / sum[3]
                                           : static_cast<double>(sum[c]) / count);
            to[3] = rounded(static_cast<double>(sum[3]) / count);
        }
    }
    return out;
}

}  // namespace

TEST_CASE("Each ring is the mean of the texels before it, whatever the texture's width and wherever charts end") {
    Random random(71);
    for (const std::uint32_t width : {1u, 17u, 64u, 65u, 127u}) {
        for (const std::uint32_t edge : {0u, 1u, 62u, 63u, 64u, 65u}) {
            constexpr std::uint32_t kHeight = 12;
            if (edge >= width) continue;
            CAPTURE(width);
            CAPTURE(edge);
            // One chart of a column and another of a texel, near each other; alpha of all kinds under both.
            const auto u = [&](std::uint32_t x) { return static_cast<double>(x) / width; };
            Shape shape = make_plane(1.0, 0.0, {u(edge), 3.0 / kHeight, u(edge + 1), 9.0 / kHeight});
            shape.append(make_plane(1.0, 0.1, {u(width - 1), 11.0 / kHeight, u(width), 1.0}));
            TestSession session(shape);
            const TxcTarget target = session.target(width, kHeight, 0);
            Picture base = make_noise(width, kHeight, 72 + edge);
            for (std::uint32_t i = 0; i < width * kHeight; ++i) {
                if (random.coin()) base.rgba[std::size_t{i} * 4 + 3] = 0;
            }
            session.set_base(target, base, TXC_FILTER_NEAREST);
            // Every other time it is an eraser, which changes alpha alone.
            const bool erases = edge % 2 == 1;
            TxcLayerDef stamp = decal_def(session.image(erases ? Picture(4, 4, {0, 0, 0, 255}) : make_noise(4, 4, 73)));
            stamp.blend = erases ? TXC_BLEND_ERASE : TXC_BLEND_NORMAL;
            stamp.projector = TXC_PROJECTOR_UV;
            stamp.uv_center[1] = 0.25f;
            stamp.uv_size[1] = 0.5f;
            session.layer(target, stamp);
            session.update(target);
            std::vector<std::uint8_t> coverage(std::size_t{width} * kHeight);
            must(txc_map_read_coverage(session.id(), target, 0, kHeight, coverage.data()));
            Picture bled(width, kHeight);
            must(txc_target_read_bled(session.id(), target, 0, kHeight, bled.rgba.data()));
            CHECK_UNARY(bled == bled_by_rings(session.read(target), base, coverage));
        }
    }
}

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

TEST_CASE("In a window colour bleeds as far as in the whole texture") {
    constexpr std::uint32_t kWhole = 4096;
    TestSession session(make_plane(1.0, 0.0, {0.0, 0.0, 100.0 / kWhole, 1.0}));
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.width = 256;
    def.height = 64;
    def.gutter = 2;
    def.texture_width = def.texture_height = kWhole;
    TxcTarget target = 0;
    must(txc_target_create(session.id(), &def, &target));
    session.bake(target);
    TxcLayerDef decal = decal_def(session.image(Picture(4, 4, {255, 0, 0, 255})));
    resize(decal, 4.0, 4.0, 1.0);
    session.layer(target, decal);
    session.update(target);
    Picture bled(256, 64);
    must(txc_target_read_bled(session.id(), target, 0, 64, bled.rgba.data()));
    CHECK(bled.at(101 + 64, 30) == Color{255, 0, 0, 255});
    CHECK(bled.at(102 + 64, 30) == Color{255, 255, 255, 255});
}
