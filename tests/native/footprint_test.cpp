// Where one sample stands for a footprint's mean, it is within an 8-bit step of it (footprint.h).
#include "footprint.h"

#include <doctest/doctest.h>

#include <cmath>

#include "bilinear.h"
#include "support/picture.h"
#include "support/shapes.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 12;
constexpr double kByteStep = txc::kByteStep;

/// Opaque pictures that one sample may stand for here and there. `kind` 0: a roof with its ridges on pixel centres, the
/// worst there is; 1: a curved and twisted surface; 2: faint noise; 3: a curved surface with specks.
Picture make_smooth(int kind, Random& random) {
    Picture picture(kSize, kSize);
    const double bend_x = random.between(-2.5, 2.5);
    const double bend_y = random.between(-2.5, 2.5);
    const double twist = random.between(-2.0, 2.0);
    const std::uint32_t noise = 1 + random.below(6);
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const double dx = x - kSize / 2.0;
            const double dy = y - kSize / 2.0;
            double value = 128.0;
            if (kind == 0) value += std::round(2 * bend_x) * std::fabs(dx) + std::round(2 * bend_y) * std::fabs(dy);
            if (kind == 1 || kind == 3) value += 0.5 * (bend_x * dx * dx + bend_y * dy * dy) + twist * dx * dy;
            if (kind == 2) value += random.below(noise + 1);
            if (kind == 3 && random.below(30) == 0) value = 255.0;
            const auto byte = static_cast<std::uint8_t>(std::fmin(std::fmax(value, 0.0), 255.0));
            picture.set(x, y, {byte, byte, byte, 255});
        }
    }
    return picture;
}

/// A footprint whose sides have these lengths: the one at this angle, the other by `corner` further on.
txc::Footprint make_turned(const txc::ImagePyramid& image, double across, double down, double turned, double corner) {
    const auto part = [](double of) { return static_cast<float>(of); };
    return txc::make_footprint(image, part(across * std::cos(turned)), part(across * std::sin(turned)),
                               part(down * std::cos(turned + corner)), part(down * std::sin(turned + corner)), false);
}

/// How rough a footprint's list calls the level around a place, which is in pixels of the level.
std::int32_t roughness_at(const txc::PyramidLevel& level, const std::uint8_t* list, float x, float y) {
    const auto column = static_cast<std::int32_t>(std::floor(x - 0.5f));
    const auto row = static_cast<std::int32_t>(std::floor(y - 0.5f));
    return list[std::ptrdiff_t{row} * level.stride() + column];
}

/// The mean of red over the footprint by `samples` x `samples` of them, 0 to 255.
double dense_mean(const txc::PyramidLevel& level, const txc::Footprint& f, float x, float y, int samples = 24) {
    double sum = 0.0;
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(samples) - 0.5f;
            const float v = (static_cast<float>(j) + 0.5f) / static_cast<float>(samples) - 0.5f;
            const float sample_x = x + f.across_x * u + f.down_x * v;
            const float sample_y = y + f.across_y * u + f.down_y * v;
            sum += static_cast<double>(txc::sample_bilinear(level, sample_x, sample_y, false)[0]);
        }
    }
    return sum / (samples * samples) / kByteStep;
}

/// PSNR, dB, of what a footprint takes against means by `samples` x `samples`, at places at least `rim` pixels inside the picture.
double closeness(const txc::ImagePyramid& image, const txc::Footprint& f, Random& random, double rim, int places,
                 int samples) {
    double squares = 0.0;
    for (int i = 0; i < places; ++i) {
        const auto x = static_cast<float>(random.between(rim, image.levels[0].width - rim));
        const auto y = static_cast<float>(random.between(rim, image.levels[0].height - rim));
        const double error = static_cast<double>(txc::sample_inside(image, f, x, y)[0]) / kByteStep -
                             dense_mean(image.levels[0], f, x, y, samples);
        squares += error * error;
    }
    return 10.0 * std::log10(255.0 * 255.0 * places / squares);
}

}  // namespace

