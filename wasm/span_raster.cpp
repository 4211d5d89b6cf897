#include "span_raster.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

// A triangle that repeats the texture more often than this is no skin to paint, and would take hours to draw.
constexpr float kMaxRepeats = 256.0f;
constexpr std::uint8_t kMostClaims = 255;
// Of a triangle's box of texels by twice its area, where it is as large as the model: beyond it the gradients are so steep, and
// cancel so far, that over all of its rows a float's rounding would come to more than 2^-15 of the model (spec section 2).
constexpr double kSteepest = 32.0;
constexpr std::uint32_t kTileTexels = kTileSize * kTileSize;

std::int64_t floor_divide(std::int64_t value, std::int64_t by) {
    const std::int64_t quotient = value / by;
    return value % by < 0 ? quotient - 1 : quotient;
}

/// Counts a span's runs in a row of tiles.
inline void count_runs(std::uint32_t* run_counts, std::uint32_t first, std::uint32_t count) {
    std::uint32_t column = first / kTileSize;
    const std::uint32_t last = (first + count - 1) / kTileSize;
    ++run_counts[column];
    while (column < last) ++run_counts[++column];
}

}  // namespace

SpanRaster::SpanRaster(const Mesh& mesh, LocalSpaceMap& map, BudgetShare& scratch)
    : mesh_(mesh),
      material_(mesh.materials[map.key.material]),
      map_(map),
      covered_(map.key.texture_width(), map.key.texture_height()),
      window_covered_(map.key.is_window() ? map.key.width : 0, map.key.is_window() ? map.key.height : 0),
      scratch_(scratch),
      spans_(scratch),
      tile_run_counts_(map.key.tile_count(), 0) {}

TxcStatus SpanRaster::check(const Mesh& mesh, const MapKey& key) {
    const Material& material = mesh.materials[key.material];
    const glm::vec2 extent = material.uv_max - material.uv_min;
    if (extent.x <= kMaxRepeats && extent.y <= kMaxRepeats) return TXC_STATUS_OK;
    for (const std::uint32_t triangle : material.triangles) {
        const auto& vertices = mesh.triangles[triangle].vertex;
        const glm::vec2 a = mesh.uvs[vertices[0]];
        const glm::vec2 b = mesh.uvs[vertices[1]];
        const glm::vec2 c = mesh.uvs[vertices[2]];
        const glm::vec2 size = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
        if (size.x > kMaxRepeats || size.y > kMaxRepeats) {
            return fail(
                TXC_STATUS_BAD_UVS,
                "triangle %u of material %u repeats the texture more than %g times; unwrap the model to paint it",
                triangle, key.material, static_cast<double>(kMaxRepeats));
        }
    }
    return TXC_STATUS_OK;
}

std::uint64_t SpanRaster::byte_count(const MapKey& key) {
    const std::uint64_t tiles = key.tile_count();
    const std::uint64_t window = key.is_window() ? CoverageBits::byte_count(key.width, key.height) : 0;
    return CoverageBits::byte_count(key.texture_width(), key.texture_height()) + window + tiles * sizeof(std::uint32_t);
}

float SpanRaster::progress() const {
    return static_cast<float>(next_triangle_) /
           static_cast<float>(std::max<std::size_t>(material_.triangles.size(), 1));
}

TxcStatus SpanRaster::step(std::int64_t& work) {
    while (work > 0) {
        if (const TxcStatus status = wraps_ ? draw_wrapped_rows(work) : draw_rows(work); status != TXC_STATUS_OK)
            return status;
        if (done() || rows_.first < rows_.last) break;
        open_triangle(material_.triangles[next_triangle_++]);
        work -= 16;
    }
    return TXC_STATUS_OK;
}

