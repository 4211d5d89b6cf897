#include "coverage_bits.h"

#include <algorithm>

namespace txc {

bool CoverageBits::claim_long_span(std::uint64_t* words, std::uint32_t from, std::uint32_t count) {
    const std::uint64_t first = ~std::uint64_t{0} << from;
    const std::uint32_t after_first = count - (64 - from);
    const std::uint32_t whole = after_first / 64;
    const std::uint64_t last = after_first % 64 == 0 ? 0 : ~std::uint64_t{0} >> (64 - after_first % 64);
    std::uint64_t taken = words[0] & first;
    for (std::uint32_t i = 0; i < whole; ++i) taken |= words[1 + i];
    if (last != 0) taken |= words[1 + whole] & last;
    if (taken != 0) return false;
    words[0] |= first;
    for (std::uint32_t i = 0; i < whole; ++i) words[1 + i] = ~std::uint64_t{0};
    if (last != 0) words[1 + whole] |= last;
    return true;
}

bool CoverageBits::has_span(std::uint32_t x, std::uint32_t y, std::uint32_t count) const {
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    const std::uint32_t last = x + count - 1;
    const std::uint64_t* const end = row(y) + last / 64;
    std::uint64_t before = kAll << x % 64;  // what the span has of the word
    for (const std::uint64_t* word = row(y) + x / 64; word < end; ++word) {
        if ((~*word & before) != 0) return false;
        before = kAll;
    }
    return (~*end & before & kAll >> (63 - last % 64)) == 0;
}

void CoverageBits::spread_row(const CoverageBits& other, std::uint32_t y, std::uint32_t reach) {
    const std::uint64_t* from = other.row(y);
    std::uint64_t* to = row(y);
    std::uint64_t any = 0;
    for (std::uint32_t w = 0; w < words_; ++w) any |= from[w];
    std::copy(from, from + words_, to);
    if (any == 0) return;
    // By doubling: what is spread by n can be spread by up to n + 1 more at once.
    for (std::uint32_t done = 0; done < reach;) {
        const std::uint32_t by = std::min(done + 1, reach - done);
        for (std::uint32_t w = words_; w-- > 0;) {
            const std::uint64_t carried = w > 0 ? to[w - 1] >> (64 - by) : 0;
            to[w] |= to[w] << by | carried;
        }
        done += by;
    }
    for (std::uint32_t done = 0; done < reach;) {
        const std::uint32_t by = std::min(done + 1, reach - done);
        for (std::uint32_t w = 0; w < words_; ++w) {
            const std::uint64_t carried = w + 1 < words_ ? to[w + 1] << (64 - by) : 0;
            to[w] |= to[w] >> by | carried;
        }
        done += by;
    }
}

}  // namespace txc
