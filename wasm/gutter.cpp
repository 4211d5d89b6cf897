#include "gutter.h"

#include <algorithm>
#include <tuple>

namespace txc {

std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height) {
    return std::max(2u, (std::max(width, height) * 2 + 512) / 1024);
}

GutterSearch::GutterSearch(const CoverageBits& covered, std::uint32_t width, std::uint32_t height, std::uint32_t gutter)
    : covered_(covered), near_covered_(width, height), width_(width), height_(height), gutter_(gutter) {
    const auto reach = static_cast<std::int32_t>(gutter);
    for (std::int32_t dy = -reach; dy <= reach; ++dy) {
        for (std::int32_t dx = -reach; dx <= reach; ++dx) {
            const std::int32_t distance = dx * dx + dy * dy;
            if (distance > 0 && distance <= reach * reach) places_.push_back({dx, dy});
        }
    }
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
        const auto rank = [](const Place& p) { return std::tuple(p.dx * p.dx + p.dy * p.dy, p.dy * p.dy, p.dy, p.dx); };
        return rank(a) < rank(b);
    });
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
