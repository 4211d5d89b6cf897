// Fills by gradient and by triangles (texelcast.h, "Fills"), through the C ABI.
#include <doctest/doctest.h>

#include <cmath>

#include "support/reference_blend.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 32;

/// Along X over the plane from -1/2 to 1/2.
TxcGradient across() {
    TxcGradient gradient;
    txc_gradient_default(&gradient);
    gradient.from_model[0] = -0.5f;
    gradient.to_model[0] = 0.5f;
    gradient.to_model[1] = 0.0f;
    return gradient;
}

void set_stop(TxcGradient& gradient, std::uint32_t stop, float offset, float r, float g, float b, float a) {
    gradient.stop_count = std::max(gradient.stop_count, stop + 1);
    gradient.offsets[stop] = offset;
    const float rgba[4] = {r, g, b, a};
    for (int c = 0; c < 4; ++c) gradient.colors[stop * 4 + static_cast<std::uint32_t>(c)] = rgba[c];
}

void set_gradient(const TestSession& session, TxcLayer layer, const TxcGradient& gradient) {
    must(txc_fill_set_gradient(session.id(), layer, &gradient));
}

/// What stands at an offset between two stops, premultiplied in the space.
Pixel mixed(const Pixel& a, const Pixel& b, double share, bool linear) {
    Pixel out{};
    out.alpha = a.alpha + (b.alpha - a.alpha) * share;
    for (int c = 0; c < 3 && out.alpha > 0; ++c) {
        const double low = (linear ? decode_srgb(a.color[c]) : a.color[c]) * a.alpha;
        const double high = (linear ? decode_srgb(b.color[c]) : b.color[c]) * b.alpha;
        const double straight = (low + (high - low) * share) / out.alpha;
        out.color[c] = linear ? encode_srgb(straight) : straight;
    }
    return out;
}

}  // namespace

TEST_CASE("A gradient's colours are mixed premultiplied, in sRGB or in linear light, within one step of the formula") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    session.set_base(target, Color{40, 80, 120, 255});
    for (const std::uint32_t space : {TXC_BLEND_SPACE_SRGB, TXC_BLEND_SPACE_LINEAR}) {
        TxcLayerDef def = fill_def(0, 0, 0);
        def.blend_space = space;
        const TxcLayer fill = session.layer(target, def);
        TxcGradient gradient = across();
        set_stop(gradient, 0, 0, 1, 0, 0, 1);
        set_stop(gradient, 1, 1, 0, 0.5f, 1, 0.25f);
        set_gradient(session, fill, gradient);
        const Picture painted = session.paint(target);
        const MapArrays map = session.map(target);
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const double share = static_cast<double>(map.position(x, 9)[0]) + 0.5;
            const Pixel source = mixed({{1, 0, 0}, 1}, {{0, 0.5, 1}, 0.25}, std::min(std::max(share, 0.0), 1.0),
                                       space == TXC_BLEND_SPACE_LINEAR);
            const Pixel expected = composite(def, to_pixel({40, 80, 120, 255}), source);
            const Color actual = painted.at(x, 9);
            INFO("column ", x);
            CHECK(std::fabs(expected.color[0] * 255 - actual.red) < 1);
            CHECK(std::fabs(expected.color[1] * 255 - actual.green) < 1);
            CHECK(std::fabs(expected.color[2] * 255 - actual.blue) < 1);
        }
        must(txc_layer_destroy(session.id(), fill));
    }
}

TEST_CASE("A gradient keeps its ends beyond them, and jumps where two stops share a place") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcLayer fill = session.layer(target, fill_def(0, 0, 0));
    TxcGradient gradient = across();
    set_stop(gradient, 0, 0.25f, 1, 0, 0, 1);
    set_stop(gradient, 1, 0.5f, 1, 0, 0, 1);
    set_stop(gradient, 2, 0.5f, 0, 0, 1, 1);
    set_stop(gradient, 3, 0.75f, 0, 0, 1, 1);
    set_gradient(session, fill, gradient);
    const Picture painted = session.paint(target);
    for (std::uint32_t x = 0; x < kSize; ++x)
        CHECK(painted.at(x, 5) == (x < kSize / 2 ? Color{255, 0, 0, 255} : Color{0, 0, 255, 255}));
}

