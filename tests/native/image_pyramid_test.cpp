// A decal's picture and its coarser levels, premultiplied (spec section 5).
#include "image_pyramid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/picture.h"
#include "support/random.h"

using namespace support;

namespace {

struct Built {
    txc::MemoryBudget budget{1u << 28};
    txc::ImagePyramid image{budget};
    explicit Built(const Picture& picture) {
        REQUIRE(image.build(picture.width, picture.height, picture.rgba.data()) == TXC_STATUS_OK);
    }
    double mean_alpha(std::size_t level) const {
        const txc::PyramidLevel& on = image.levels[level];
        double sum = 0.0;
        for (std::uint32_t y = 0; y < on.height; ++y) {
            for (std::uint32_t x = 0; x < on.width; ++x) sum += on.color_at(x, y)[3];
        }
        return sum / (static_cast<double>(on.width) * on.height);
    }
    /// Premultiplied, on 0 to 255.
    double at(float x, float y, bool repeat, int channel) const {
        const txc::Float4 color = txc::sample_bilinear(image.levels[0], x, y, repeat);
        return static_cast<double>(color[channel]) * 255.0 / static_cast<double>(txc::kFullScale);
    }
};

}  // namespace

TEST_CASE("The finest level holds colour times alpha exactly") {
    const Picture picture = make_noise(9, 7, 150);
    const Built built(picture);
    for (std::uint32_t y = 0; y < 7; ++y) {
        for (std::uint32_t x = 0; x < 9; ++x) {
            const Color color = picture.at(x, y);
            const txc::Int4 pixel = built.image.levels[0].color_at(x, y);
            CHECK_UNARY(pixel[0] == color.red * color.alpha);
            CHECK_UNARY(pixel[2] == color.blue * color.alpha);
            CHECK_UNARY(pixel[3] == color.alpha * 255);
        }
    }
}

TEST_CASE("Levels halve down to one pixel, odd sizes rounded down") {
    const Built built(make_noise(21, 6, 151));
    const std::uint32_t sizes[][2] = {{21, 6}, {10, 3}, {5, 1}, {2, 1}, {1, 1}};
    REQUIRE(built.image.levels.size() == 5);
    for (std::size_t level = 0; level < 5; ++level) {
        CHECK(built.image.levels[level].width == sizes[level][0]);
        CHECK(built.image.levels[level].height == sizes[level][1]);
    }
    CHECK(Built(make_noise(1, 1, 152)).image.levels.size() == 1);
}

TEST_CASE("A coarser level's pixel is the mean of the area that it stands for, at odd sizes too") {
    // Five pixels make two: each stands for two and a half.
    Picture row(5, 1, {0, 0, 0, 255});
    for (std::uint32_t x = 0; x < 5; ++x) row.set(x, 0, {static_cast<std::uint8_t>(10 + 40 * x * x / 4), 0, 0, 255});
    const Built built(row);
    const double red[5] = {10, 20, 50, 100, 170};
    REQUIRE(row.at(4, 0).red == 170);
    const txc::PyramidLevel& half = built.image.levels[1];
    CHECK(half.color_at(0, 0)[0] == doctest::Approx(255 * (red[0] + red[1] + red[2] / 2) / 2.5).epsilon(1e-4));
    CHECK(half.color_at(1, 0)[0] == doctest::Approx(255 * (red[2] / 2 + red[3] + red[4]) / 2.5).epsilon(1e-4));
    // So no level is lighter or darker than another.
    for (const std::uint32_t width : {16u, 15u, 13u, 3u}) {
        CAPTURE(width);
        const Built noise(make_noise(width, 11, 153));
        for (std::size_t level = 1; level < noise.image.levels.size(); ++level)
            CHECK(std::fabs(noise.mean_alpha(level) - noise.mean_alpha(level - 1)) < 1.0);
    }
}

TEST_CASE("A bilinear sample at a pixel's centre is that pixel, half way it is the mean") {
    Picture picture(2, 1, {100, 0, 0, 255});
    picture.set(1, 0, {200, 0, 0, 255});
    const Built built(picture);
    CHECK(built.at(0.5f, 0.5f, false, 0) == doctest::Approx(100).epsilon(1e-6));
    CHECK(built.at(1.5f, 0.5f, false, 0) == doctest::Approx(200).epsilon(1e-6));
    CHECK(built.at(1.0f, 0.5f, false, 0) == doctest::Approx(150).epsilon(1e-6));
}

TEST_CASE("Beyond the border all is transparent, or the picture again") {
    const Built built(Picture(3, 2, {255, 255, 255, 255}));
    CHECK(built.at(0.0f, 1.0f, false, 3) == doctest::Approx(127.5).epsilon(1e-6));
    CHECK(built.at(-0.5f, 1.0f, false, 3) == 0.0);
    CHECK(built.at(3.5f, 1.0f, false, 3) == 0.0);
    CHECK(built.at(1.5f, -7.0f, false, 3) == 0.0);
    for (const float x : {-100.25f, -0.5f, 0.0f, 3.0f, 57.75f})
        CHECK(built.at(x, 0.1f, true, 3) == doctest::Approx(255));
}

