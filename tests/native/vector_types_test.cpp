// What four floats and two texels do as one (float4.h, short8.h), lane by lane: WebAssembly's instructions and the native
// build's loops are two ways to write it, and must give one result (spec section 7).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>

#include "short8.h"

using namespace txc;

namespace {

constexpr std::int32_t kLeast = -32768;
constexpr std::int32_t kMost = 32767;

/// Numbers where rounding and clamping turn, in lanes that differ from each other.
constexpr std::int32_t kTurns[] = {kLeast, kLeast + 1, -16385, -16384, -3,    -2,    -1,   0,
                                   1,      2,          3,      16383,  16384, 16385, kMost};

Short8 lanes_of(std::size_t first) {
    Short8 lanes{};
    for (std::size_t c = 0; c < 8; ++c)
        lanes[c] = static_cast<std::int16_t>(kTurns[(first + c * 2) % std::size(kTurns)]);
    return lanes;
}

}  // namespace

TEST_CASE("The part of a channel is rounded to the nearest, halves up, in each lane by its own share") {
    for (std::size_t i = 0; i < std::size(kTurns); ++i) {
        const Short8 values = lanes_of(i);
        for (const std::int32_t share : {1, 2, 6554, 10923, 16384, kMost}) {
            const Short8 parts = part_of(values, static_cast<std::int16_t>(share));
            for (std::size_t c = 0; c < 8; ++c) CHECK(parts[c] == std::floor(values[c] * share / 32768.0 + 0.5));
        }
        const Short8 shares = {0, 1, 6554, 16384, kMost, 10923, 3, 2};
        const Short8 parts = part_of(values, shares);
        for (std::size_t c = 0; c < 8; ++c) CHECK(parts[c] == std::floor(values[c] * shares[c] / 32768.0 + 0.5));
    }
}

TEST_CASE(
    "A sum of channels stops at the ends of the range, and a difference beyond them is told in whichever lane it is") {
    for (std::size_t i = 0; i < std::size(kTurns); ++i) {
        for (std::size_t k = 0; k < std::size(kTurns); ++k) {
            const Short8 a = lanes_of(i);
            const Short8 b = lanes_of(k);
            const Short8 sum = add_clamped(a, b);
            for (std::size_t c = 0; c < 8; ++c) {
                CHECK(sum[c] == std::min(std::max(a[c] + b[c], kLeast), kMost));
                Short8 from{};
                Short8 less{};
                from[c] = a[c];
                less[c] = b[c];
                Short8 overflow{};
                const Short8 difference = subtract(from, less, overflow);
                const int exact = a[c] - b[c];
                CHECK(any_lane(overflow) == (exact < kLeast || exact > kMost));
                CHECK(difference[c] == static_cast<std::int16_t>(exact));
            }
        }
    }
}

TEST_CASE("A difference that did not fit is still told after one that does") {
    Short8 overflow{};
    subtract(Short8{kMost}, Short8{-1}, overflow);
    subtract(Short8{1}, Short8{1}, overflow);
    CHECK(any_lane(overflow));
}

TEST_CASE("Places are rounded to the nearest, halves to even, or downwards, in every lane") {
    const float values[] = {-2.5f, -1.5f, -0.5f, 0.5f, 1.5f, 2.5f, -1.25f, 1.75f};
    for (std::size_t i = 0; i < std::size(values); ++i) {
        Float4 lanes{};
        for (std::size_t c = 0; c < 4; ++c) lanes[c] = values[(i + c) % std::size(values)];
        const Int4 nearest = round_to_int(lanes);
        const Int4 below = floor_to_int(lanes);
        for (std::size_t c = 0; c < 4; ++c) {
            CHECK(nearest[c] == std::nearbyint(lanes[c]));
            CHECK(below[c] == std::floor(lanes[c]));
        }
    }
}

TEST_CASE("Colours are stored to the nearest, halves up, and what is beyond full as full") {
    std::uint8_t bytes[4];
    store_rounded_bytes4(bytes, Float4{0.5f, 1.49f, 254.5f, 300.0f});
    CHECK(bytes[0] == 1);
    CHECK(bytes[1] == 1);
    CHECK(bytes[2] == 255);
    CHECK(bytes[3] == 255);
    std::uint16_t words[8];
    store_rounded_ushort4(words, Float4{0.5f, 1.49f, 40000.5f, 65535.0f});
    CHECK(words[0] == 1);
    CHECK(words[1] == 1);
    CHECK(words[2] == 40001);
    CHECK(words[3] == 65535);
    store_ushort8(words, Int4{-1, 0, 65535, 65536}, Int4{32767, 32768, -70000, 70000});
    const std::uint16_t expected[] = {0, 0, 65535, 65535, 32767, 32768, 0, 65535};
    for (std::size_t c = 0; c < 8; ++c) CHECK(words[c] == expected[c]);
}

TEST_CASE(
    "Of two of which none is less the first is the lesser and the greater, be it a zero of either sign or no number") {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const Float4 a = {0.0f, -0.0f, none, 1.0f};
    const Float4 b = {-0.0f, 0.0f, 1.0f, none};
    for (const Float4& chosen : {lesser(a, b), greater(a, b)}) {
        CHECK_FALSE(std::signbit(chosen[0]));
        CHECK(std::signbit(chosen[1]));
        CHECK(std::isnan(chosen[2]));
        CHECK(chosen[3] == 1.0f);
    }
}

TEST_CASE("Lanes are moved, taken away and multiplied with their signs") {
    const Float4 moved = move_down(Float4{1, 2, 3, 4});
    for (std::size_t c = 0; c < 4; ++c) CHECK(moved[c] == static_cast<float>((c + 1) % 4 + 1));
    CHECK(load_vec3({1.0f, 2.0f, 3.0f})[3] == 0.0f);
    std::int16_t shorts[] = {kLeast, -5, 5, kMost};
    subtract_short4(shorts, Int4{-7, -3, 9, kMost});
    const std::int16_t expected[] = {kLeast + 7, -2, -4, 0};
    for (std::size_t c = 0; c < 4; ++c) CHECK(shorts[c] == expected[c]);
    const auto halves = [](std::int32_t low, std::int32_t high) {
        return splat(static_cast<std::int32_t>(static_cast<std::uint32_t>(high) << 16) | (low & 0xffff));
    };
    CHECK(dot_halves(halves(-3, 5), halves(7, -11))[3] == -3 * 7 + 5 * -11);
}
