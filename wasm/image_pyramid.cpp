#include "image_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace txc {
namespace {

std::int32_t wrap(std::int32_t index, std::int32_t size) {
    const std::int32_t rest = index % size;
    return rest < 0 ? rest + size : rest;
}

// Area average of the finer level over each pixel of the coarser one. For odd sizes a pixel covers a little more than
// two, with fractions at its ends, so that no level is shifted against another.
void reduce(const PyramidLevel& fine, PyramidLevel& coarse) {
    const double step_x = static_cast<double>(fine.width) / coarse.width;
    const double step_y = static_cast<double>(fine.height) / coarse.height;
    for (std::uint32_t y = 0; y < coarse.height; ++y) {
        const double top = y * step_y;
        const double bottom = std::min((y + 1) * step_y, static_cast<double>(fine.height));
        for (std::uint32_t x = 0; x < coarse.width; ++x) {
            const double left = x * step_x;
            const double right = std::min((x + 1) * step_x, static_cast<double>(fine.width));
            double sum[4] = {0, 0, 0, 0};
            double area = 0;
            for (auto fy = static_cast<std::uint32_t>(top); fy < bottom; ++fy) {
                const double high = std::min(bottom, fy + 1.0) - std::max(top, static_cast<double>(fy));
                for (auto fx = static_cast<std::uint32_t>(left); fx < right; ++fx) {
                    const double weight = high * (std::min(right, fx + 1.0) - std::max(left, static_cast<double>(fx)));
                    const std::uint16_t* pixel = fine.pixel(fx, fy);
                    for (int c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
                    area += weight;
                }
            }
            std::uint16_t* out = coarse.rgba.data() + (static_cast<std::size_t>(y) * coarse.width + x) * 4;
            for (int c = 0; c < 4; ++c) out[c] = static_cast<std::uint16_t>(sum[c] / area + 0.5);
        }
    }
}

/// How much the four pixels from (x, y) on depart from a plane, 0 where they do not all exist.
std::int32_t mixed_difference(const PyramidLevel& level, std::int64_t x, std::int64_t y, int c) {
    if (x < 0 || y < 0 || x + 1 >= level.width || y + 1 >= level.height) return 0;
    const std::uint16_t* at = level.pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) + c;
    const std::uint16_t* below = at + static_cast<std::size_t>(level.width) * 4;
    return std::abs(at[0] - at[4] - below[0] + below[4]);
}

std::int32_t largest_second_difference(const PyramidLevel& level, std::uint32_t x, std::uint32_t y) {
    const std::uint16_t* at = level.pixel(x, y);
    const std::size_t row = static_cast<std::size_t>(level.width) * 4;
    std::int32_t largest = 0;
    for (int c = 0; c < 4; ++c) {
        if (x > 0 && x + 1 < level.width) largest = std::max(largest, std::abs(at[c - 4] - 2 * at[c] + at[c + 4]));
        if (y > 0 && y + 1 < level.height) {
            largest = std::max(largest, std::abs(*(at + c - row) - 2 * at[c] + *(at + c + row)));
        }
        for (const std::int64_t left : {static_cast<std::int64_t>(x) - 1, static_cast<std::int64_t>(x)}) {
            for (const std::int64_t top : {static_cast<std::int64_t>(y) - 1, static_cast<std::int64_t>(y)}) {
                largest = std::max(largest, mixed_difference(level, left, top, c));
            }
        }
    }
    return largest;
}

/// The largest of each value, the one after it, and with `before` the one before it, `stride` apart, along lines.
void spread(std::vector<std::uint8_t>& values, std::uint32_t lines, std::size_t line_stride, std::uint32_t count,
            std::size_t stride, bool with_before) {
    for (std::uint32_t line = 0; line < lines; ++line) {
        std::uint8_t* at = values.data() + line * line_stride;
        std::uint8_t before = 0;
        for (std::uint32_t i = 0; i < count; ++i, at += stride) {
            const std::uint8_t own = *at;
            const std::uint8_t after = i + 1 < count ? at[stride] : std::uint8_t{0};
            *at = std::max(own, std::max(before, after));
            if (with_before) before = own;
        }
    }
}

void measure_roughness(PyramidLevel& level) {
    constexpr std::int32_t kStep = 255;  // an 8-bit step on the scale of kFullScale
    std::vector<std::uint8_t> values(static_cast<std::size_t>(level.width) * level.height);
    for (std::uint32_t y = 0; y < level.height; ++y) {
        for (std::uint32_t x = 0; x < level.width; ++x) {
            const std::int32_t steps = (largest_second_difference(level, x, y) + kStep - 1) / kStep;
            values[static_cast<std::size_t>(y) * level.width + x] = static_cast<std::uint8_t>(std::min(steps, 255));
        }
    }
    // A centre between two pixels' feels both up to a distance of 1, and one more on either side up to 2.
    for (int reach = 0; reach < kRoughnessReaches; ++reach) {
        spread(values, level.height, level.width, level.width, 1, reach > 0);
        spread(values, level.width, 1, level.height, level.width, reach > 0);
        level.roughness[reach] = values;
    }
}

}  // namespace

