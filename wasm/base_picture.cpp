#include "base_picture.h"

#include <algorithm>
#include <cstring>

#include "float4.h"

namespace txc {
namespace {

/// Of each output row or column in turn its first source pixel, and the weights of the pixels from there on. They add up
/// to 1; zeros after them make their number the same for all, and even.
struct Axis {
    std::uint32_t taps;
    std::vector<std::uint32_t> first;
    std::vector<float> weights;
};

Axis find_taps(std::uint32_t begin_index, std::uint32_t count, std::uint32_t size, std::uint32_t out_size,
               bool nearest) {
    const double step = static_cast<double>(size) / out_size;
    const double last = static_cast<double>(size - 1);
    const bool shrinks = !nearest && out_size < size;
    Axis axis{shrinks ? (static_cast<std::uint32_t>(step) + 3) & ~1u : 2, std::vector<std::uint32_t>(count), {}};
    axis.weights.resize(std::size_t{count} * axis.taps);
    float* weights = axis.weights.data();
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t index = begin_index + i;
        const double begin =
            shrinks ? index * step : std::clamp((index + 0.5) * step - (nearest ? 0.0 : 0.5), 0.0, last);
        const auto first = static_cast<std::uint32_t>(begin);
        axis.first[i] = first;
        if (shrinks) {
            const double end = std::min(begin + step, static_cast<double>(size));
            for (std::uint32_t pixel = first; pixel < end; ++pixel) {
                const double share = std::min(end, pixel + 1.0) - std::max(begin, static_cast<double>(pixel));
                weights[pixel - first] = static_cast<float>(share / (end - begin));
            }
        } else {
            const double fraction = nearest ? 0.0 : begin - first;
            weights[0] = static_cast<float>(1.0 - fraction);
            weights[1] = static_cast<float>(fraction);
        }
        weights += axis.taps;
    }
    return axis;
}

/// Colour times alpha, and alpha, times the weight. A pixel without alpha has a trace of it, too faint to be seen beside
/// any other, so that where all are without, the mean keeps their colour.
Float4 weighted(const std::uint8_t* pixel, Float4 weight) {
    Float4 color = load_bytes4(pixel);
    const Float4 alpha = greater(splat(color[3]), splat(0x1p-60f));
    color[3] = 1.0f;
    return color * alpha * weight;
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
    const Axis rows = find_taps(window.y, window.height, height, window.whole_height, nearest);
    const Axis columns = find_taps(window.x, window.width, width, window.whole_width, nearest);
    const std::uint32_t left = columns.first.front();
    std::vector<Float4> mixed(columns.first.back() + columns.taps - left);
    const std::size_t mixed_width = std::min<std::size_t>(mixed.size(), width - left);
    for (std::uint32_t y = 0; y < window.height; ++y) {
        std::fill(mixed.begin(), mixed.end(), splat(0.0f));
        const float* row_weights = &rows.weights[std::size_t{y} * rows.taps];
        for (std::uint32_t i = 0; i < rows.taps && row_weights[i] > 0.0f; i += 2) {
            const std::uint32_t row = rows.first[y] + i;
            const std::uint8_t* upper = rgba + (std::size_t{row} * width + left) * 4;
            const std::uint8_t* lower = row + 1 < height ? upper + std::size_t{width} * 4 : upper;
            const Float4 upper_weight = splat(row_weights[i]);
            const Float4 lower_weight = splat(row_weights[i + 1]);
            for (std::size_t x = 0; x < mixed_width; ++x)
                mixed[x] += weighted(upper + x * 4, upper_weight) + weighted(lower + x * 4, lower_weight);
        }
        const float* weights = columns.weights.data();
        const std::uint32_t taps = columns.taps;
        for (const std::uint32_t first : columns.first) {
            const Float4* from = &mixed[first - left];
            Float4 sum = splat(0.0f);
            for (const float* end = weights + taps; weights < end; weights += 2) {
                sum += from[0] * splat(weights[0]) + from[1] * splat(weights[1]);
                from += 2;
            }
            Float4 color = sum / splat(sum[3]);
            color[3] = sum[3];
            store_rounded_bytes4(out, color);
            out += 4;
        }
    }
}

}  // namespace txc
