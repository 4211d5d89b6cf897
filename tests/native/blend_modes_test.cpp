// Every blend mode, through the C ABI, against the standard's formulas in double precision (spec section 6).
#include <doctest/doctest.h>

#include <cmath>
#include <iterator>

#include "support/reference_blend.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 256;

/// A square whose texels are the base's and the decal's pixels, one to one.
class PixelEasel {
public:
    PixelEasel() : session_(make_plane()), target_(session_.target(kSize, kSize)) {}

    Picture paint(const Picture& base, const Picture& source, TxcLayerDef def) {
        session_.set_base(target_, base);
        def.image = session_.image(source);
        const TxcLayer layer = session_.layer(target_, def);
        Picture picture = session_.paint(target_);
        must(txc_layer_destroy(session_.id(), layer));
        must(txc_image_destroy(session_.id(), def.image));
        return picture;
    }

private:
    TestSession session_;
    TxcTarget target_;
};

TxcLayerDef pixel_def(std::uint32_t blend, std::uint32_t blend_space) {
    TxcLayerDef def = decal_def(0);
    def.filter = TXC_FILTER_NEAREST;
    resize(def, 1, 1, 1);
    def.blend = blend;
    def.blend_space = blend_space;
    return def;
}

/// The largest distance of a painted channel from the standard's value, in steps of 1/255.
double worst_distance(const Picture& base, const Picture& source, const TxcLayerDef& def, const Picture& painted) {
    double worst = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const Pixel expected = composite(def, to_pixel(base.at(x, y)), to_pixel(source.at(x, y)));
            const Color actual = painted.at(x, y);
            const int channels[4] = {actual.red, actual.green, actual.blue, actual.alpha};
            for (int c = 0; c < 4; ++c) {
                const double exact = c < 3 ? expected.color[c] : expected.alpha;
                worst = std::max(worst, std::fabs(exact * 255.0 - channels[c]));
            }
        }
    }
    return worst;
}

struct Strength {
    std::uint8_t backdrop_alpha;
    std::uint8_t source_alpha;
    float opacity;
    std::uint32_t lock_alpha;
};

constexpr Strength kStrengths[] = {{255, 255, 1, 0},   {255, 128, 1, 0}, {200, 77, 1, 0},    {255, 255, 0.3f, 1},
                                   {1, 254, 0.75f, 0}, {0, 140, 1, 0},   {90, 180, 0.6f, 1}, {128, 255, 0.5f, 0}};

/// Rows of one backdrop value, columns of one source value: red holds every pair of bytes, green and blue hold every
/// pair once more, turned about, so that no two channels of a texel are alike.
Picture all_backdrops(std::uint8_t alpha) {
    Picture picture(kSize, kSize);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const auto value = static_cast<std::uint8_t>(y);
            picture.set(x, y, {value, static_cast<std::uint8_t>(255 - value), static_cast<std::uint8_t>(x), alpha});
        }
    }
    return picture;
}
Picture all_sources(std::uint8_t alpha) {
    Picture picture(kSize, kSize);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const auto value = static_cast<std::uint8_t>(x);
            picture.set(x, y, {value, value, static_cast<std::uint8_t>(255 - y), alpha});
        }
    }
    return picture;
}

void set_alpha(Picture& picture, std::uint8_t alpha) {
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = alpha;
}

/// Colours by lot, a third of them greys, blacks, whites, or all but grey: where the formulas have their edges.
Picture colors_by_lot(std::uint64_t seed) {
    Picture picture = make_noise(kSize, kSize, seed, true);
    Random random(seed + 1);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::uint8_t grey = random.coin() ? picture.at(x, y).red : random.coin() ? 0 : 255;
            const std::uint32_t lot = random.below(12);
            if (lot < 3) picture.set(x, y, {grey, grey, grey, 255});
            if (lot == 3) picture.set(x, y, {grey, static_cast<std::uint8_t>(grey ^ 1), grey, 255});
        }
    }
    return picture;
}

/// Rounded once, at the end: never further off than half a step and a float's rounding.
constexpr double kHalfStep = 0.502;

/// `every`: 3 takes every third strength, for the reference takes its time, above all over powers in linear light.
void check_separable(std::uint32_t blend_space, std::size_t every) {
    PixelEasel easel;
    for (std::size_t s = 0; s < std::size(kStrengths); s += every) {
        const Strength& strength = kStrengths[s];
        const Picture base = all_backdrops(strength.backdrop_alpha);
        const Picture source = all_sources(strength.source_alpha);
        for (std::uint32_t blend = TXC_BLEND_NORMAL; blend <= TXC_BLEND_EXCLUSION; ++blend) {
            TxcLayerDef def = pixel_def(blend, blend_space);
            def.opacity = strength.opacity;
            def.lock_alpha = strength.lock_alpha;
            CAPTURE(blend);
            CAPTURE(strength.backdrop_alpha);
            CAPTURE(strength.source_alpha);
            CHECK(worst_distance(base, source, def, easel.paint(base, source, def)) < kHalfStep);
        }
    }
}

