// One bit a texel: does a triangle own it? What the raster asks before it claims a span, and where the gutter looks for
// neighbours, 64 texels at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace txc {

class CoverageBits {
public:
    CoverageBits() = default;
    CoverageBits(std::uint32_t width, std::uint32_t height)
        : words_(words_in(width)), bits_(static_cast<std::size_t>(words_) * height, 0) {}

    static constexpr std::uint32_t words_in(std::uint32_t width) { return (width + 63) / 64; }
    static std::uint64_t byte_count(std::uint32_t width, std::uint32_t height) {
        return std::uint64_t{8} * words_in(width) * height;
    }

    std::uint32_t words() const { return words_; }
    /// A row's words, the leftmost texel in the lowest bit; bits beyond the width are 0.
    const std::uint64_t* row(std::uint32_t y) const { return bits_.data() + static_cast<std::size_t>(y) * words_; }
    std::uint64_t* row(std::uint32_t y) { return bits_.data() + static_cast<std::size_t>(y) * words_; }

    /// Sets `count` > 0 bits from x on if none of them is set; false where any is, and nothing changes then.
    bool claim_span(std::uint32_t x, std::uint32_t y, std::uint32_t count) { return claim_in_row(row(y), x, count); }

    /// The same in a row's words.
    static bool claim_in_row(std::uint64_t* words, std::uint32_t x, std::uint32_t count) {
        words += x / 64;
        const std::uint32_t from = x % 64;
        if (from + count <= 64) {
            const std::uint64_t mask = (~std::uint64_t{0} >> (64 - count)) << from;
            if ((words[0] & mask) != 0) return false;
            words[0] |= mask;
            return true;
        }
        return claim_long_span(words, from, count);
    }

    bool is_claimed(std::uint32_t x, std::uint32_t y) const { return (row(y)[x / 64] >> (x % 64) & 1) != 0; }

    /// Whether all of `count` > 0 bits from x on are set.
    bool has_span(std::uint32_t x, std::uint32_t y, std::uint32_t count) const;

    /// Sets one bit; false where it was set already.
    bool claim(std::uint32_t x, std::uint32_t y) {
        std::uint64_t& word = row(y)[x / 64];
        const std::uint64_t bit = std::uint64_t{1} << (x % 64);
        if ((word & bit) != 0) return false;
        word |= bit;
        return true;
    }

    /// Makes row y of this the other's row, with each set bit spread by `reach` (up to 64) to either side.
    void spread_row(const CoverageBits& other, std::uint32_t y, std::uint32_t reach);

private:
    static bool claim_long_span(std::uint64_t* words, std::uint32_t from, std::uint32_t count);

    std::uint32_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

}  // namespace txc
