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

std::int32_t largest_second_difference(const PyramidLevel& level, std::uint32_t x, std::uint32_t y) {
    const std::uint16_t* at = level.pixel(x, y);
    const std::uint16_t* right = x + 1 < level.width ? at + 4 : nullptr;
    const std::uint16_t* below = y + 1 < level.height ? level.pixel(x, y + 1) : nullptr;
    std::int32_t largest = 0;
    for (int c = 0; c < 4; ++c) {
        if (right != nullptr && x > 0) largest = std::max(largest, std::abs(at[c - 4] - 2 * at[c] + right[c]));
        if (below != nullptr && y > 0) {
            largest = std::max(largest, std::abs(level.pixel(x, y - 1)[c] - 2 * at[c] + below[c]));
        }
        if (right != nullptr && below != nullptr) {
            largest = std::max(largest, std::abs(at[c] - right[c] - below[c] + below[c + 4]));
        }
    }
    return largest;
}

/// The largest of the values at most kRoughnessReach away along one axis; `stride` apart, `count` of them.
std::uint8_t largest_near(const std::uint8_t* values, std::uint32_t at, std::uint32_t count, std::size_t stride) {
    std::uint8_t largest = 0;
    const std::uint32_t last = std::min(at + kRoughnessReach, count - 1);
    for (std::uint32_t i = at > kRoughnessReach ? at - kRoughnessReach : 0; i <= last; ++i) {
        largest = std::max(largest, values[i * stride]);
    }
    return largest;
}

void measure_roughness(PyramidLevel& level) {
    constexpr std::int32_t kStep = 255;  // an 8-bit step on the scale of kFullScale
    const std::size_t pixels = static_cast<std::size_t>(level.width) * level.height;
    level.roughness.resize(pixels);
    std::vector<std::uint8_t> along_rows(pixels);
    for (std::uint32_t y = 0; y < level.height; ++y) {
        for (std::uint32_t x = 0; x < level.width; ++x) {
            const std::int32_t steps = (largest_second_difference(level, x, y) + kStep - 1) / kStep;
            level.roughness[static_cast<std::size_t>(y) * level.width + x] =
                static_cast<std::uint8_t>(std::min(steps, 255));
        }
    }
    for (std::uint32_t y = 0; y < level.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * level.width;
        for (std::uint32_t x = 0; x < level.width; ++x)
            along_rows[row + x] = largest_near(level.roughness.data() + row, x, level.width, 1);
    }
    for (std::uint32_t y = 0; y < level.height; ++y) {
        for (std::uint32_t x = 0; x < level.width; ++x) {
            level.roughness[static_cast<std::size_t>(y) * level.width + x] =
                largest_near(along_rows.data() + x, y, level.height, level.width);
        }
    }
}

}  // namespace

TxcStatus ImagePyramid::build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(width) * height;
    if (const TxcStatus status = share.resize(pixels * (8 + 2) * 4 / 3 + 4096, "the decal's picture");
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