TEST_CASE("A picture that does not fit the budget is refused") {
    txc::MemoryBudget budget(1000);
    txc::ImagePyramid image(budget);
    const Picture picture(64, 64);
    CHECK(image.build(64, 64, picture.rgba.data()) == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(budget.used() == 0);
}

TEST_CASE("A window knows the roughest of its pixels, and of no other") {
    // A single speck on plain ground makes itself and its neighbours rough.
    constexpr std::int32_t kSide = 48;
    Picture picture(kSide, kSide, {90, 90, 90, 255});
    picture.set(20, 23, {200, 90, 90, 255});
    const Built built(picture);
    const txc::PyramidLevel& level = built.image.levels[0];
    const auto is_rough = [&](const std::vector<std::uint8_t>& list, std::int32_t x, std::int32_t y) {
        return level.first_of(list)[y * level.stride() + x] > 2 * txc::kMostBend;
    };
    const auto check = [&](const std::vector<std::uint8_t>& list, std::int32_t half) {
        std::uint32_t wrong = 0;
        // Windows that do not meet the picture's border, which is rough too.
        for (std::int32_t y = half; y + half < kSide - 1; ++y) {
            for (std::int32_t x = half; x + half < kSide - 1; ++x) {
                const bool meets = x - half + 1 <= 21 && x + half >= 19 && y - half + 1 <= 24 && y + half >= 22;
                wrong += is_rough(list, x, y) != meets ? 1 : 0;
            }
        }
        CAPTURE(half);
        CHECK(wrong == 0);
    };
    check(level.peaks[0], 1);
    check(level.peaks[1], 2);
    check(level.bends[0], 2);
    check(level.bends[1], 4);
    check(level.bends[2], 8);
}

TEST_CASE("Pixels are called clear only where nothing is painted, and always where nothing is near") {
    constexpr std::int32_t kSide = 128;
    constexpr std::int32_t kNear =
        18;  // windows reach up to 16 pixels beyond, and know what lies two pixels from their own
    Picture picture(kSide, kSide, {0, 0, 0, 0});
    Random random(71);
    for (int i = 0; i < 7; ++i) picture.set(random.below(kSide), random.below(kSide), {9, 9, 9, 1});
    const Built built(picture);
    const txc::PyramidLevel& level = built.image.levels[0];
    const auto is_painted = [&](std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) {
        for (std::int32_t y = std::max(top, 0); y <= std::min(bottom, kSide - 1); ++y) {
            for (std::int32_t x = std::max(left, 0); x <= std::min(right, kSide - 1); ++x) {
                if (level.color_at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))[3] != 0) return true;
            }
        }
        return false;
    };
    const auto place = [&] { return static_cast<std::int32_t>(random.below(kSide + 40)) - 20; };
    std::uint32_t wrong = 0;
    std::uint32_t missed = 0;
    std::uint32_t clear = 0;
    for (int round = 0; round < 4000; ++round) {
        const std::int32_t left = place();
        const std::int32_t top = place();
        const std::int32_t right = left + static_cast<std::int32_t>(random.below(40));
        const std::int32_t bottom = top + static_cast<std::int32_t>(random.below(40));
        const bool is_clear = level.is_clear(left, top, right, bottom);
        clear += is_clear ? 1 : 0;
        wrong += is_clear && is_painted(left, top, right, bottom) ? 1 : 0;
        const bool is_amid = left >= kNear && top >= kNear && right < kSide - kNear && bottom < kSide - kNear;
        const bool is_lonely = !is_painted(left - kNear, top - kNear, right + kNear, bottom + kNear);
        missed += is_amid && is_lonely && !is_clear ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK(missed == 0);
    CHECK(clear > 500);
    CHECK(clear < 3500);
}

TEST_CASE("What rounding to bytes leaves of a slope counts as a plane, and a curve does not") {
    constexpr std::uint32_t kSide = 64;
    Picture slope(kSide, kSide);
    Picture curve(kSide, kSide);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const auto plane = static_cast<std::uint8_t>(std::lround(20 + 1.37 * x + 0.71 * y));
            slope.set(x, y, {plane, plane, plane, 255});
            // As far as bytes go; checked well within that.
            const double away = std::fmin(std::fabs(static_cast<double>(x) - kSide / 2.0), 22.0);
            const auto bent = static_cast<std::uint8_t>(std::lround(0.5 * away * away));
            curve.set(x, y, {bent, bent, bent, 255});
        }
    }
    const Built flat(slope);
    const Built bent(curve);
    const auto most = [](const Built& built, std::uint32_t x) {
        const txc::PyramidLevel& level = built.image.levels[0];
        return level.first_of(level.bends[1])[32 * level.stride() + static_cast<std::int32_t>(x)];
    };
    for (std::uint32_t x = 8; x < kSide - 8; ++x) {
        CHECK(most(flat, x) <= txc::kMostBend);
        // A step a pixel all along, which is no more than rounding makes of a slope: four at the wider stride.
        if (x > 16 && x < kSide - 16) CHECK(most(bent, x) > txc::kMostBend);
    }
}
