#include "gutter.h"

#include <algorithm>

namespace txc {

std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height) {
    return std::max(2u, (std::max(width, height) * 2 + 512) / 1024);
}

NearestTexel nearest_owned(const std::vector<std::int8_t>& rows, std::uint32_t width, std::uint32_t height,
                           std::uint32_t gutter, std::uint32_t x, std::uint32_t y) {
    NearestTexel nearest{0, 0, false};
    const auto reach = static_cast<std::int32_t>(gutter);
    std::int32_t best = reach * reach;
    for (std::int32_t step = 0; step <= reach && step * step <= best; ++step) {
        for (const std::int32_t dy : {-step, step}) {
            const std::int32_t row = static_cast<std::int32_t>(y) + dy;
            if (row < 0 || row >= static_cast<std::int32_t>(height)) continue;
            const std::int8_t dx = rows[static_cast<std::size_t>(row) * width + x];
            if (dx == kNoNeighbour) continue;
            const std::int32_t distance = dx * dx + dy * dy;
            if (distance < best || (distance == best && !nearest.found)) {
                best = distance;
                nearest = {static_cast<std::int32_t>(x) + dx, row, true};
            }
        }
    }
    return nearest;
}

}  // namespace txc