TEST_CASE("One sample stands for a footprint only where it is within a step of the mean") {
    Random random(46);
    std::uint32_t spared[4] = {0, 0, 0, 0};
    double worst = 0.0;
    for (int round = 0; round < 1200; ++round) {
        const int kind = round % 4;
        const Picture picture = make_smooth(kind, random);
        txc::MemoryBudget budget(1u << 20);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSize, kSize, picture.rgba.data()) == TXC_STATUS_OK);
        for (int attempt = 0; attempt < 12; ++attempt) {
            const double across = std::pow(10.0, random.between(-0.7, 0.6));
            const double down = across * random.between(0.1, 1.0);
            const double turned = random.below(3) * kPi / 4;
            const double corner = random.between(0.3, 1.0) * kPi / 2;
            const txc::Footprint f = make_turned(image, across, down, turned, corner);
            // Half of them stand on a pixel's centre, where a kink counts most.
            const bool centred = random.coin();
            const double middle = kSize / 2 + 0.5;
            const auto x = static_cast<float>(centred ? middle : random.between(f.inset_x, kSize - f.inset_x));
            const auto y = static_cast<float>(centred ? middle : random.between(f.inset_y, kSize - f.inset_y));
            const txc::PyramidLevel& level = image.levels[0];
            if (f.level != 0) continue;
            if (roughness_at(level, f.smooth_list, x, y) > f.smooth_limit) continue;
            const double one = static_cast<double>(txc::sample_inside(image, f, x, y)[0]) / kByteStep;
            worst = std::fmax(worst, std::fabs(one - dense_mean(level, f, x, y)));
            ++spared[kind];
        }
    }
    CHECK(worst <= 1.0);
    // The claim is not empty, and the limit is not stricter than it need be.
    CHECK(worst >= 0.7);
    for (const std::uint32_t count : spared) CHECK(count > 200);
}

TEST_CASE("On hard edges one sample stands for a footprint only where it lies between the centres of pixels") {
    constexpr std::uint32_t kSide = 32;
    Random random(49);
    double worst = 0.0;
    std::uint32_t spared = 0;
    std::uint32_t asked = 0;
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t cell = 3 + random.below(8);
        Picture picture(kSide, kSide);
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const auto byte = static_cast<std::uint8_t>((x / cell + y / cell) % 2 == 0 ? 40 : 170 + 3 * round % 80);
                picture.set(x, y, {byte, byte, byte, 255});
            }
        }
        txc::MemoryBudget budget(1u << 22);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSide, kSide, picture.rgba.data()) == TXC_STATUS_OK);
        const txc::PyramidLevel& level = image.levels[0];
        const double across = random.between(0.1, 1.2);
        const double down = across * random.between(0.4, 1.0);
        const double turned = random.between(0.0, 2 * kPi);
        const double corner = kPi / 2 + random.between(-0.2, 0.2);
        const txc::Footprint f = make_turned(image, across, down, turned, corner);
        for (int i = 0; i < 300; ++i) {
            const auto x = static_cast<float>(random.between(4.0, kSide - 4.0));
            const auto y = static_cast<float>(random.between(4.0, kSide - 4.0));
            const std::int32_t steps = roughness_at(level, f.smooth_list, x, y);
            if (steps <= f.smooth_limit) continue;
            ++asked;
            const auto fixed = [](float pixels) { return txc::splat(txc::to_fixed(pixels - 0.5f)); };
            if (txc::are_rough(f, txc::splat(steps), fixed(x), fixed(y))[0] != 0) continue;
            const auto reaches = [](float place, float reach) {
                return std::floor(place - 0.5f - reach) != std::floor(place - 0.5f + reach);
            };
            CHECK_UNARY(!reaches(x, f.reach_x - 1e-3f) && !reaches(y, f.reach_y - 1e-3f));
            ++spared;
            const double one = static_cast<double>(txc::sample_bilinear(level, x, y, false)[0]) / kByteStep;
            worst = std::fmax(worst, std::fabs(one - dense_mean(level, f, x, y)));
        }
    }
    CAPTURE(worst);
    CHECK(worst <= 0.8);
    CHECK(worst >= 0.6);
    CAPTURE(asked);
    CHECK(spared > asked / 8);
}

