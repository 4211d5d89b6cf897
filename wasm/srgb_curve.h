// The sRGB transfer functions (IEC 61966-2-1) on four lanes, for blending in linear light.
//
// A backdrop is no byte but a float between bytes, so a table would need interpolation; roots that IEEE 754 fixes to the
// last bit and a short polynomial say the same in half the operations, alike on every machine. The coefficients
// interpolate the curve at Chebyshev nodes. Both ends are exact: 0 and 1 lead to 0 and 1.
#pragma once

#include "float4.h"

namespace txc {

/// Lanes from 0 to 1. Relative error below 3e-6.
inline Float4 srgb_to_linear(Float4 encoded) {
    // base^2.4 = base^2 * root^1.6, root = base^(1/4): where the result is small its error is, too.
    const Float4 base = splat(1.0f) + (encoded - splat(1.0f)) * splat(1.0f / 1.055f);
    const Float4 t = square_root(square_root(base)) - splat(1.0f);
    Float4 slope = splat(0.016790982f);
    slope = slope * t + splat(-0.0041415952f);
    slope = slope * t + splat(0.024096364f);
    slope = slope * t + splat(-0.063811556f);
    slope = slope * t + splat(0.48000747f);
    slope = slope * t + splat(1.6f);
    return select(encoded <= splat(0.04045f), encoded * splat(1.0f / 12.92f), base * base * (splat(1.0f) + slope * t));
}

/// Lanes from 0 to 1. Error below 1e-6.
inline Float4 linear_to_srgb(Float4 linear) {
    // 1.055 * root^(5/3) - 0.055, root = linear^(1/4).
    const Float4 t = square_root(square_root(linear)) - splat(1.0f);
    Float4 slope = splat(0.052865971f);
    slope = slope * t + splat(0.093450896f);
    slope = slope * t + splat(0.083289228f);
    slope = slope * t + splat(0.021440784f);
    slope = slope * t + splat(0.028352346f);
    slope = slope * t + splat(-0.0644578f);
    slope = slope * t + splat(0.5861359f);
    slope = slope * t + splat(1.7583334f);
    return select(linear <= splat(0.0031308f), linear * splat(12.92f), splat(1.0f) + slope * t);
}

}  // namespace txc