void check_non_separable(std::uint32_t blend_space, std::size_t every) {
    PixelEasel easel;
    for (std::size_t s = 0; s < std::size(kStrengths); s += every) {
        const Strength& strength = kStrengths[s];
        Picture base = colors_by_lot(strength.source_alpha);
        Picture source = colors_by_lot(strength.source_alpha + 1000u);
        set_alpha(base, strength.backdrop_alpha);
        set_alpha(source, strength.source_alpha);
        for (std::uint32_t blend = TXC_BLEND_HUE; blend <= TXC_BLEND_LUMINOSITY; ++blend) {
            TxcLayerDef def = pixel_def(blend, blend_space);
            def.opacity = strength.opacity;
            def.lock_alpha = strength.lock_alpha;
            CAPTURE(blend);
            CAPTURE(strength.backdrop_alpha);
            CAPTURE(strength.source_alpha);
            CHECK(worst_distance(base, source, def, easel.paint(base, source, def)) < kHalfStep);
        }
    }
}

}  // namespace

TEST_CASE("Separable modes mix every pair of bytes as the standard says") { check_separable(TXC_BLEND_SPACE_SRGB, 2); }

TEST_CASE("Separable modes mix every pair of bytes as the standard says, in linear light") {
    check_separable(TXC_BLEND_SPACE_LINEAR, 3);
}

TEST_CASE("Hue, saturation, colour and luminosity agree with the standard") {
    check_non_separable(TXC_BLEND_SPACE_SRGB, 2);
}

TEST_CASE("Hue, saturation, colour and luminosity agree with the standard in linear light") {
    check_non_separable(TXC_BLEND_SPACE_LINEAR, 3);
}

TEST_CASE("Modes agree with the standard at every alpha of backdrop and source") {
    PixelEasel easel;
    Picture base = make_noise(kSize, kSize, 301, true);
    Picture source = make_noise(kSize, kSize, 302, true);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            base.rgba[(y * kSize + x) * 4 + 3] = static_cast<std::uint8_t>(y);
            source.rgba[(y * kSize + x) * 4 + 3] = static_cast<std::uint8_t>(x);
        }
    }
    for (std::uint32_t blend = 0; blend < TXC_BLEND_COUNT; ++blend) {
        for (std::uint32_t space = 0; space < TXC_BLEND_SPACE_COUNT; ++space) {
            CAPTURE(blend);
            CAPTURE(space);
            const TxcLayerDef def = pixel_def(blend, space);
            CHECK(worst_distance(base, source, def, easel.paint(base, source, def)) < kHalfStep);
        }
    }
}

TEST_CASE("A stack of layers is rounded once, at the end") {
    // Not dodge, burn, hue and saturation: they jump somewhere, so that no bound holds for what lies just beside.
    const std::uint32_t modes[] = {TXC_BLEND_NORMAL,     TXC_BLEND_MULTIPLY,  TXC_BLEND_SCREEN,     TXC_BLEND_OVERLAY,
                                   TXC_BLEND_SOFT_LIGHT, TXC_BLEND_LIGHTEN,   TXC_BLEND_DIFFERENCE, TXC_BLEND_ERASE,
                                   TXC_BLEND_HARD_LIGHT, TXC_BLEND_EXCLUSION, TXC_BLEND_LUMINOSITY, TXC_BLEND_DARKEN};
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const Picture base = make_noise(kSize, kSize, 310);
    session.set_base(target, base);
    std::vector<TxcLayerDef> defs;
    std::vector<Picture> sources;
    for (std::uint32_t k = 0; k < 12; ++k) {
        TxcLayerDef def = pixel_def(modes[k], k % 3 == 1 ? TXC_BLEND_SPACE_LINEAR : TXC_BLEND_SPACE_SRGB);
        def.opacity = static_cast<float>(3 + k % 5) / 8;
        def.lock_alpha = k % 4 == 3 ? 1 : 0;
        sources.push_back(make_noise(kSize, kSize, 320 + k));
        defs.push_back(def);
        def.image = session.image(sources.back());
        session.layer(target, def);
    }
    const Picture painted = session.paint(target);
    double worst = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            Pixel pixel = to_pixel(base.at(x, y));
            for (std::size_t k = 0; k < defs.size(); ++k)
                pixel = composite(defs[k], pixel, to_pixel(sources[k].at(x, y)));
            const Color actual = painted.at(x, y);
            const int channels[4] = {actual.red, actual.green, actual.blue, actual.alpha};
            for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::fabs((c < 3 ? pixel.color[c] : pixel.alpha) * 255.0 - channels[c]));
        }
    }
    CHECK(worst < kHalfStep);
}