TEST_CASE(
    "Between the corners of a square that passes the test for smoothness, the colours interpolated are within 3 "
    "steps") {
    Random random(50);
    double worst = 0.0;
    std::uint32_t passed[2] = {0, 0};
    for (int round = 0; round < 1600; ++round) {
        const Picture picture = make_smooth(round % 4, random);
        txc::MemoryBudget budget(1u << 20);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSize, kSize, picture.rgba.data()) == TXC_STATUS_OK);
        const txc::PyramidLevel& level = image.levels[0];
        const double side = random.between(0.05, 0.9);
        const double turned = random.between(0.0, 2 * kPi);
        const auto right_x = static_cast<float>(side * std::cos(turned));
        const auto right_y = static_cast<float>(side * std::sin(turned));
        const txc::Footprint f = txc::make_footprint(image, right_x, right_y, -right_y, right_x, false);
        const txc::ChordLimits limits = txc::tile_chord_limits(image, f);
        for (int k = 0; k < 2; ++k) {
            const int texels = k == 0 ? 3 : 5;
            const txc::SmoothTest& test = k == 0 ? limits.block : limits.tile;
            if (test.limit < 0) continue;
            const auto x = static_cast<float>(random.between(2.0, kSize - 2.0));
            const auto y = static_cast<float>(random.between(2.0, kSize - 2.0));
            double corners[4];
            txc::PlaceBounds bounds{};
            bool is_inside = true;
            for (int c = 0; c < 4; ++c) {
                const auto i = static_cast<float>(c % 2 * texels);
                const auto j = static_cast<float>(c / 2 * texels);
                const float at_x = x + right_x * i - right_y * j;
                const float at_y = y + right_y * i + right_x * j;
                if (!(at_x > 1.0f && at_x < kSize - 1.0f && at_y > 1.0f && at_y < kSize - 1.0f)) {
                    is_inside = false;
                    break;
                }
                const txc::Int4 at = {txc::to_fixed(at_x - 0.5f), txc::to_fixed(at_y - 0.5f), 0, 0};
                const txc::PlaceBounds own = {at[0], at[1], at[0], at[1]};
                const txc::Int4 low = c == 0 ? own : txc::lesser(bounds, own);
                const txc::Int4 high = c == 0 ? own : txc::greater(bounds, own);
                bounds = txc::PlaceBounds{low[0], low[1], high[2], high[3]};
                corners[c] = static_cast<double>(txc::sample_bilinear(level, at_x, at_y, false)[0]) / kByteStep;
            }
            if (!is_inside || !test.is_smooth(bounds, level.stride())) continue;
            ++passed[k];
            for (int j = 0; j <= texels; ++j) {
                for (int i = 0; i <= texels; ++i) {
                    const double u = static_cast<double>(i) / texels;
                    const double v = static_cast<double>(j) / texels;
                    const double between =
                        (corners[0] * (1 - u) + corners[1] * u) * (1 - v) + (corners[2] * (1 - u) + corners[3] * u) * v;
                    const auto fi = static_cast<float>(i);
                    const auto fj = static_cast<float>(j);
                    const double mean =
                        dense_mean(level, f, x + right_x * fi - right_y * fj, y + right_y * fi + right_x * fj);
                    worst = std::fmax(worst, std::fabs(between - mean));
                }
            }
        }
    }
    CHECK(worst <= 3.0);
    CHECK(worst >= 0.7);
    CHECK(passed[0] > 100);
    CHECK(passed[1] > 100);
}

