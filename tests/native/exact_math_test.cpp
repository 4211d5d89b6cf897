// The transcendental functions that results depend on (spec section 7).
#include "exact_math.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/random.h"
#include "support/shapes.h"

using support::kPi;

TEST_CASE("Sine and cosine agree with the platform's within 1e-12") {
    support::Random random(10);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        // A whole turn densely, and arguments that need many turns taken off.
        const double radians = random.between(-7.0, 7.0) * (i % 2 == 0 ? 1.0 : 100.0);
        double sine = 0.0;
        double cosine = 0.0;
        txc::exact_sin_cos(radians, sine, cosine);
        worst = std::fmax(worst, std::fabs(sine - std::sin(radians)));
        worst = std::fmax(worst, std::fabs(cosine - std::cos(radians)));
    }
    CHECK(worst < 1e-12);
}

TEST_CASE("Quarter turns have the sines and cosines of a clock face") {
    for (int quarter = -8; quarter <= 8; ++quarter) {
        double sine = 2.0;
        double cosine = 2.0;
        txc::exact_sin_cos(quarter * kPi / 2, sine, cosine);
        const int turn = ((quarter % 4) + 4) % 4;
        CHECK(std::fabs(sine - (turn == 1 ? 1.0 : turn == 3 ? -1.0 : 0.0)) < 1e-15);
        CHECK(std::fabs(cosine - (turn == 0 ? 1.0 : turn == 2 ? -1.0 : 0.0)) < 1e-15);
    }
}

TEST_CASE("The cosine of degrees is exact at both ends and falls between them") {
    CHECK(txc::exact_cos_degrees(0.0) == 1.0);
    CHECK(txc::exact_cos_degrees(90.0) == 0.0);
    double before = 1.0;
    double worst = 0.0;
    for (int step = 1; step <= 9000; ++step) {
        const double degrees = step / 100.0;
        const double cosine = txc::exact_cos_degrees(degrees);
        CHECK_UNARY(cosine < before);
        worst = std::fmax(worst, std::fabs(cosine - std::cos(degrees * kPi / 180.0)));
        before = cosine;
    }
    CHECK(worst < 1e-12);
}

TEST_CASE("The angle of a point agrees with the platform's all the way round, near the axes and far out") {
    support::Random random(11);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double scale = std::pow(10.0, random.between(-30, 30));
        double x = random.between(-1, 1) * scale;
        double y = random.between(-1, 1) * scale;
        if (i % 5 == 0) x *= 1e-9;
        if (i % 7 == 0) y *= 1e-17;
        if (i % 11 == 0) y = x * (random.coin() ? 1 : -1);
        worst = std::fmax(worst, std::fabs(txc::exact_atan2(y, x) - std::atan2(y, x)));
    }
    CHECK(worst < 1e-15);
}

TEST_CASE("The angles of the eight winds are exact, and the back has one sign") {
    CHECK(txc::exact_atan2(0.0, 3.0) == 0.0);
    CHECK(txc::exact_atan2(3.0, 3.0) == kPi / 4);
    CHECK(txc::exact_atan2(3.0, 0.0) == kPi / 2);
    CHECK(txc::exact_atan2(3.0, -3.0) == 3 * kPi / 4);
    CHECK(txc::exact_atan2(0.0, -3.0) == kPi);
    CHECK(txc::exact_atan2(-0.0, -3.0) == kPi);
    CHECK(txc::exact_atan2(-3.0, -0.0) == -kPi / 2);
    CHECK(txc::exact_atan2(-3.0, -3.0) == -3 * kPi / 4);
    CHECK(txc::exact_atan2(0.0, 0.0) == 0.0);
}

TEST_CASE("The sRGB curves agree with the standard's powers within 1e-12") {
    double worst = 0.0;
    for (int step = 0; step <= 10000; ++step) {
        const double value = step / 10000.0;
        const double linear = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        const double encoded = value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
        worst = std::fmax(worst, std::fabs(txc::srgb_to_linear(value) - linear));
        worst = std::fmax(worst, std::fabs(txc::linear_to_srgb(value) - encoded));
    }
    CHECK(worst < 1e-12);
}

TEST_CASE("Every byte comes back from linear light as it went in") {
    for (int byte = 0; byte < 256; ++byte)
        CHECK(txc::to_byte(txc::linear_to_srgb(txc::srgb_to_linear(byte / 255.0))) == byte);
}

TEST_CASE("A unit value goes to its nearest byte, and what lies outside to the ends") {
    CHECK(txc::to_byte(0.0) == 0);
    CHECK(txc::to_byte(1.0) == 255);
    CHECK(txc::to_byte(0.49 / 255) == 0);
    CHECK(txc::to_byte(0.51 / 255) == 1);
    CHECK(txc::to_byte(254.49 / 255) == 254);
    CHECK(txc::to_byte(-3.0) == 0);
    CHECK(txc::to_byte(7.0) == 255);
    CHECK(txc::to_byte(std::nan("")) == 0);
}
