// The bit a texel that the bake's raster and gutter work on.
#include "coverage_bits.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"

namespace {

bool is_set(const txc::CoverageBits& bits, std::uint32_t x, std::uint32_t y) {
    return (bits.row(y)[x / 64] >> (x % 64) & 1) != 0;
}

}  // namespace

TEST_CASE("A span is claimed whole where all its texels are free, and not at all where one is taken") {
    support::Random random(90);
    for (int round = 0; round < 300; ++round) {
        const std::uint32_t width = 1 + random.below(400);
        txc::CoverageBits bits(width, 1);
        std::vector<bool> expected(width, false);
        for (int i = 0; i < 20; ++i) {
            const std::uint32_t x = random.below(width);
            const std::uint32_t count = 1 + random.below(std::min(width - x, 1 + random.below(200)));
            bool free = true;
            for (std::uint32_t at = x; at < x + count; ++at) free = free && !expected[at];
            CAPTURE(x);
            CAPTURE(count);
            REQUIRE(bits.claim_span(x, 0, count) == free);
            for (std::uint32_t at = x; free && at < x + count; ++at) expected[at] = true;
            for (std::uint32_t at = 0; at < width; ++at) REQUIRE(is_set(bits, at, 0) == expected[at]);
        }
    }
}

TEST_CASE("A single texel is claimed once") {
    txc::CoverageBits bits(130, 3);
    CHECK(bits.claim(129, 1));
    CHECK_FALSE(bits.claim(129, 1));
    CHECK(bits.claim(129, 2));
    CHECK(bits.claim(128, 1));
    CHECK_FALSE(bits.claim_span(100, 1, 30));
}

TEST_CASE("A spread row has a bit wherever the other has one within reach") {
    support::Random random(91);
    for (const std::uint32_t reach : {0u, 1u, 2u, 4u, 7u, 33u, 63u, 64u}) {
        CAPTURE(reach);
        const std::uint32_t width = 100 + random.below(300);
        txc::CoverageBits bits(width, 2);
        std::vector<std::uint32_t> set;
        for (int i = 0; i < 4; ++i) {
            set.push_back(random.below(width));
            bits.claim(set.back(), 1);
        }
        txc::CoverageBits spread(width, 2);
        spread.spread_row(bits, 1, reach);
        for (std::uint32_t x = 0; x < width; ++x) {
            bool near = false;
            for (const std::uint32_t at : set) near = near || (x > at ? x - at : at - x) <= reach;
            REQUIRE(is_set(spread, x, 1) == near);
            REQUIRE_FALSE(is_set(spread, x, 0));
        }
    }
}