TEST_CASE("A footprint that a speck touches takes all its samples, and one well clear of it a single one") {
    Picture picture(32, 32, {100, 100, 100, 255});
    constexpr float kSpeck = 16.5f;
    picture.set(16, 16, {255, 100, 100, 255});
    txc::MemoryBudget budget(1u << 20);
    txc::ImagePyramid image(budget);
    REQUIRE(image.build(32, 32, picture.rgba.data()) == TXC_STATUS_OK);
    // Two that reach nearly as far as the roughness knows, and one that reaches further.
    for (const float width : {1.9f, 3.9f, 6.0f}) {
        const txc::Footprint f = txc::make_footprint(image, width, 0.0f, 0.0f, width, false);
        REQUIRE(f.level == 0);
        std::uint32_t lost = 0;
        std::uint32_t clear_but_not_spared = 0;
        // Sixteenths of a pixel, so that every place in a pixel is tried.
        for (int row = 8 * 16; row < 25 * 16; ++row) {
            for (int column = 8 * 16; column < 25 * 16; ++column) {
                const float x = static_cast<float>(column) / 16.0f;
                const float y = static_cast<float>(row) / 16.0f;
                const float away = std::fmax(std::fabs(x - kSpeck), std::fabs(y - kSpeck));
                const bool spared = roughness_at(image.levels[0], f.smooth_list, x, y) <= f.smooth_limit;
                // The speck's bilinear ramp is a pixel wide on either side.
                lost += spared && away < width / 2 + 1 ? 1 : 0;
                clear_but_not_spared += !spared && away > width / 2 + 2 ? 1 : 0;
            }
        }
        CAPTURE(width);
        CHECK(lost == 0);
        if (width < 4.0f) CHECK(clear_but_not_spared == 0);
    }
}

TEST_CASE("Small footprints keep close to the mean on the hardest pictures, in any direction") {
    constexpr std::uint32_t kSide = 48;
    Random random(47);
    double worst = 1e9;
    std::uint32_t cut = 0;
    for (int round = 0; round < 480; ++round) {
        // Checkers of 1 to 6 pixels, stripes, noise: black and white, and every texel on an edge.
        const std::uint32_t cell = 1 + static_cast<std::uint32_t>(round % 6);
        const int kind = round % 7;
        Picture picture(kSide, kSide);
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const bool lit = kind == 0   ? random.coin()
                                 : kind == 1 ? x / (1 + cell % 3) % 2 == 0
                                             : (x / cell + y / cell) % 2 == 0;
                const std::uint8_t byte = lit ? 255 : 0;
                picture.set(x, y, {byte, byte, byte, 255});
            }
        }
        txc::MemoryBudget budget(1u << 22);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSide, kSide, picture.rgba.data()) == TXC_STATUS_OK);
        const double across = random.between(0.1, 3.0);
        const double down = across * random.between(0.3, 1.0);
        const double turned = random.below(4) == 0 ? 0.0 : random.between(0.0, 2 * kPi);
        const double corner = kPi / 2 + random.between(-0.9, 0.9);
        const txc::Footprint f = make_turned(image, across, down, turned, corner);
        // Those that lean so much that they would be cut into too many parts take samples.
        if (f.parts == 0) continue;
        ++cut;
        worst = std::fmin(worst, closeness(image, f, random, 6.0, 300, 24));
    }
    CHECK(worst >= 39.0);
    CHECK(cut > 400);
}

TEST_CASE("Footprints up to three pixels, turned by any angle, keep what is asked on the finest checkers and stripes") {
    constexpr std::uint32_t kSide = 48;
    Random random(59);
    double worst = 1e9;
    for (const bool checker : {true, false}) {
        Picture picture(kSide, kSide);
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const std::uint8_t byte = (checker ? x + y : x) % 2 == 0 ? 255 : 0;
                picture.set(x, y, {byte, byte, byte, 255});
            }
        }
        txc::MemoryBudget budget(1u << 22);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSide, kSide, picture.rgba.data()) == TXC_STATUS_OK);
        for (int round = 0; round < 1200; ++round) {
            const double across = random.between(0.2, 3.0);
            const double down = round % 3 == 0 ? across : across * random.between(0.05, 1.0);
            const double corner = kPi / 2 + (round % 2 == 0 ? 0.0 : random.between(-0.9, 0.9));
            const txc::Footprint f = make_turned(image, across, down, random.between(0.0, kPi), corner);
            worst = std::fmin(worst, closeness(image, f, random, 10.0, 120, 8));
        }
    }
    CHECK(worst >= 40.0);
}

