#include "round_tips.h"

#include <cmath>

namespace txc {
namespace {

constexpr std::uint32_t kSamples = 8;  // along a side of a pixel

// So many pixels a texel, and a fixed number more, as the rim of a small dab is most of it: a pixel of the rim is blurred
// over itself and its neighbours, which must be little beside a texel. With 1.25 pixels a texel, and up to half as many
// more, dabs of 9 to 20 texels came to 26 dB of their own disc, where spec.md asks 40 of any picture.
constexpr double kPixelsPerTexel = 2.0;
constexpr double kRimPixels = 32.0;

/// Alpha at a distance from the centre, in radii: 1 on the solid part, 0 from the rim on, and between the two the cubic
/// that leaves and arrives level (Hermite's smoothstep), so that neither end shows as a line.
double alpha_at(double distance, double hardness) {
    if (distance >= 1.0) return 0.0;
    if (distance <= hardness) return 1.0;
    const double t = (distance - hardness) / (1.0 - hardness);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

/// The mean over one pixel, column and row counted from the centre of a tip of 2 * `half` pixels.
std::uint8_t pixel_alpha(std::uint32_t column, std::uint32_t row, std::uint32_t half, double hardness) {
    // Samples lie at odd sixteenths of a pixel, so squared distances are whole numbers and symmetry is exact.
    constexpr std::uint32_t kStep = 2 * kSamples;
    double sum = 0.0;
    for (std::uint32_t j = 0; j < kSamples; ++j) {
        const std::uint64_t y = row * kStep + 2 * j + 1;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
            const std::uint64_t x = column * kStep + 2 * i + 1;
            sum += alpha_at(std::sqrt(static_cast<double>(x * x + y * y)) / (half * kStep), hardness);
        }
    }
    return static_cast<std::uint8_t>(sum * (255.0 / (kSamples * kSamples)) + 0.5);
}

std::vector<std::uint8_t> draw_tip(std::uint32_t size, double hardness) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(size) * size * 4, 255);
    const std::uint32_t half = size / 2;
    // One eighth of the disc, and its mirror images.
    for (std::uint32_t row = 0; row < half; ++row) {
        for (std::uint32_t column = row; column < half; ++column) {
            const std::uint8_t alpha = pixel_alpha(column, row, half, hardness);
            const auto mirror = [&](std::uint32_t x, std::uint32_t y) {
                for (const std::uint32_t px : {half + x, half - 1 - x}) {
                    for (const std::uint32_t py : {half + y, half - 1 - y})
                        rgba[(static_cast<std::size_t>(py) * size + px) * 4 + 3] = alpha;
                }
            };
            mirror(column, row);
            mirror(row, column);
        }
    }
    return rgba;
}

}  // namespace

RoundTips::~RoundTips() = default;

TxcStatus RoundTips::find(double texels_across, const ImagePyramid*& out_picture) {
    std::size_t place = 0;
    while (place + 1 < kSizeCount && kSizes[place] < texels_across * kPixelsPerTexel + kRimPixels) ++place;
    if (pictures_[place] == nullptr) {
        const std::uint32_t size = kSizes[place];
        BudgetShare drawing(budget_);
        if (const TxcStatus status = drawing.resize(std::uint64_t{size} * size * 4, "a brush's tip");
            status != TXC_STATUS_OK)
            return status;
        auto picture = std::make_unique<ImagePyramid>(budget_);
        const std::vector<std::uint8_t> rgba = draw_tip(size, static_cast<double>(hardness_));
        if (const TxcStatus status = picture->build(size, size, rgba.data()); status != TXC_STATUS_OK) return status;
        pictures_[place] = std::move(picture);
    }
    out_picture = pictures_[place].get();
    return TXC_STATUS_OK;
}

}  // namespace txc