void SpanRaster::open_triangle(std::uint32_t triangle) {
    triangle_ = triangle;
    rows_ = {0, 0};
    const Double2 size = {static_cast<double>(map_.key.texture_width()),
                          static_cast<double>(map_.key.texture_height())};
    const Triangle& corners = mesh_.triangles[triangle];
    Double2 low{};
    Double2 high{};
    for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = corners.vertex[corner];
        if (mesh_.vertex_has_uv[vertex] == 0) return;
        const glm::vec2 uv = mesh_.uvs[vertex];
        const Double2 place = Double2{static_cast<double>(uv.x), static_cast<double>(uv.y)} * size;
        low = corner == 0 ? place : lesser2(low, place);
        high = corner == 0 ? place : greater2(high, place);
        texels_.x[corner] = place[0];
        texels_.y[corner] = place[1];
    }
    if (texels_.doubled_area() == 0.0) return;
    raster_ = TriangleRaster(texels_);
    rows_ = raster_.rows();
    open_frames_.clear();
    is_steep_ = is_steep(high - low);
    wraps_ = any_lane2((low < splat2(0.0)) | (high > size));
    overlaps_itself_ = wraps_ && any_lane2(high - low > size);
    if (overlaps_itself_) claimed_ = CoverageBits(map_.key.texture_width(), map_.key.texture_height());
}

bool SpanRaster::is_steep(Double2 size) const {
    const double steepness = size[0] * size[1] / std::fabs(texels_.doubled_area());
    if (!(steepness > kSteepest)) return false;
    Bounds place;
    for (const std::uint32_t vertex : mesh_.triangles[triangle_].vertex) place.add(mesh_.positions[vertex]);
    return steepness * static_cast<double>(place.diagonal()) > kSteepest * static_cast<double>(mesh_.bounds.diagonal());
}

TxcStatus SpanRaster::add_span(std::uint32_t frame, std::uint32_t row, std::uint32_t first, std::uint32_t count) {
    if (map_.key.is_window()) return add_window_span(frame, row, first, count);
    map_.covered_texels += count;
    count_runs(tile_run_counts_.data() + row / kTileSize * map_.tile_columns(), first, count);
    return spans_.add(frame, first, row, count);
}

TxcStatus SpanRaster::add_window_span(std::uint32_t frame, std::uint32_t row, std::uint32_t first,
                                      std::uint32_t count) {
    const MapKey& key = map_.key;
    map_.covered_beyond += count;
    if (row < key.origin_y || row >= key.origin_y + key.height) return TXC_STATUS_OK;
    const std::uint32_t from = std::max(first, key.origin_x);
    const std::uint32_t to = std::min(first + count, key.origin_x + key.width);
    if (from >= to) return TXC_STATUS_OK;
    const std::uint32_t x = from - key.origin_x;
    const std::uint32_t y = row - key.origin_y;
    window_covered_.claim_span(x, y, to - from);
    map_.covered_texels += to - from;
    map_.covered_beyond -= to - from;
    count_runs(tile_run_counts_.data() + y / kTileSize * map_.tile_columns(), x, to - from);
    return spans_.add(frame, x, y, to - from);
}

/// A triangle inside the texture has one frame and meets no texel twice: nearly all do, so their rows take no call.
TxcStatus SpanRaster::draw_rows(std::int64_t& work) {
    constexpr std::uint32_t kNone = 0xffffffffu;
    // What the loop needs is its own: what lies behind `this` would be read anew after every store (with that, places in fixed
    // point and frames two coordinates at a time, 200,000 triangles bake in 0.89 of the time before).
    std::uint64_t* const words = covered_.row(0);
    const std::size_t stride = covered_.words();
    std::uint32_t* const run_counts = tile_run_counts_.data();
    const std::uint32_t columns = map_.tile_columns();
    const bool is_window = map_.key.is_window();
    std::uint32_t frame = open_frames_.empty() ? kNone : open_frames_[0].frame;
    std::uint32_t covered = 0;
    std::int64_t left = work;
    std::int32_t row = rows_.first;
    while (row < rows_.last && left > 0) {
        SpanWalk walk(raster_, row);
        const std::int32_t end = raster_.part_end(row);
        for (; row < end && left > 0; ++row) {
            const TexelRange span = walk.next();
            left -= 4;
            if (span.first >= span.last) continue;
            const auto first = static_cast<std::uint32_t>(span.first);
            const auto y = static_cast<std::uint32_t>(row);
            const auto count = static_cast<std::uint32_t>(span.last - span.first);
            if (!CoverageBits::claim_in_row(words + y * stride, first, count)) {
                if (is_settled(y, first, count)) continue;
                left -= count;
                if (const TxcStatus status = claim_free_texels(y, first, count, 0, 0); status != TXC_STATUS_OK)
                    return status;
                if (!open_frames_.empty()) frame = open_frames_[0].frame;
                continue;
            }
            left -= count;
            if (frame == kNone || is_steep_) {
                if (const TxcStatus status = frame_for({span.first, row, 0, 0}, frame); status != TXC_STATUS_OK)
                    return status;
            }
            if (is_window) {
                if (const TxcStatus status = add_window_span(frame, y, first, count); status != TXC_STATUS_OK)
                    return status;
                continue;
            }
            covered += count;
            count_runs(run_counts + y / kTileSize * columns, first, count);
            if (const TxcStatus status = spans_.add(frame, first, y, count); status != TXC_STATUS_OK) return status;
        }
    }
    rows_.first = row;
    map_.covered_texels += covered;
    work = left;
    return TXC_STATUS_OK;
}