TEST_CASE("A radial gradient depends on the distance alone") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcLayer fill = session.layer(target, fill_def(0, 0, 0));
    TxcGradient gradient;
    txc_gradient_default(&gradient);
    gradient.kind = TXC_GRADIENT_RADIAL;
    gradient.radius = 0.5f;
    set_gradient(session, fill, gradient);
    const Picture painted = session.paint(target);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const double dx = (x + 0.5) / kSize - 0.5;
            const double dy = (y + 0.5) / kSize - 0.5;
            const double expected = std::min(std::sqrt(dx * dx + dy * dy) / 0.5, 1.0) * 255;
            CHECK(std::fabs(painted.at(x, y).red - expected) < 1);
        }
    }
}

TEST_CASE("A fill kept to triangles paints those and their gutters, and nothing else") {
    TestSession session(make_cube());
    const TxcTarget target = session.target(256, 256);
    const MapArrays map = session.map(target);
    session.set_base(target, Color{0, 0, 0, 255});
    const TxcLayer fill = session.layer(target, fill_def(1, 1, 1));
    std::vector<std::uint32_t> all(session.material_info().triangle_count);
    std::vector<Picture> each;
    for (std::uint32_t t = 0; t < all.size(); ++t) {
        all[t] = t;
        must(txc_fill_set_triangles(session.id(), fill, &t, 1));
        each.push_back(session.paint(target));
    }
    must(txc_fill_set_triangles(session.id(), fill, all.data(), static_cast<std::uint32_t>(all.size())));
    const Picture whole = session.paint(target);
    for (std::uint32_t y = 0; y < 256; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            int painted = 0;
            for (const Picture& one : each) painted += one.at(x, y).red == 255 ? 1 : 0;
            CHECK(painted == (map.coverage_at(x, y) == 0 ? 0 : 1));
            CHECK((whole.at(x, y).red == 255) == (map.coverage_at(x, y) != 0));
        }
    }
    must(txc_fill_set_triangles(session.id(), fill, all.data(), 0));
    CHECK(session.paint(target) == Picture(256, 256, {0, 0, 0, 255}));
    must(txc_fill_set_triangles(session.id(), fill, nullptr, 0));
    CHECK(session.paint(target) == Picture(256, 256, {255, 255, 255, 255}));
}

TEST_CASE("Bad gradients and triangles are refused by name, and nothing changes") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcLayer fill = session.layer(target, fill_def(0, 1, 0));
    const TxcLayer decal = session.layer(target, decal_def(0));
    const Picture before = session.paint(target);
    const auto refused = [&](auto&& spoil, const char* words) {
        TxcGradient gradient = across();
        spoil(gradient);
        CHECK(txc_fill_set_gradient(session.id(), fill, &gradient) == TXC_STATUS_BAD_ARGUMENT);
        INFO(txc_error_detail());
        CHECK(std::string(txc_error_detail()).find(words) != std::string::npos);
    };
    refused([](TxcGradient& g) { g.kind = 2; }, "kind is 2");
    refused([](TxcGradient& g) { g.to_model[0] = -0.5f; }, "to_model is where from_model is");
    refused([](TxcGradient& g) { g.from_model[1] = NAN; }, "from_model has a coordinate");
    refused([](TxcGradient& g) { g.kind = TXC_GRADIENT_RADIAL, g.radius = 0; }, "radius is 0");
    refused([](TxcGradient& g) { g.stop_count = 1; }, "stop_count is 1");
    refused([](TxcGradient& g) { g.stop_count = 17; }, "stop_count is 17");
    refused([](TxcGradient& g) { g.offsets[0] = 1, g.offsets[1] = 0; }, "offsets[1] is 0");
    refused([](TxcGradient& g) { g.offsets[1] = 1.5f; }, "offsets[1] is 1.5");
    refused([](TxcGradient& g) { g.colors[6] = -1; }, "colors[6] is -1");
    const std::uint32_t triangles[] = {0, 2};
    CHECK(txc_fill_set_triangles(session.id(), fill, triangles, 2) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(std::string(txc_error_detail()).find("triangles[1] is 2; the material has 2") != std::string::npos);
    const TxcGradient good = across();
    CHECK(txc_fill_set_gradient(session.id(), decal, &good) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_fill_set_triangles(session.id(), decal, triangles, 1) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_fill_set_gradient(session.id(), 9999, &good) == TXC_STATUS_STALE_HANDLE);
    CHECK(session.paint(target) == before);
}

TEST_CASE("AFillThatBecomesADecalForgetsItsShape") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const TxcLayer fill = session.layer(target, fill_def(0, 1, 0));
    set_gradient(session, fill, across());
    session.update(target);
    session.change(fill, decal_def(0));
    session.change(fill, fill_def(0, 1, 0));
    CHECK(session.paint(target).at(3, 3) == Color{0, 255, 0, 255});
}
