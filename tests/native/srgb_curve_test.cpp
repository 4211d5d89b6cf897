// The transfer functions on four lanes, and the way of texels between bytes and floats.
#include "srgb_curve.h"

#include <doctest/doctest.h>

#include <cmath>

#include "exact_math.h"
#include "texel_bytes.h"

namespace {

float decode(float value) { return txc::srgb_to_linear(txc::splat(value))[0]; }
float encode(float value) { return txc::linear_to_srgb(txc::splat(value))[0]; }

}  // namespace

TEST_CASE("The curves on four lanes agree with the exact ones") {
    double worst_decoded = 0;  // in proportion: what is dark is magnified on the way back
    double worst_encoded = 0;
    for (int step = 1; step <= 100000; ++step) {
        const auto value = static_cast<float>(step / 100000.0);
        const double linear = txc::srgb_to_linear(static_cast<double>(value));
        const double encoded = txc::linear_to_srgb(static_cast<double>(value));
        worst_decoded = std::fmax(worst_decoded, std::fabs(static_cast<double>(decode(value)) / linear - 1));
        worst_encoded = std::fmax(worst_encoded, std::fabs(static_cast<double>(encode(value)) - encoded));
    }
    CHECK(worst_decoded < 3e-6);
    CHECK(worst_encoded < 1e-6);
}

TEST_CASE("Black and white come through the curves to the last bit") {
    CHECK(decode(0.0f) == 0.0f);
    CHECK(decode(1.0f) == 1.0f);
    CHECK(encode(0.0f) == 0.0f);
    CHECK(encode(1.0f) == 1.0f);
}

TEST_CASE("Every byte comes back from linear light within a hundredth of a step") {
    double worst = 0;
    for (int byte = 0; byte < 256; ++byte) {
        const float back = encode(decode(static_cast<float>(byte) / 255.0f)) * 255.0f;
        worst = std::fmax(worst, std::fabs(static_cast<double>(back) - byte));
    }
    CHECK(worst < 0.01);
}

TEST_CASE("Texels go from bytes to floats and back unchanged, and round halves up") {
    for (int first = 0; first < 256; first += 16) {
        txc::Byte16 bytes{};
        for (int i = 0; i < 16; ++i) bytes[i] = static_cast<std::uint8_t>(first + i);
        txc::Float4 texels[4];
        txc::unpack_texels(bytes, texels);
        const float blue = texels[1][2];
        CHECK(blue == static_cast<float>(first + 6));
        CHECK_UNARY(!txc::any_byte(txc::pack_texels(texels) ^ bytes));
        for (txc::Float4& texel : texels) texel = texel - txc::splat(0.5f);
        if (first > 0) CHECK_UNARY(!txc::any_byte(txc::pack_texels(texels) ^ bytes));
        for (txc::Float4& texel : texels) texel = texel + txc::splat(0.999f);
        if (first < 240) CHECK_UNARY(!txc::any_byte(txc::pack_texels(texels) ^ bytes));
    }
    // What rounding leaves beyond both ends.
    const txc::Float4 ends[4] = {txc::splat(-1e-4f), txc::splat(255.0001f), txc::splat(0.499f), txc::splat(254.501f)};
    const txc::Byte16 packed = txc::pack_texels(ends);
    const int bytes[4] = {packed[0], packed[4], packed[8], packed[12]};
    CHECK(bytes[0] == 0);
    CHECK(bytes[1] == 255);
    CHECK(bytes[2] == 0);
    CHECK(bytes[3] == 255);
}