TxcStatus SpanRaster::draw_wrapped_rows(std::int64_t& work) {
    const auto width = static_cast<std::int64_t>(map_.key.texture_width());
    const auto height = static_cast<std::int64_t>(map_.key.texture_height());
    while (rows_.first < rows_.last && work > 0) {
        const std::int32_t row = rows_.first++;
        const std::int64_t repeat_y = floor_divide(row, height) * height;
        work -= 4;
        // Nothing more than the triangle's first claim counts. Without this one that covers 1024 x 1024 texels 100 times is drawn in
        // eleven seconds.
        if (overlaps_itself_ &&
            claimed_.has_span(0, static_cast<std::uint32_t>(row - repeat_y), map_.key.texture_width()))
            continue;
        const TexelRange span = raster_.span(row);
        const std::int64_t end = std::min<std::int64_t>(span.last, span.first + width);
        work -= std::max<std::int64_t>(end - span.first, 0);
        for (std::int64_t x = span.first; x < end;) {
            const std::int64_t repeat_x = floor_divide(x, width) * width;
            const std::int64_t count = std::min(end - x, repeat_x + width - x);
            const TxcStatus status =
                claim(static_cast<std::uint32_t>(row - repeat_y), static_cast<std::uint32_t>(x - repeat_x),
                      static_cast<std::uint32_t>(count), repeat_x, repeat_y);
            if (status != TXC_STATUS_OK) return status;
            x += count;
        }
    }
    return TXC_STATUS_OK;
}

TxcStatus SpanRaster::claim(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                            std::int64_t repeat_y) {
    if (!overlaps_itself_ && covered_.claim_span(first, row, count))
        return keep_span(row, first, count, repeat_x, repeat_y);
    if (is_settled(row, first, count)) return TXC_STATUS_OK;
    return claim_free_texels(row, first, count, repeat_x, repeat_y);
}

TxcStatus SpanRaster::claim_free_texels(std::uint32_t row, std::uint32_t first, std::uint32_t count,
                                        std::int64_t repeat_x, std::int64_t repeat_y) {
    const std::uint32_t end = first + count;
    for (std::uint32_t x = first; x < end;) {
        const std::uint32_t start = x;
        bool seen_before = false;
        bool taken = false;
        for (; x < end && !seen_before && !taken; ++x) {
            seen_before = overlaps_itself_ && !claimed_.claim(x, row);
            if (!seen_before) taken = !covered_.claim(x, row);
        }
        const std::uint32_t free = x - start - (seen_before || taken ? 1 : 0);
        if (free > 0) {
            if (const TxcStatus status = keep_span(row, start, free, repeat_x, repeat_y); status != TXC_STATUS_OK)
                return status;
        }
        if (taken) {
            if (const TxcStatus status = count_overlap(x - 1, row); status != TXC_STATUS_OK) return status;
        }
    }
    return TXC_STATUS_OK;
}