TEST_CASE("Long footprints keep close to the reference of 8 x 8 samples on the finest stripes and checkers") {
    constexpr std::uint32_t kSide = 64;
    Random random(53);
    double worst = 1e9;
    for (int round = 0; round < 800; ++round) {
        const std::uint32_t cell = 1 + static_cast<std::uint32_t>(round % 3);
        const int kind = round % 4;
        Picture picture(kSide, kSide);
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const bool lit = kind == 0   ? random.coin()
                                 : kind == 1 ? x / cell % 2 == 0
                                 : kind == 2 ? y / cell % 2 == 0
                                             : (x / cell + y / cell) % 2 == 0;
                const std::uint8_t byte = lit ? 255 : 0;
                picture.set(x, y, {byte, byte, byte, 255});
            }
        }
        txc::MemoryBudget budget(1u << 22);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSide, kSide, picture.rgba.data()) == TXC_STATUS_OK);
        const double across = random.between(0.5, 8.0);
        const double down = random.between(0.5, 8.0);
        const double turned = random.coin() ? 0.0 : random.between(0.0, 2 * kPi);
        const double corner = kPi / 2 + (random.coin() ? 0.0 : random.between(-0.3, 0.3));
        const txc::Footprint f = make_turned(image, across, down, turned, corner);
        worst = std::fmin(worst, closeness(image, f, random, 10.0, 100, 8));
    }
    CHECK(worst >= 40.0);
}

TEST_CASE(
    "Large footprints take fewer samples where the picture is calm, and keep 40 dB on the hardest that count as calm") {
    constexpr std::uint32_t kSide = 64;
    txc::MemoryBudget plain_budget(1u << 22);
    txc::ImagePyramid plain(plain_budget);
    REQUIRE(plain.build(kSide, kSide, Picture(kSide, kSide, {9, 9, 9, 255}).rgba.data()) == TXC_STATUS_OK);
    const std::int32_t limit = txc::make_footprint(plain, 5.0f, 0.0f, 0.0f, 5.0f, false).calm_limit;
    REQUIRE(limit > 0);
    Random random(51);
    double worst = 1e9;
    std::uint32_t calm = 0;
    for (int round = 0; round < 160; ++round) {
        // Noise, upright and slanted stripes, checkers of 2 to 11 pixels; as large a step as counts as calm, in noise half of it.
        const int kind = round % 8;
        const std::uint32_t cell = kind == 7 ? 12 : static_cast<std::uint32_t>(kind);
        const std::int32_t step = kind == 0 ? limit : limit * 2;
        Picture picture(kSide, kSide);
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const bool lit = kind == 0   ? random.coin()
                                 : kind == 1 ? (x + y) / 4 % 2 == 0
                                 : kind == 2 ? x / 2 % 2 == 0
                                             : (x / (cell - 1) + y / (cell - 1)) % 2 == 0;
                const std::uint8_t byte = static_cast<std::uint8_t>(100 + (lit ? step : 0));
                picture.set(x, y, {byte, byte, byte, 255});
            }
        }
        txc::MemoryBudget budget(1u << 22);
        txc::ImagePyramid image(budget);
        REQUIRE(image.build(kSide, kSide, picture.rgba.data()) == TXC_STATUS_OK);
        const double across = random.between(3.1, 8.0);
        const double down = std::fmax(3.1, across * random.between(0.5, 1.0));
        const double turned = random.below(4) == 0 ? 0.0 : random.between(0.0, 2 * kPi);
        const double corner = kPi / 2 + random.between(-0.3, 0.3);
        const txc::Footprint f = make_turned(image, across, down, turned, corner);
        if (f.level != 0 || f.calm_limit < 0) continue;
        const std::int32_t samples = f.calm_lattice.across_samples * f.calm_lattice.down_samples;
        if (f.parts > 0) CHECK(samples <= f.parts * 2);  // a part's kernel is the work of three samples
        if (f.parts == 0) CHECK(samples * 3 <= f.lattice.across_samples * f.lattice.down_samples * 2);
        double squares = 0.0;
        constexpr int kPlaces = 100;
        for (int i = 0; i < kPlaces; ++i) {
            const auto x = static_cast<float>(random.between(18.0, kSide - 18.0));
            const auto y = static_cast<float>(random.between(18.0, kSide - 18.0));
            calm += roughness_at(image.levels[0], f.calm_list, x, y) <= f.calm_limit ? 1 : 0;
            const double error = static_cast<double>(txc::sample_inside(image, f, x, y)[0]) / kByteStep -
                                 dense_mean(image.levels[0], f, x, y);
            squares += error * error;
        }
        worst = std::fmin(worst, 10.0 * std::log10(255.0 * 255.0 * kPlaces / squares));
    }
    CAPTURE(calm);
    CHECK(calm > 5000);
    CAPTURE(worst);
    CHECK(worst >= 40.0);
    // The limit is not stricter than it need be.
    CHECK(worst <= 43.0);
}

