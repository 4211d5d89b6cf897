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
            std::uint16_t* out = coarse.pixel(x, y);
            for (int c = 0; c < 4; ++c) out[c] = static_cast<std::uint16_t>(sum[c] / area + 0.5);
        }
    }
}

/// How much four neighbouring pixels depart from a plane, in one channel.
std::int32_t mixed_difference(const std::uint16_t* at, std::size_t row) {
    return std::abs(at[0] - at[4] - at[row] + at[row + 4]);
}

/// Of the pixel at `at`, which has neighbours on all sides.
std::int32_t largest_second_difference(const std::uint16_t* at, std::size_t row) {
    std::int32_t largest = 0;
    for (int c = 0; c < 4; ++c, ++at) {
        largest = std::max(largest, std::abs(*(at - 4) - 2 * at[0] + at[4]));
        largest = std::max(largest, std::abs(*(at - row) - 2 * at[0] + at[row]));
        largest = std::max(largest, mixed_difference(at - row - 4, row));
        largest = std::max(largest, mixed_difference(at - row, row));
        largest = std::max(largest, mixed_difference(at - 4, row));
        largest = std::max(largest, mixed_difference(at, row));
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
    const auto width = static_cast<std::uint32_t>(level.stride());
    const std::uint32_t height = level.height + 2 * kPad;
    std::vector<std::uint8_t> values(level.padded_count());
    for (std::uint32_t y = 1; y + 1 < height; ++y) {
        for (std::uint32_t x = 1; x + 1 < width; ++x) {
            const std::size_t place = std::size_t{y} * width + x;
            const std::int32_t difference =
                largest_second_difference(level.rgba.data() + place * 4, std::size_t{width} * 4);
            values[place] = static_cast<std::uint8_t>(std::min((difference + kStep - 1) / kStep, 255));
        }
    }
    // A centre between two pixels' feels both up to a distance of 1, and one more on either side up to 2.
    for (int reach = 0; reach < kRoughnessReaches; ++reach) {
        spread(values, height, width, width, 1, reach > 0);
        spread(values, width, 1, height, width, reach > 0);
        level.roughness[reach] = values;
    }
}

}  // namespace

TxcStatus ImagePyramid::build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
    // Pixels, the lists of roughness and one to make them, of all levels.
    std::uint64_t bytes = 0;
    for (std::uint32_t w = width, h = height;; w = std::max(1u, w / 2), h = std::max(1u, h / 2)) {
        bytes += std::uint64_t{PyramidLevel::padded_count(w, h)} * (8 + kRoughnessReaches + 1);
        if (w == 1 && h == 1) break;
    }
    if (const TxcStatus status = share.resize(bytes, "the decal's picture"); status != TXC_STATUS_OK) return status;
    levels.assign(1, PyramidLevel{});
    levels[0].width = width;
    levels[0].height = height;
    levels[0].rgba.resize(levels[0].padded_count() * 4);
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint8_t* from = rgba + std::size_t{y} * width * 4;
        std::uint16_t* to = levels[0].pixel(0, y);
        for (std::uint32_t x = 0; x < width; ++x, from += 4, to += 4) {
            const std::uint32_t alpha = from[3];
            for (int c = 0; c < 3; ++c) to[c] = static_cast<std::uint16_t>(from[c] * alpha);
            to[3] = static_cast<std::uint16_t>(alpha * 255);
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        PyramidLevel coarse;
        coarse.width = std::max(1u, levels.back().width / 2);
        coarse.height = std::max(1u, levels.back().height / 2);
        coarse.scale_x = static_cast<float>(coarse.width) / static_cast<float>(width);
        coarse.scale_y = static_cast<float>(coarse.height) / static_cast<float>(height);
        coarse.rgba.resize(coarse.padded_count() * 4);
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
