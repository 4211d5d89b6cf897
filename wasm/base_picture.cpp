#include "base_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace txc {
namespace {

/// The source pixels of one output row or column, and their weights (which add up to 1).
struct Taps {
    std::uint32_t first;
    std::vector<double> weights;
};

Taps find_taps(std::uint32_t index, std::uint32_t size, std::uint32_t out_size, bool nearest) {
    const double step = static_cast<double>(size) / out_size;
    const double last = static_cast<double>(size - 1);
    if (nearest) return {static_cast<std::uint32_t>(std::min((index + 0.5) * step, last)), {1.0}};
    if (out_size >= size) {
        const double at = std::clamp((index + 0.5) * step - 0.5, 0.0, last);
        const auto first = static_cast<std::uint32_t>(at);
        const double fraction = at - first;
        if (fraction == 0.0) return {first, {1.0}};
        return {first, {1.0 - fraction, fraction}};
    }
    const double begin = index * step;
    const double end = std::min(begin + step, static_cast<double>(size));
    Taps taps{static_cast<std::uint32_t>(begin), {}};
    for (std::uint32_t pixel = taps.first; pixel < end; ++pixel) {
        taps.weights.push_back((std::min(end, pixel + 1.0) - std::max(begin, static_cast<double>(pixel))) /
                               (end - begin));
    }
    return taps;
}

}  // namespace

void resample_rgba(const std::uint8_t* rgba, std::uint32_t width, std::uint32_t height, bool nearest,
                   const ResampledWindow& window, std::uint8_t* out) {
    if (width == window.whole_width && height == window.whole_height) {
        for (std::uint32_t y = 0; y < window.height; ++y) {
            std::memcpy(out + static_cast<std::size_t>(y) * window.width * 4,
                        rgba + (static_cast<std::size_t>(window.y + y) * width + window.x) * 4,
                        static_cast<std::size_t>(window.width) * 4);
        }
        return;
    }
    std::vector<Taps> columns;
    columns.reserve(window.width);
    for (std::uint32_t x = 0; x < window.width; ++x)
        columns.push_back(find_taps(window.x + x, width, window.whole_width, nearest));
    for (std::uint32_t y = 0; y < window.height; ++y) {
        const Taps rows = find_taps(window.y + y, height, window.whole_height, nearest);
        for (std::uint32_t x = 0; x < window.width; ++x) {
            double weighted[3] = {0, 0, 0};
            double plain[3] = {0, 0, 0};
            double alpha = 0;
            for (std::size_t j = 0; j < rows.weights.size(); ++j) {
                const std::uint8_t* row = rgba + (static_cast<std::size_t>(rows.first) + j) * width * 4;
                for (std::size_t i = 0; i < columns[x].weights.size(); ++i) {
                    const std::uint8_t* pixel = row + (columns[x].first + i) * 4;
                    const double weight = rows.weights[j] * columns[x].weights[i];
                    for (int c = 0; c < 3; ++c) {
                        weighted[c] += weight * pixel[3] * pixel[c];
                        plain[c] += weight * pixel[c];
                    }
                    alpha += weight * pixel[3];
                }
            }
            std::uint8_t* to = out + (static_cast<std::size_t>(y) * window.width + x) * 4;
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<std::uint8_t>((alpha > 0.0 ? weighted[c] / alpha : plain[c]) + 0.5);
            to[3] = static_cast<std::uint8_t>(alpha + 0.5);
        }
    }
}

}  // namespace txc
