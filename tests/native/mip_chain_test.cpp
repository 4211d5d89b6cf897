// The coarser levels of a target, made by the core so that they are the same everywhere.
#include "mip_chain.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/test_session.h"

using namespace support;

namespace {

double to_linear(int byte) {
    const double e = byte / 255.0;
    return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
}
double to_srgb(double linear) {
    return 255.0 * (linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

/// A target that shows a picture as it is, with its whole chain.
struct Shown {
    TestSession session{make_plane()};
    TxcTarget target;
    explicit Shown(const Picture& picture) : target(session.target(picture.width, picture.height, 0, 0)) {
        session.set_base(target, picture);
        session.update(target);
    }
    Picture level(std::uint32_t level) const { return session.read(target, level); }
};

}  // namespace

TEST_CASE("A chain goes down to a single texel") {
    CHECK(txc::MipChain::full_count(1, 1) == 1);
    CHECK(txc::MipChain::full_count(2, 1) == 2);
    CHECK(txc::MipChain::full_count(3, 3) == 2);
    CHECK(txc::MipChain::full_count(1024, 1024) == 11);
    CHECK(txc::MipChain::full_count(8192, 1) == 14);
    CHECK(txc::MipChain::byte_count(4, 2, 3) == (8 + 2 + 1) * 4);
}

TEST_CASE("A flat colour stays what it is on every level, whichever it is") {
    for (int shade = 0; shade < 256; ++shade) {
        const auto byte = static_cast<std::uint8_t>(shade);
        const Color color{byte, static_cast<std::uint8_t>(255 - shade), static_cast<std::uint8_t>(shade * 7), 255};
        const Shown shown(Picture(8, 8, color));
        for (std::uint32_t level = 1; level < 4; ++level)
            CHECK_UNARY(shown.level(level) == Picture(8u >> level, 8u >> level, color));
    }
}

TEST_CASE("A level's texel is the mean of four in linear light") {
    const Picture picture = make_noise(32, 16, 110, true);
    const Shown shown(picture);
    const Picture half = shown.level(1);
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            double red = 0;
            for (const std::uint32_t dy : {0u, 1u}) {
                for (const std::uint32_t dx : {0u, 1u}) red += to_linear(picture.at(2 * x + dx, 2 * y + dy).red) / 4;
            }
            CHECK_UNARY(std::fabs(half.at(x, y).red - to_srgb(red)) <= 1.0);
            CHECK_UNARY(half.at(x, y).alpha == 255);
        }
    }
}

TEST_CASE("Black and white make the grey of equal light, not of equal bytes") {
    const Shown shown(make_checker(4, 4, 1, {0, 0, 0, 255}, {255, 255, 255, 255}));
    CHECK(shown.level(1) == Picture(2, 2, {188, 188, 188, 255}));
}

TEST_CASE("Transparent texels lend a coarser level no colour") {
    Picture picture(2, 2, {255, 0, 0, 0});
    picture.set(0, 0, {0, 0, 255, 255});
    const Shown shown(picture);
    CHECK(shown.level(1).at(0, 0) == Color{0, 0, 255, 64});
    // Where all of it is transparent the colour beneath is kept.
    CHECK(Shown(Picture(2, 2, {10, 20, 30, 0})).level(1).at(0, 0) == Color{10, 20, 30, 0});
}

TEST_CASE("Odd sizes have levels of the halved size, and narrow ones end as a column or row") {
    const Shown shown(make_noise(5, 3, 111, true));
    CHECK(shown.session.map_info(shown.target).mip_levels == 3);
    CHECK(shown.level(1).width == 2);
    CHECK(shown.level(1).height == 1);
    CHECK(shown.level(2).width == 1);
    const Shown column(Picture(1, 16, {40, 50, 60, 255}));
    for (std::uint32_t level = 0; level < 5; ++level)
        CHECK(column.level(level) == Picture(1, 16u >> level, {40, 50, 60, 255}));
}

TEST_CASE("Texels of no chart lend no colour to a coarser texel that holds some of one") {
    txc::MipChain mips;
    mips.allocate(4, 2, 3);
    const Color red{200, 0, 0, 255};
    const Color clear{0, 90, 0, 0};
    const Color white{255, 255, 255, 255};
    // Charts: the two columns at the left but for their last texel, and of those one is transparent.
    const Color texels[8] = {red, red, white, white, clear, white, white, white};
    for (std::size_t t = 0; t < 8; ++t) {
        const std::uint8_t bytes[4] = {texels[t].red, texels[t].green, texels[t].blue, texels[t].alpha};
        std::copy_n(bytes, 4, mips.levels[0].rgba.begin() + static_cast<std::ptrdiff_t>(t * 4));
    }
    txc::CoverageBits charts(4, 2);
    charts.claim_span(0, 0, 2);
    charts.claim(0, 1);
    mips.note_charts(charts);
    mips.reduce(1, 0, 0, 2, 1);
    mips.reduce(2, 0, 0, 1, 1);
    const auto at = [&](std::uint32_t level, std::size_t x) {
        const std::uint8_t* texel = mips.levels[level].rgba.data() + x * 4;
        return Color{texel[0], texel[1], texel[2], texel[3]};
    };
    CHECK(at(1, 0) == Color{200, 0, 0, 170});  // two of three opaque, the white one left out
    CHECK(at(1, 1) == white);                  // no chart: all four
    CHECK(at(2, 0) == Color{200, 0, 0, 170});  // the half without a chart is left out there, too
}

TEST_CASE("A chart on a level one texel wide or high is known on the coarser ones") {
    for (const bool upright : {false, true}) {
        txc::MipChain mips;
        mips.allocate(upright ? 1 : 8, upright ? 8 : 1, 4);
        txc::CoverageBits charts(upright ? 1 : 8, upright ? 8 : 1);
        charts.claim(upright ? 0 : 5, upright ? 5 : 0);
        mips.note_charts(charts);
        for (std::uint32_t level = 1; level < 3; ++level) {
            const std::uint32_t at = 5u >> level;
            CHECK(mips.covered[level].is_claimed(upright ? 0 : at, upright ? at : 0));
            CHECK_FALSE(mips.covered[level].is_claimed(0, 0) != (at == 0));
        }
    }
}
