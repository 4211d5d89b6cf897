#include "round_tip.h"

#include <cmath>

namespace txc {
namespace {

constexpr std::uint32_t kSamples = 8;  // along a side of a pixel
constexpr std::uint32_t kHalf = kRoundTipSize / 2;

/// Alpha at a distance from the centre, in radii: 1 on the solid part, 0 from the rim on, and between the two the cubic
/// that leaves and arrives level (Hermite's smoothstep), so that neither end shows as a line.
double alpha_at(double distance, double hardness) {
    if (distance >= 1.0) return 0.0;
    if (distance <= hardness) return 1.0;
    const double t = (distance - hardness) / (1.0 - hardness);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

/// The mean over one pixel, column and row counted from the centre.
std::uint8_t pixel_alpha(std::uint32_t column, std::uint32_t row, double hardness) {
    // Samples lie at odd sixteenths of a pixel, so squared distances are whole numbers and symmetry is exact.
    constexpr std::uint32_t kStep = 2 * kSamples;
    double sum = 0.0;
    for (std::uint32_t j = 0; j < kSamples; ++j) {
        const std::uint64_t y = row * kStep + 2 * j + 1;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
            const std::uint64_t x = column * kStep + 2 * i + 1;
            sum += alpha_at(std::sqrt(static_cast<double>(x * x + y * y)) / (kHalf * kStep), hardness);
        }
    }
    return static_cast<std::uint8_t>(sum * (255.0 / (kSamples * kSamples)) + 0.5);
}

}  // namespace

TxcStatus RoundTip::make(float of_hardness) {
    hardness = of_hardness;
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(kRoundTipSize) * kRoundTipSize * 4, 255);
    // One eighth of the disc, and its mirror images.
    for (std::uint32_t row = 0; row < kHalf; ++row) {
        for (std::uint32_t column = row; column < kHalf; ++column) {
            const std::uint8_t alpha = pixel_alpha(column, row, static_cast<double>(hardness));
            const auto mirror = [&](std::uint32_t x, std::uint32_t y) {
                for (const std::uint32_t px : {kHalf + x, kHalf - 1 - x}) {
                    for (const std::uint32_t py : {kHalf + y, kHalf - 1 - y})
                        rgba[(static_cast<std::size_t>(py) * kRoundTipSize + px) * 4 + 3] = alpha;
                }
            };
            mirror(column, row);
            mirror(row, column);
        }
    }
    return picture.build(kRoundTipSize, kRoundTipSize, rgba.data());
}

}  // namespace txc