TxcStatus SpanRaster::keep_span(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                                std::int64_t repeat_y) {
    std::uint32_t frame = 0;
    const RepeatedTexel at{static_cast<std::int32_t>(first), static_cast<std::int32_t>(row), repeat_x, repeat_y};
    if (const TxcStatus status = frame_for(at, frame); status != TXC_STATUS_OK) return status;
    return add_span(frame, row, first, count);
}

TxcStatus SpanRaster::frame_for(const RepeatedTexel& at, std::uint32_t& out_frame) {
    for (auto open = open_frames_.rbegin(); open != open_frames_.rend(); ++open) {
        if (open->repeat_x == at.repeat_x && open->repeat_y == at.repeat_y) {
            out_frame = open->frame;
            return TXC_STATUS_OK;
        }
    }
    std::vector<TexelFrame>& frames = map_.frames;
    if (frames.size() == frames.capacity()) {
        // One a triangle as a rule, and never more than texels.
        const std::uint64_t texels = std::uint64_t{map_.key.texture_width()} * map_.key.texture_height();
        const std::uint64_t larger = frames.empty() ? std::min<std::uint64_t>(material_.triangles.size(), texels)
                                                    : frames.size() + frames.size() / 2 + 16;
        const TxcStatus status =
            reserve_counted(frames, static_cast<std::size_t>(larger), map_.share, "baking the map");
        if (status != TXC_STATUS_OK) return status;
    }
    out_frame = static_cast<std::uint32_t>(frames.size());
    TexelFrame& frame = frames.emplace_back();
    make_texel_frame(mesh_, triangle_, texels_, at, frame);
    frame.x0 -= static_cast<std::int32_t>(map_.key.origin_x);
    frame.y0 -= static_cast<std::int32_t>(map_.key.origin_y);
    if (!is_steep_) open_frames_.push_back({at.repeat_x, at.repeat_y, out_frame});
    return TXC_STATUS_OK;
}

bool SpanRaster::is_settled(std::uint32_t row, std::uint32_t first, std::uint32_t count) const {
    return settled_.words() > 0 && settled_.has_span(first, row, count);
}

TxcStatus SpanRaster::count_overlap(std::uint32_t texture_x, std::uint32_t texture_y) {
    if (settled_.words() == 0) {
        const std::uint32_t width = map_.key.texture_width();
        const std::uint32_t height = map_.key.texture_height();
        const std::uint64_t bytes = scratch_.bytes() + CoverageBits::byte_count(width, height);
        if (const TxcStatus status = scratch_.resize(bytes, "counting overlaps"); status != TXC_STATUS_OK)
            return status;
        settled_ = CoverageBits(width, height);
    }
    // Left of a window and above it the differences wrap around, to beyond its other side.
    const std::uint32_t x = texture_x - map_.key.origin_x;
    const std::uint32_t y = texture_y - map_.key.origin_y;
    if (x >= map_.key.width || y >= map_.key.height) {
        settled_.claim(texture_x, texture_y);
        return TXC_STATUS_OK;
    }
    if (map_.overlap_tiles.empty()) {
        const std::size_t tiles = map_.tile_of.size();
        const std::uint64_t bytes = tiles * sizeof(map_.overlap_tiles[0]);
        if (const TxcStatus status = map_.share.resize(map_.share.bytes() + bytes, "counting overlaps");
            status != TXC_STATUS_OK)
            return status;
        map_.overlap_tiles.resize(tiles);
    }
    auto& claims = map_.overlap_tiles[y / kTileSize * map_.tile_columns() + x / kTileSize];
    if (claims == nullptr) {
        if (const TxcStatus status = map_.share.resize(map_.share.bytes() + kTileTexels, "counting overlaps");
            status != TXC_STATUS_OK)
            return status;
        claims = std::make_unique<std::uint8_t[]>(kTileTexels);
        std::fill_n(claims.get(), kTileTexels, std::uint8_t{1});
    }
    std::uint8_t& claim = claims[y % kTileSize * kTileSize + x % kTileSize];
    if (claim == 1) ++map_.overlapping_texels;
    if (claim < kMostClaims) ++claim;
    if (claim == kMostClaims) settled_.claim(texture_x, texture_y);
    return TXC_STATUS_OK;
}

}  // namespace txc
