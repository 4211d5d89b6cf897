#include "footprint_kernel.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

/// The tent's integral up to x.
double tent_integral(double x) {
    const double at = std::min(std::max(x, -1.0), 1.0);
    return 0.5 + at - 0.5 * at * std::fabs(at);
}

/// tent * box of this width (its mean is 1), at a distance from the centre.
double kernel_at(double distance, double width) {
    if (width == 0.0) return std::max(0.0, 1.0 - std::fabs(distance));
    return (tent_integral(distance + 0.5 * width) - tent_integral(distance - 0.5 * width)) / width;
}

/// Whole weights that add up to `total`: the largest one takes what rounding left.
KernelTaps quantise(const double (&weights)[4], std::int32_t total) {
    KernelTaps taps{};
    std::int32_t left = total;
    int largest = 0;
    for (int i = 0; i < 4; ++i) {
        taps.weights[i] = static_cast<std::int16_t>(std::floor(weights[i] * kWeightOne + 0.5));
        left -= taps.weights[i];
        if (std::fabs(weights[i]) > std::fabs(weights[largest])) largest = i;
    }
    taps.weights[largest] = static_cast<std::int16_t>(taps.weights[largest] + left);
    return taps;
}

constexpr int kWidthsAPixel = 24;
constexpr int kWidths = 39;

/// The kernels of a box at every phase. The first of the four pixels stands one before the pixel that lies at or before
/// the centre.
struct KernelRow {
    KernelTaps kernels[kKernelPhases + 1];
    KernelTaps slopes[kKernelPhases + 1];
};

void make_row(double width, KernelRow& out) {
    for (int phase = 0; phase <= kKernelPhases; ++phase) {
        double kernel[4];
        double slope[4];
        for (int i = 0; i < 4; ++i) {
            const double distance = i - 1 - static_cast<double>(phase) / kKernelPhases;
            kernel[i] = kernel_at(distance, width);
            slope[i] = kernel_at(distance - 0.5, width) - kernel_at(distance + 0.5, width);
        }
        out.kernels[phase] = quantise(kernel, kWeightOne);
        out.slopes[phase] = quantise(slope, 0);
    }
}

/// Of the box that stands for the parallelogram's shadow on an axis, to the nearest 24th of a pixel (a twelfth costs 1 to 2 dB): the
/// same second moment, less what a box that is this wide blurs the finest pictures more than two narrower ones, one after the other.
/// Made when first asked for: a decal meets two or three.
const KernelRow& row_for(float across, float down) {
    static KernelRow rows[kWidths];
    static bool is_made[kWidths];
    constexpr float kBoxExcess = 0.1f;
    const float across_2 = across * across;
    const float down_2 = down * down;
    const float width = std::sqrt(across_2 + down_2 - kBoxExcess * across_2 * down_2);
    const int w = static_cast<int>(std::min(width * kWidthsAPixel + 0.5f, kWidths - 1.0f));
    if (!is_made[w]) {
        make_row(static_cast<double>(w) / kWidthsAPixel, rows[w]);
        is_made[w] = true;
    }
    return rows[w];
}

}  // namespace

FootprintKernel make_footprint_kernel(float across_x, float across_y, float down_x, float down_y) {
    const KernelRow& along_x = row_for(across_x, down_x);
    const KernelRow& along_y = row_for(across_y, down_y);
    // A step's difference for a slope falls short of it, the more the finer the picture: so much more of it stands closest to the
    // parallelogram's own weights (by least squares 1.5 to 1.7, whatever the parallelogram), 3 to 6 dB closer.
    constexpr float kSlopeOfStep = 1.6f;
    const float covariance = kSlopeOfStep * covariance_of(across_x, across_y, down_x, down_y);
    // Below this no picture shows it: the slopes' products are at most 1.
    constexpr float kLeast = 1.0f / 128.0f;
    return {along_x.kernels, along_y.kernels, along_x.slopes, along_y.slopes,
            std::fabs(covariance) < kLeast ? 0 : static_cast<std::int32_t>(covariance * kWeightOne)};
}

}  // namespace txc
