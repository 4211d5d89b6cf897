// The words of details are printf's, letter for letter.
#include "detail_words.h"

#include <doctest/doctest.h>

#include <cfloat>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>

#include "support/random.h"

namespace {

std::string ours(double value) {
    char out[64];
    txc::write_words(out, sizeof out, "%g", value);
    return out;
}

std::string printfs(double value) {
    char out[64];
    std::snprintf(out, sizeof out, "%g", value);
    return out;
}

}  // namespace

TEST_CASE("Words, whole numbers and parts of words are written as printf writes them") {
    char out[200];
    char expected[200];
    const unsigned long long most = ULLONG_MAX;
    const std::size_t size = 40;
    txc::write_words(out, sizeof out, "%s[%u].%.3s is %d, %d of %zu, %llu%% %c", "nodes", 4000000000u, "translation",
                     INT_MIN, 17, size, most, 'x');
    std::snprintf(expected, sizeof expected, "%s[%u].%.3s is %d, %d of %zu, %llu%% %c", "nodes", 4000000000u,
                  "translation", INT_MIN, 17, size, most, 'x');
    CHECK(std::string(out) == expected);
}

TEST_CASE("What does not fit is left out") {
    char out[8];
    txc::write_words(out, sizeof out, "%s %u", "abcde", 123u);
    CHECK(std::string(out) == "abcde 1");
}

TEST_CASE("Numbers have the six digits that printf gives them") {
    for (const double value : {0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               0.5,
                               100000.0,
                               999999.0,
                               999999.4,
                               999999.5,
                               1e6,
                               123456.5,
                               1234565.0,
                               0.0001,
                               0.00012345678,
                               0.00009999996,
                               0.00001,
                               1e-5,
                               1e10,
                               1e100,
                               1e-100,
                               3.25e22,
                               static_cast<double>(FLT_MAX),
                               static_cast<double>(FLT_MIN),
                               DBL_MAX,
                               DBL_MIN,
                               5e-324,
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()}) {
        CHECK(ours(value) == printfs(value));
    }
    CHECK(ours(std::numeric_limits<double>::quiet_NaN()) == "nan");
    support::Random random(7);
    for (int i = 0; i < 20000; ++i) {
        // Any float; Emscripten 3.1.6 has no std::bit_cast.
        const std::uint32_t bits = random.next();
        float value = 0.0f;
        std::memcpy(&value, &bits, sizeof value);
        if (value != value) continue;
        CHECK(ours(static_cast<double>(value)) == printfs(static_cast<double>(value)));
        const double tame = static_cast<double>(random.below(2000000)) / 1000.0 - 1000.0;
        CHECK(ours(tame) == printfs(tame));
    }
}
