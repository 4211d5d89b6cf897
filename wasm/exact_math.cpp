#include "exact_math.h"

#include <cmath>

namespace txc {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Taylor series on [-pi/4, pi/4]: the first omitted term is below 1e-18.
double sine_near_zero(double x) {
    const double x2 = x * x;
    double term = x;
    double sum = x;
    for (int n = 1; n <= 9; ++n) {
        term = -term * x2 / static_cast<double>((2 * n) * (2 * n + 1));
        sum += term;
    }
    return sum;
}

double cosine_near_zero(double x) {
    const double x2 = x * x;
    double term = 1.0;
    double sum = 1.0;
    for (int n = 1; n <= 9; ++n) {
        term = -term * x2 / static_cast<double>((2 * n - 1) * (2 * n));
        sum += term;
    }
    return sum;
}

constexpr double kEighthAngles[9] = {0.0,
                                     0.12435499454676144,
                                     0.24497866312686414,
                                     0.35877067027057225,
                                     0.4636476090008061,
                                     0.5585993153435624,
                                     0.6435011087932844,
                                     0.7188299996216245,
                                     0.7853981633974483};

// The arc tangent of a value from 0 to 1: atan(t) = atan(c) + atan((t - c) / (1 + t c)) with c the nearest eighth, so
// that the Taylor series runs on [-1/16, 1/16], where the first omitted term is below 1e-20.
double arc_tangent_to_one(double t) {
    const int eighth = static_cast<int>(t * 8.0 + 0.5);
    const double c = eighth * 0.125;
    const double x = (t - c) / (1.0 + t * c);
    const double x2 = x * x;
    double sum = 0.0;
    for (int n = 7; n >= 0; --n) sum = 1.0 / (2 * n + 1) - x2 * sum;
    return kEighthAngles[eighth] + x * sum;
}

// The n-th root of a value in (0, 4] by Newton's method. It starts above the root and falls to it, so the loop ends.
double nth_root(double value, int n) {
    if (value <= 0.0) return 0.0;
    double root = value < 1.0 ? 1.0 : value;
    for (int step = 0; step < 200; ++step) {
        double power = 1.0;
        for (int i = 1; i < n; ++i) power *= root;
        const double next = root - (root - value / power) / n;
        if (!(next < root)) break;
        root = next;
    }
    return root;
}

}  // namespace

void exact_sin_cos(double radians, double& sine, double& cosine) {
    const double quarter = std::floor(radians / (kPi / 2) + 0.5);
    const double rest = radians - quarter * (kPi / 2);
    const double s = sine_near_zero(rest);
    const double c = cosine_near_zero(rest);
    const long long turn = static_cast<long long>(quarter) & 3;
    sine = turn == 0 ? s : turn == 1 ? c : turn == 2 ? -s : -c;
    cosine = turn == 0 ? c : turn == 1 ? -s : turn == 2 ? -c : s;
}

double exact_cos_degrees(double degrees) {
    if (degrees <= 45.0) return cosine_near_zero(degrees * (kPi / 180.0));
    return sine_near_zero((90.0 - degrees) * (kPi / 180.0));
}

double exact_atan2(double y, double x) {
    const double across = std::fabs(x);
    const double up = std::fabs(y);
    if (across == 0.0 && up == 0.0) return 0.0;
    double angle = up <= across ? arc_tangent_to_one(up / across) : kPi / 2 - arc_tangent_to_one(across / up);
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

double srgb_to_linear(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    const double base = (encoded + 0.055) / 1.055;
    const double fifth = nth_root(base, 5);
    return base * base * fifth * fifth;  // base^2.4
}

double linear_to_srgb(double linear) {
    if (linear <= 0.0031308) return linear * 12.92;
    const double twelfth = nth_root(linear, 12);
    const double squared = twelfth * twelfth;
    return 1.055 * (squared * squared * twelfth) - 0.055;  // linear^(5/12)
}

std::uint8_t to_byte(double unit) {
    if (!(unit > 0.0)) return 0;
    if (unit >= 1.0) return 255;
    return static_cast<std::uint8_t>(unit * 255.0 + 0.5);
}

}  // namespace txc
