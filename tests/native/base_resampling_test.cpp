// How a base picture is brought to another size, against the formula said plainly.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base_picture.h"
#include "support/picture.h"

using namespace support;
using txc::ResampledWindow;

namespace {

struct Size {
    std::uint32_t width, height;
};

Picture resample(const Picture& picture, const ResampledWindow& window, bool nearest) {
    Picture out(window.width, window.height);
    txc::resample_rgba(picture.rgba.data(), picture.width, picture.height, nearest, window, out.rgba.data());
    return out;
}

Picture resample(const Picture& picture, Size size, bool nearest = false) {
    return resample(picture, {size.width, size.height, 0, 0, size.width, size.height}, nearest);
}

struct Taps {
    std::uint32_t first;
    std::vector<double> weights;
};

/// The pixels under one output row or column.
Taps find_taps(std::uint32_t index, std::uint32_t size, std::uint32_t out_size) {
    const double step = static_cast<double>(size) / out_size;
    if (out_size >= size) {
        const double at = std::clamp((index + 0.5) * step - 0.5, 0.0, size - 1.0);
        const auto first = static_cast<std::uint32_t>(at);
        if (at == first) return {first, {1.0}};
        return {first, {1.0 - (at - first), at - first}};
    }
    const double begin = index * step;
    const double end = std::min<double>(begin + step, size);
    Taps taps{static_cast<std::uint32_t>(begin), {}};
    for (std::uint32_t pixel = taps.first; pixel < end; ++pixel)
        taps.weights.push_back((std::min(end, pixel + 1.0) - std::max<double>(begin, pixel)) / (end - begin));
    return taps;
}

/// Red, green, blue and alpha before they are rounded.
struct Mean {
    double channels[4];
};

Mean mean_of(const Picture& picture, const Taps& rows, const Taps& columns) {
    double weighted[3] = {0, 0, 0};
    double plain[3] = {0, 0, 0};
    double alpha = 0;
    for (std::uint32_t j = 0; j < rows.weights.size(); ++j) {
        for (std::uint32_t i = 0; i < columns.weights.size(); ++i) {
            const Color color = picture.at(columns.first + i, rows.first + j);
            const std::uint8_t rgb[3] = {color.red, color.green, color.blue};
            const double weight = rows.weights[j] * columns.weights[i];
            for (int c = 0; c < 3; ++c) {
                weighted[c] += weight * color.alpha * rgb[c];
                plain[c] += weight * rgb[c];
            }
            alpha += weight * color.alpha;
        }
    }
    Mean mean{{0, 0, 0, alpha}};
    for (int c = 0; c < 3; ++c) mean.channels[c] = alpha > 0.0 ? weighted[c] / alpha : plain[c];
    return mean;
}

/// Noise, a part of it without alpha and a part of it opaque, in pieces.
Picture make_pieces(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
    Picture picture = make_noise(width, height, seed);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            Color color = picture.at(x, y);
            const std::uint32_t piece = (x / 5 + y / 3 + static_cast<std::uint32_t>(seed)) % 3;
            if (piece == 0) color.alpha = 0;
            if (piece == 1) color.alpha = 255;
            picture.set(x, y, color);
        }
    }
    return picture;
}

/// Up, down, both at once, a pixel wide or high, odd, and by powers of two, where many means lie just between two bytes.
std::vector<std::pair<Size, Size>> size_pairs() {
    std::vector<std::pair<Size, Size>> pairs = {
        {{16, 16}, {128, 64}}, {{64, 32}, {16, 16}}, {{40, 10}, {10, 40}}, {{7, 90}, {90, 7}},   {{1, 1}, {9, 5}},
        {{1, 33}, {50, 8}},    {{33, 1}, {8, 50}},   {{61, 47}, {1, 1}},   {{61, 47}, {1, 90}},  {{61, 47}, {60, 48}},
        {{3, 3}, {257, 255}},  {{300, 2}, {7, 3}},   {{1500, 3}, {2, 2}},  {{90, 90}, {15, 30}},
    };
    Random random(300);
    for (int i = 0; i < 40; ++i) {
        const auto size = [&random] { return Size{1 + random.below(70), 1 + random.below(70)}; };
        const Size from = size();
        pairs.emplace_back(from, size());
    }
    return pairs;
}

}  // namespace

TEST_CASE("A resampled base is the formula's mean, rounded; between two bytes it may be either") {
    std::uint64_t seed = 301;
    std::uint32_t bytes = 0;
    std::uint32_t others = 0;
    double worst = 0;
    for (const auto& [from, to] : size_pairs()) {
        for (const Picture& picture :
             {make_noise(from.width, from.height, seed, true), make_noise(from.width, from.height, seed),
              make_pieces(from.width, from.height, seed)}) {
            ++seed;
            const Picture out = resample(picture, to);
            for (std::uint32_t y = 0; y < to.height; ++y) {
                const Taps rows = find_taps(y, from.height, to.height);
                for (std::uint32_t x = 0; x < to.width; ++x) {
                    const Mean mean = mean_of(picture, rows, find_taps(x, from.width, to.width));
                    const Color color = out.at(x, y);
                    const double got[4] = {double(color.red), double(color.green), double(color.blue),
                                           double(color.alpha)};
                    for (int c = 0; c < 4; ++c) {
                        worst = std::max(worst, std::fabs(got[c] - mean.channels[c]) - 0.5);
                        others += got[c] == std::floor(mean.channels[c] + 0.5) ? 0 : 1;
                        ++bytes;
                    }
                }
            }
        }
    }
    CHECK(worst <= 1e-4);
    CHECK(others * 1000 <= bytes);
}

TEST_CASE("Nearest takes the pixel under a texel's centre as it is") {
    std::uint64_t seed = 500;
    for (const auto& [from, to] : size_pairs()) {
        const Picture picture = make_pieces(from.width, from.height, ++seed);
        const Picture out = resample(picture, to, true);
        std::uint32_t others = 0;
        for (std::uint32_t y = 0; y < to.height; ++y) {
            for (std::uint32_t x = 0; x < to.width; ++x) {
                const Color color =
                    picture.at(static_cast<std::uint32_t>((x + 0.5) * (double(from.width) / to.width)),
                               static_cast<std::uint32_t>((y + 0.5) * (double(from.height) / to.height)));
                others += out.at(x, y) == color ? 0 : 1;
            }
        }
        CHECK(others == 0);
    }
}

TEST_CASE("A window of a resampled base has the whole's bytes") {
    Random random(600);
    std::uint64_t seed = 601;
    for (const auto& [from, to] : size_pairs()) {
        for (const bool nearest : {false, true}) {
            const Picture picture = make_pieces(from.width, from.height, ++seed);
            const Picture whole = resample(picture, to, nearest);
            const std::uint32_t left = random.below(to.width);
            const std::uint32_t top = random.below(to.height);
            const Size size{1 + random.below(to.width - left), 1 + random.below(to.height - top)};
            const Picture part = resample(picture, {to.width, to.height, left, top, size.width, size.height}, nearest);
            std::uint32_t others = 0;
            for (std::uint32_t y = 0; y < size.height; ++y)
                for (std::uint32_t x = 0; x < size.width; ++x)
                    others += part.at(x, y) == whole.at(left + x, top + y) ? 0 : 1;
            CHECK(others == 0);
        }
    }
}