TxcStatus ImagePyramid::build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(width) * height;
    if (const TxcStatus status = share.resize(pixels * (8 + 3) * 4 / 3 + 4096, "the decal's picture");
        status != TXC_STATUS_OK)
        return status;
    levels.assign(1, PyramidLevel{width, height, 1.0f, 1.0f, {}, {}});
    levels[0].rgba.resize(static_cast<std::size_t>(pixels) * 4);
    for (std::size_t p = 0; p < pixels; ++p) {
        const std::uint32_t alpha = rgba[p * 4 + 3];
        for (std::size_t c = 0; c < 3; ++c)
            levels[0].rgba[p * 4 + c] = static_cast<std::uint16_t>(rgba[p * 4 + c] * alpha);
        levels[0].rgba[p * 4 + 3] = static_cast<std::uint16_t>(alpha * 255);
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        PyramidLevel coarse;
        coarse.width = std::max(1u, levels.back().width / 2);
        coarse.height = std::max(1u, levels.back().height / 2);
        coarse.scale_x = static_cast<float>(coarse.width) / static_cast<float>(width);
        coarse.scale_y = static_cast<float>(coarse.height) / static_cast<float>(height);
        coarse.rgba.resize(static_cast<std::size_t>(coarse.width) * coarse.height * 4);
        reduce(levels.back(), coarse);
        levels.push_back(std::move(coarse));
    }
    for (PyramidLevel& level : levels) measure_roughness(level);
    return TXC_STATUS_OK;
}

Float4 sample_bilinear(const PyramidLevel& level, float x, float y, bool repeat) {
    static constexpr std::uint16_t kTransparent[4] = {0, 0, 0, 0};
    const float left = std::floor(x - 0.5f);
    const float top = std::floor(y - 0.5f);
    const auto w = static_cast<std::int32_t>(level.width);
    const auto h = static_cast<std::int32_t>(level.height);
    const auto column = static_cast<std::int32_t>(left);
    const auto row = static_cast<std::int32_t>(top);
    const auto pixel = [&](std::int32_t px, std::int32_t py) {
        if (!repeat && (px < 0 || py < 0 || px >= w || py >= h)) return load_ushort4(kTransparent);
        return load_ushort4(
            level.pixel(static_cast<std::uint32_t>(wrap(px, w)), static_cast<std::uint32_t>(wrap(py, h))));
    };
    const Float4 fx = splat(x - 0.5f - left);
    const Float4 fy = splat(y - 0.5f - top);
    const Float4 upper_left = pixel(column, row);
    const Float4 lower_left = pixel(column, row + 1);
    const Float4 above = upper_left + (pixel(column + 1, row) - upper_left) * fx;
    const Float4 below = lower_left + (pixel(column + 1, row + 1) - lower_left) * fx;
    return above + (below - above) * fy;
}

}  // namespace txc
