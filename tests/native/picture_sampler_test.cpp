// One texel after another looks at a picture (picture_sampler.h): what each takes is its own, where the picture meets itself too.
#include "picture_sampler.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/picture.h"
#include "support/test_session.h"

using namespace support;

namespace {

class Pyramid {
public:
    explicit Pyramid(const Picture& picture) { must(image_.build(picture.width, picture.height, picture.rgba.data())); }
    const txc::ImagePyramid& image() const { return image_; }

private:
    txc::MemoryBudget budget_{1u << 30};
    txc::ImagePyramid image_{budget_};
};

txc::PictureSettings settings_of(bool repeat, double period) {
    txc::PictureSettings settings;
    settings.repeat = repeat;
    settings.period = period;
    return settings;
}

/// All zeros where the footprint lies beside the picture.
txc::Float4 take(txc::PictureSampler& sampler, const txc::PictureSight& sight) {
    return sampler.aim(sight) ? sampler.sample() : txc::splat(0.0f);
}

}  // namespace

TEST_CASE("What a texel takes of a picture does not depend on the texels that were looked at before") {
    const Pyramid pyramid(make_noise(24, 16, 200));
    Random random(201);
    for (int kind = 0; kind < 24; ++kind) {
        txc::PictureSettings settings = settings_of(random.coin(), kind % 3 == 0 ? 0.0 : kind % 3 == 1 ? 1.0 : 1.125);
        settings.nearest = kind >= 20;
        settings.flip_x = random.coin();
        settings.flip_y = random.coin();
        CAPTURE(kind);
        txc::PictureSampler practised(pyramid.image(), settings);
        txc::PictureSight sight{0.1, -0.2, 0.1, 0.03, -0.02, 0.15};
        double* const numbers[] = {&sight.x, &sight.y, &sight.across_x, &sight.across_y, &sight.down_x, &sight.down_y};
        std::uint32_t different = 0;
        for (int step = 0; step < 200; ++step) {
            // One number changes at a time, most often one of the footprint's.
            *numbers[random.below(6)] = step % 4 == 0 ? random.between(-0.6, 0.6) : random.between(-0.2, 0.2);
            txc::PictureSampler fresh(pyramid.image(), settings);
            different += txc::any_lane(take(practised, sight) != take(fresh, sight)) ? 1 : 0;
        }
        CHECK(different == 0);
    }
}

TEST_CASE(
    "Of a picture that goes round and repeats, a slanted footprint over the place where it meets itself takes the "
    "mean") {
    const Picture picture = make_noise(32, 32, 202, true);
    const Pyramid pyramid(picture);
    txc::PictureSampler sampler(pyramid.image(), settings_of(true, 1.0));
    Random random(203);
    double squares = 0.0;
    constexpr int kTexels = 150;
    for (int texel = 0; texel < kTexels; ++texel) {
        const double angle = random.between(0.0, 2.0 * kPi);
        const double across = random.between(1.0, 3.0) / 32;
        const double down = random.between(1.0, 3.0) / 32;
        txc::PictureSight sight;
        sight.x = (texel % 2 == 0 ? 0.5 : -0.5) + random.between(-0.01, 0.01);
        sight.y = random.between(-0.3, 0.3);
        sight.across_x = across * std::cos(angle);
        sight.across_y = across * std::sin(angle);
        sight.down_x = -down * std::sin(angle + 0.4);
        sight.down_y = down * std::cos(angle + 0.4);
        double mean = 0.0;
        constexpr int kSamples = 16;
        for (int j = 0; j < kSamples; ++j) {
            for (int i = 0; i < kSamples; ++i) {
                const double u = (i + 0.5) / kSamples - 0.5;
                const double v = (j + 0.5) / kSamples - 0.5;
                const double x = (0.5 + sight.x + sight.across_x * u + sight.down_x * v) * 32 - 0.5;
                const double y = (0.5 - sight.y - sight.across_y * u - sight.down_y * v) * 32 - 0.5;
                const double right = x - std::floor(x);
                const double below = y - std::floor(y);
                const auto red = [&](int column, int row) {
                    return static_cast<double>(picture
                                                   .at(static_cast<std::uint32_t>(std::floor(x) + column + 64) % 32,
                                                       static_cast<std::uint32_t>(std::floor(y) + row))
                                                   .red);
                };
                mean += (red(0, 0) * (1 - right) + red(1, 0) * right) * (1 - below) +
                        (red(0, 1) * (1 - right) + red(1, 1) * right) * below;
            }
        }
        mean /= kSamples * kSamples;
        const double error = static_cast<double>(take(sampler, sight)[0]) / txc::kByteStep - mean;
        squares += error * error;
    }
    CHECK(20.0 * std::log10(255.0 / std::sqrt(squares / kTexels)) >= 40.0);
}

TEST_CASE("Of a picture that goes round and repeats, a footprint over its upper or lower edge takes the part inside") {
    const Pyramid pyramid(Picture(16, 16, {255, 255, 255, 255}));
    txc::PictureSampler sampler(pyramid.image(), settings_of(true, 1.0));
    for (const double x : {-0.5, 0.5}) {
        for (const double edge : {-0.5, 0.5}) {
            for (const double above : {-0.25, 0.0, 0.25}) {
                CAPTURE(x);
                CAPTURE(edge);
                CAPTURE(above);
                // Four pixels wide and high; `above`: how much of its height its middle lies above the edge.
                const txc::PictureSight sight{x, edge + above * 0.25, 0.25, 0.0, 0.0, -0.25};
                const double alpha =
                    static_cast<double>(take(sampler, sight)[3]) / static_cast<double>(txc::kFullScale);
                CHECK(alpha == doctest::Approx(edge > 0.0 ? 0.5 - above : 0.5 + above));
            }
        }
    }
}

TEST_CASE("A centre upon the picture's edge takes the nearest pixel there, and one beyond it none") {
    const Picture picture = make_noise(5, 3, 204, true);
    const Pyramid pyramid(picture);
    for (int flips = 0; flips < 4; ++flips) {
        txc::PictureSettings settings;
        settings.nearest = true;
        settings.flip_x = flips % 2 != 0;
        settings.flip_y = flips / 2 != 0;
        CAPTURE(flips);
        txc::PictureSampler sampler(pyramid.image(), settings);
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                CAPTURE(x);
                CAPTURE(y);
                const Color corner =
                    picture.at((x > 0.0) != settings.flip_x ? 4 : 0, (y > 0.0) != settings.flip_y ? 0 : 2);
                const txc::Float4 taken = take(sampler, {x, y, 0.1, 0.0, 0.0, 0.1});
                CHECK(taken[0] == static_cast<float>(corner.red * txc::kByteStep));
                CHECK(taken[2] == static_cast<float>(corner.blue * txc::kByteStep));
                CHECK(taken[3] == txc::kFullScale);
                CHECK(take(sampler, {x * 1.001, y, 0.1, 0.0, 0.0, 0.1})[3] == 0.0f);
                CHECK(take(sampler, {x, y * 1.001, 0.1, 0.0, 0.0, 0.1})[3] == 0.0f);
            }
        }
    }
}
