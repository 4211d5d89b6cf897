// The few transcendental functions that results depend on, built from + - * / and sqrt alone: IEEE 754 fixes those to
// the last bit, while every platform's libm rounds in its own way (spec section 7).
#pragma once

#include <cstdint>

namespace txc {

/// Sine and cosine of an angle in radians; |radians| up to 1e6. Error below 1e-15.
void exact_sin_cos(double radians, double& sine, double& cosine);

/// Cosine of an angle in degrees, 0 to 90; exact at both ends.
double exact_cos_degrees(double degrees);

/// The angle of the point (x, y) from the X axis towards the Y axis, radians, above -pi and up to pi; 0 at the origin.
/// Zeros have no sign: (-1, -0) is at pi. Error below 1e-15.
double exact_atan2(double y, double x);

/// The sRGB transfer functions (IEC 61966-2-1) on 0 to 1.
double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);

/// Nearest 8-bit step of a value from 0 to 1 (values outside are clamped).
std::uint8_t to_byte(double unit);

}  // namespace txc
