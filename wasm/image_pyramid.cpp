#include "image_pyramid.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

TxcStatus ImagePyramid::build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(width) * height;
    if (const TxcStatus status = share.resize(pixels * 8 * 4 / 3 + 4096, "the decal's picture");
        status != TXC_STATUS_OK)
        return status;
    levels.assign(1, PyramidLevel{width, height, 1.0f, 1.0f, {}});
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
    return TXC_STATUS_OK;
}

void add_bilinear(const PyramidLevel& level, float x, float y, bool repeat, PyramidColor& sum) {
    static constexpr std::uint16_t kTransparent[4] = {0, 0, 0, 0};
    const float left = std::floor(x - 0.5f);
    const float top = std::floor(y - 0.5f);
    const float fx = x - 0.5f - left;
    const float fy = y - 0.5f - top;
    const auto w = static_cast<std::int32_t>(level.width);
    const auto h = static_cast<std::int32_t>(level.height);
    const auto x0 = static_cast<std::int32_t>(left);
    const auto y0 = static_cast<std::int32_t>(top);
    const std::uint16_t* p00;
    const std::uint16_t* p10;
    const std::uint16_t* p01;
    const std::uint16_t* p11;
    if (x0 >= 0 && y0 >= 0 && x0 + 1 < w && y0 + 1 < h) {
        p00 = level.pixel(static_cast<std::uint32_t>(x0), static_cast<std::uint32_t>(y0));
        p10 = p00 + 4;
        p01 = p00 + static_cast<std::size_t>(level.width) * 4;
        p11 = p01 + 4;
    } else {
        const auto pixel_or_transparent = [&](std::int32_t px, std::int32_t py) {
            if (!repeat && (px < 0 || py < 0 || px >= w || py >= h)) return &kTransparent[0];
            return level.pixel(static_cast<std::uint32_t>(wrap(px, w)), static_cast<std::uint32_t>(wrap(py, h)));
        };
        p00 = pixel_or_transparent(x0, y0);
        p10 = pixel_or_transparent(x0 + 1, y0);
        p01 = pixel_or_transparent(x0, y0 + 1);
        p11 = pixel_or_transparent(x0 + 1, y0 + 1);
    }
    const float w00 = (1.0f - fx) * (1.0f - fy);
    const float w10 = fx * (1.0f - fy);
    const float w01 = (1.0f - fx) * fy;
    const float w11 = fx * fy;
    for (int c = 0; c < 4; ++c) {
        sum.channel[c] += (static_cast<float>(p00[c]) * w00 + static_cast<float>(p10[c]) * w10) +
                          (static_cast<float>(p01[c]) * w01 + static_cast<float>(p11[c]) * w11);
    }
}

}  // namespace txc
