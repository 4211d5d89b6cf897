#include "gutter.h"

#include <algorithm>

#include "sorted_keys.h"

namespace txc {

std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height) {
    return std::max(2u, (std::max(width, height) * 2 + 512) / 1024);
}

GutterSearch::GutterSearch(const CoverageBits& covered, std::uint32_t width, std::uint32_t height, std::uint32_t gutter)
    : covered_(covered), near_covered_(width, height), width_(width), height_(height), gutter_(gutter) {
    constexpr std::int32_t kMiddle = 128;
    static_assert(kMaxGutter < kMiddle);
    const auto reach = static_cast<std::int32_t>(gutter);
    std::vector<std::uint64_t> ranks;
    for (std::int32_t dy = -reach; dy <= reach; ++dy) {
        for (std::int32_t dx = -reach; dx <= reach; ++dx) {
            const std::int32_t distance = dx * dx + dy * dy;
            if (distance == 0 || distance > reach * reach) continue;
            ranks.push_back(static_cast<std::uint64_t>(distance) << 32 | static_cast<std::uint64_t>(dy * dy) << 16 |
                            static_cast<std::uint64_t>(dy + kMiddle) << 8 | static_cast<std::uint64_t>(dx + kMiddle));
        }
    }
    sort_keys(ranks);
    for (const std::uint64_t rank : ranks)
        places_.push_back(
            {static_cast<std::int32_t>(rank & 0xff) - kMiddle, static_cast<std::int32_t>(rank >> 8 & 0xff) - kMiddle});
}

/// The texels of a row that may be gutter: not covered, with a covered one in the square around them.
void GutterSearch::collect_candidates(std::uint32_t y, std::uint64_t* out) const {
    const std::uint32_t words = covered_.words();
    const std::uint64_t* covered = covered_.row(y);
    const std::uint32_t first = y > gutter_ ? y - gutter_ : 0;
    const std::uint32_t last = std::min(y + gutter_, height_ - 1);
    std::fill_n(out, words, std::uint64_t{0});
    for (std::uint32_t row = first; row <= last; ++row) {
        const std::uint64_t* spread = near_covered_.row(row);
        for (std::uint32_t w = 0; w < words; ++w) out[w] |= spread[w];
    }
    for (std::uint32_t w = 0; w < words; ++w) out[w] &= ~covered[w];
    if (width_ % 64 != 0) out[words - 1] &= ~std::uint64_t{0} >> (64 - width_ % 64);
}

}  // namespace txc
