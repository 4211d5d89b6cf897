#include "gutter.h"

#include <algorithm>
#include <cstring>

namespace txc {

std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height) {
    return std::max(2u, (std::max(width, height) * 2 + 512) / 1024);
}

void nearest_in_row(const std::uint32_t* owners, std::uint32_t nobody, std::uint32_t width, std::uint32_t gutter,
                    std::int8_t* out) {
    // Most stretches are owned from end to end; they are passed over sixteen at a time.
    constexpr std::uint32_t kStretch = 16;
    std::int64_t left = -1000;
    for (std::uint32_t x = 0; x < width;) {
        if (x + kStretch <= width) {
            std::uint32_t free = 0;
            for (std::uint32_t i = 0; i < kStretch; ++i) free |= owners[x + i] == nobody ? 1u : 0u;
            if (free == 0) {
                std::memset(out + x, 0, kStretch);
                x += kStretch;
                left = x - 1;
                continue;
            }
        }
        const std::uint32_t end = std::min(x + kStretch, width);
        for (; x < end; ++x) {
            if (owners[x] != nobody) left = x;
            const std::int64_t distance = x - left;
            out[x] = distance <= gutter ? static_cast<std::int8_t>(-distance) : kNoNeighbour;
        }
    }
    std::int64_t right = static_cast<std::int64_t>(width) + 1000;
    for (std::uint32_t x = width; x-- > 0;) {
        if (out[x] == 0) {
            right = x;
            continue;
        }
        const std::int64_t distance = right - x;
        if (distance <= gutter && (out[x] == kNoNeighbour || distance < -out[x])) {
            out[x] = static_cast<std::int8_t>(distance);
        }
    }
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
