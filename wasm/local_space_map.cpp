#include "local_space_map.h"

#include <cmath>
#include <cstring>

namespace txc {

std::uint64_t LocalSpaceMap::byte_count() const {
    std::uint64_t overlap_bytes = overlap_tiles.size() * sizeof(overlap_tiles[0]);
    for (const auto& tile : overlap_tiles) overlap_bytes += tile != nullptr ? kTileSize * kTileSize : 0;
    return frames.capacity() * sizeof(TexelFrame) + (runs.capacity() + gutter_runs.capacity()) * sizeof(TexelRun) +
           tiles.capacity() * sizeof(MapTile) + tile_of.capacity() * sizeof(std::uint32_t) + tree.byte_count() +
           overlap_bytes + patches->byte_count();
}

glm::vec3 LocalSpaceMap::unit_normal(const TexelRun& run, std::int32_t x, std::int32_t y) const {
    const TexelFrame& frame = frames[run.frame];
    const glm::vec3 n = (run.flags & kRunHoldNormal) != 0 ? frame.normal_at(frame.x0, frame.y0) : frame.normal_at(x, y);
    const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0.0f ? n / length : glm::vec3(0.0f, 1.0f, 0.0f);
}

void LocalSpaceMap::read_positions(std::uint32_t row, std::uint32_t row_count, float* out) const {
    std::memset(out, 0, static_cast<std::size_t>(row_count) * key.width * 3 * sizeof(float));
    for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        for (std::uint32_t i = 0; i < run.length; ++i) {
            const std::uint32_t x = tile_x + run.x + i;
            const glm::vec3 p =
                origin + frames[run.frame].position_at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
            std::memcpy(out + (static_cast<std::size_t>(y - row) * key.width + x) * 3, &p, sizeof p);
        }
    });
}

void LocalSpaceMap::read_normals(std::uint32_t row, std::uint32_t row_count, float* out) const {
    std::memset(out, 0, static_cast<std::size_t>(row_count) * key.width * 3 * sizeof(float));
    for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        for (std::uint32_t i = 0; i < run.length; ++i) {
            const std::uint32_t x = tile_x + run.x + i;
            const glm::vec3 n = unit_normal(run, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
            std::memcpy(out + (static_cast<std::size_t>(y - row) * key.width + x) * 3, &n, sizeof n);
        }
    });
}

void LocalSpaceMap::read_coverage(std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) const {
    std::memset(out, kEmpty, static_cast<std::size_t>(row_count) * key.width);
    for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        std::memset(out + static_cast<std::size_t>(y - row) * key.width + tile_x + run.x,
                    (run.flags & kRunGutter) != 0 ? kGutter : kCovered, run.length);
    });
}

void LocalSpaceMap::read_overlap(std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) const {
    std::memset(out, 0, static_cast<std::size_t>(row_count) * key.width);
    for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        if ((run.flags & kRunGutter) != 0) return;
        std::uint8_t* to = out + static_cast<std::size_t>(y - row) * key.width + tile_x + run.x;
        const std::uint8_t* claims = nullptr;
        if (!overlap_tiles.empty()) claims = overlap_tiles[y / kTileSize * tile_columns() + tile_x / kTileSize].get();
        for (std::uint32_t i = 0; i < run.length; ++i) {
            // A tile without an overlap keeps no counts: each covered texel of it is claimed once.
            to[i] = claims != nullptr ? claims[run.y * kTileSize + run.x + i] : 1;
        }
    });
}

}  // namespace txc