TEST_CASE("A large footprint that may meet a hard edge takes all its samples") {
    Picture picture(64, 64, {100, 100, 100, 255});
    constexpr float kEdge = 32.0f;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 32; x < 64; ++x) picture.set(x, y, {255, 100, 100, 255});
    }
    txc::MemoryBudget budget(1u << 22);
    txc::ImagePyramid image(budget);
    REQUIRE(image.build(64, 64, picture.rgba.data()) == TXC_STATUS_OK);
    const txc::Footprint f = txc::make_footprint(image, 6.0f, 3.0f, -3.0f, 6.0f, false);
    REQUIRE(f.level == 0);
    REQUIRE(f.calm_limit >= 0);
    for (std::int32_t column = 16; column < 48; ++column) {
        // The last place of which the column's pixel tells.
        const float x = static_cast<float>(column) + 1.499f;
        const float away = std::fabs(x - kEdge);
        const bool is_calm = roughness_at(image.levels[0], f.calm_list, x, 32.5f) <= f.calm_limit;
        // The bilinear edge is a pixel wide.
        if (away < f.reach_x + 0.5f) CHECK_UNARY(!is_calm);
        if (away > 12.0f) CHECK_UNARY(is_calm);
    }
}

TEST_CASE("A footprint over a plain stretch gives its very colour, whatever its shape") {
    const Picture picture(16, 16, {37, 201, 94, 255});
    txc::MemoryBudget budget(1u << 22);
    txc::ImagePyramid image(budget);
    REQUIRE(image.build(16, 16, picture.rgba.data()) == TXC_STATUS_OK);
    Random random(48);
    for (int round = 0; round < 400; ++round) {
        const auto side = static_cast<float>(random.between(0.05, 2.5));
        const auto lean = static_cast<float>(random.between(-0.5, 0.5));
        txc::Footprint f = txc::make_footprint(image, side, side * lean, -side * lean * 0.5f, side * 0.8f, false);
        REQUIRE(f.parts > 0);
        f.smooth_limit = -1;  // so that the kernels answer
        const txc::Float4 color = txc::sample_inside(image, f, static_cast<float>(random.between(5.0, 11.0)),
                                                     static_cast<float>(random.between(5.0, 11.0)));
        constexpr auto kScale = static_cast<float>(txc::kByteStep);
        CHECK_UNARY(color[0] == 37.0f * kScale && color[1] == 201.0f * kScale && color[2] == 94.0f * kScale &&
                    color[3] == txc::kFullScale);
    }
}
