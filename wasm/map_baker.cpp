#include "map_baker.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "float4.h"
#include "gutter.h"

namespace txc {
namespace {

constexpr std::uint64_t kSpansAtOnce = 4096;
constexpr std::uint32_t kHoldNormalMark = 0x80000000u;  // on a frame's index

/// Where the texels of one frame lie, put into the boxes of their tiles.
class FrameBounds {
public:
    void look_at(const std::vector<TexelFrame>& frames, std::uint32_t index) {
        if (index == index_) return;
        index_ = index;
        const TexelFrame& frame = frames[index];
        x0_ = frame.x0;
        y0_ = frame.y0;
        using Coordinate = TexelFrame::Coordinate;
        position_ = load_vec3(TexelFrame::part(frame.position, &Coordinate::at));
        dx_ = load_vec3(TexelFrame::part(frame.position, &Coordinate::dx));
        dy_ = load_vec3(TexelFrame::part(frame.position, &Coordinate::dy));
        // The footprints reach half a texel beyond the first and last centre, and above and below.
        reach_ = (absolute(dx_) + absolute(dy_)) * splat(0.5f);
    }

    /// The texels [x, end) of row y.
    void add_to(TileBox& box, std::uint32_t x, std::uint32_t end, std::uint32_t y) const {
        const auto across = static_cast<float>(static_cast<std::int32_t>(x) - x0_);
        const auto down = static_cast<float>(static_cast<std::int32_t>(y) - y0_);
        const Float4 first = position_ + dx_ * splat(across) + dy_ * splat(down);
        const Float4 last = first + dx_ * splat(static_cast<float>(end - x - 1));
        box.low = lesser(box.low, lesser(first, last) - reach_);
        box.high = greater(box.high, greater(first, last) + reach_);
    }

private:
    std::uint32_t index_ = kNoTile;
    std::int32_t x0_ = 0;
    std::int32_t y0_ = 0;
    Float4 position_{};
    Float4 dx_{};
    Float4 dy_{};
    Float4 reach_{};
};

}  // namespace

MapBaker::MapBaker(const Mesh& mesh, const MapKey& key, MemoryBudget& budget)
    : map_(std::make_shared<LocalSpaceMap>(key, budget)), scratch_(budget), raster_(mesh, *map_, scratch_) {}

TxcStatus MapBaker::begin(const Mesh& mesh, const MapKey& key, MemoryBudget& budget,
                          std::unique_ptr<MapBaker>& out_baker) {
    if (const TxcStatus status = SpanRaster::check(mesh, key); status != TXC_STATUS_OK) return status;
    // Counted before the arrays are made: the shares below only take over what is known to fit.
    BudgetShare needed(budget);
    const std::uint64_t tiles = key.tile_count();
    const std::uint64_t map_bytes = tiles * sizeof(std::uint32_t);
    // The raster's bits a second time: for a triangle that overlaps itself, and after it for the gutter.
    const std::uint64_t scratch_bytes = SpanRaster::byte_count(key) + GutterSearch::byte_count(key.width, key.height) +
                                        TileOwners::byte_count(key) + std::uint64_t{key.width} * kTileSize * 4;
    if (const TxcStatus status = needed.resize(map_bytes + scratch_bytes, "baking the map"); status != TXC_STATUS_OK)
        return status;
    needed.release();
    std::unique_ptr<MapBaker> baker(new MapBaker(mesh, key, budget));
    if (const TxcStatus status = baker->scratch_.resize(scratch_bytes, "baking the map"); status != TXC_STATUS_OK)
        return status;
    if (const TxcStatus status = baker->map_->share.resize(map_bytes, "baking the map"); status != TXC_STATUS_OK)
        return status;
    baker->map_->origin = mesh.origin;
    baker->map_->bounds = mesh.materials[key.material].bounds;
    baker->map_->tile_of.assign(static_cast<std::size_t>(tiles), kNoTile);
    out_baker = std::move(baker);
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::step(std::uint32_t work_limit) {
    std::int64_t work = std::max<std::int64_t>(work_limit, 1);
    const MapKey& key = map_->key;
    while (work > 0 && phase_ != Phase::kDone) {
        switch (phase_) {
            case Phase::kRaster:
                if (const TxcStatus status = raster_.step(work); status != TXC_STATUS_OK) return status;
                if (!raster_.done()) break;
                if (const TxcStatus status = begin_sorting(); status != TXC_STATUS_OK) return status;
                phase_ = Phase::kSort;
                break;
            case Phase::kSort:
                sort_spans(kSpansAtOnce);
                work -= static_cast<std::int64_t>(kSpansAtOnce);
                if (next_span_ < raster_.spans().size()) break;
                begin_gutter();
                phase_ = Phase::kPrepare;
                break;
            case Phase::kPrepare:
                gutter_->prepare_row(next_row_);
                work -= key.width / 8 + 1;
                if (++next_row_ < key.height) break;
                next_row_ = 0;
                phase_ = Phase::kGutter;
                break;
            case Phase::kGutter:
                if (const TxcStatus status = finish_tile_row(next_row_); status != TXC_STATUS_OK) return status;
                work -= static_cast<std::int64_t>(key.width) * kTileSize;
                if (++next_row_ < map_->tile_rows()) break;
                if (const TxcStatus status = finish(); status != TXC_STATUS_OK) return status;
                phase_ = Phase::kDone;
                break;
            case Phase::kDone:
                break;
        }
    }
    return phase_ == Phase::kDone ? TXC_STATUS_OK : TXC_STATUS_PENDING;
}

float MapBaker::progress() const {
    const auto share = [](std::uint64_t part, std::uint64_t whole) {
        return static_cast<float>(part) / static_cast<float>(std::max<std::uint64_t>(whole, 1));
    };
    switch (phase_) {
        case Phase::kRaster:
            return 0.6f * raster_.progress();
        case Phase::kSort:
            return 0.6f + 0.1f * share(next_span_, raster_.spans().size());
        case Phase::kPrepare:
            return 0.7f + 0.1f * share(next_row_, map_->key.height);
        case Phase::kGutter:
            return 0.8f + 0.2f * share(next_row_, map_->tile_rows() + 1);
        case Phase::kDone:
            break;
    }
    return 1.0f;
}

// ---- Sorting spans into tiles -----------------------------------------------------------------------------------------

TxcStatus MapBaker::begin_sorting() {
    LocalSpaceMap& map = *map_;
    run_ends_ = raster_.tile_run_counts();
    std::uint64_t runs = 0;
    for (std::uint32_t& end : run_ends_) {
        const std::uint32_t count = end;
        end = static_cast<std::uint32_t>(runs);
        runs += count;
    }
    const std::uint64_t scratch = scratch_.bytes() + run_ends_.size() * (sizeof(std::uint32_t) + sizeof(TileBox));
    if (const TxcStatus status = scratch_.resize(scratch, "baking the map"); status != TXC_STATUS_OK) return status;
    const std::uint64_t groups =
        (map.tile_columns() / TileTree::kGroupSize + 1) * (map.tile_rows() / TileTree::kGroupSize + 1);
    const std::uint64_t bytes =
        map.share.bytes() + runs * sizeof(TexelRun) + run_ends_.size() * sizeof(MapTile) + groups * 32;
    if (const TxcStatus status = map.share.resize(bytes, "baking the map"); status != TXC_STATUS_OK) return status;
    map.runs.resize(static_cast<std::size_t>(runs));
    boxes_.assign(run_ends_.size(), TileBox{});
    return TXC_STATUS_OK;
}

// Rejected: a tile's box and the end of its runs held in registers until the next tile comes, which took as long (0.886 against
// 0.874 to 0.89 of the same yardstick on 200,000 triangles). So did all of the bake's files at -O3.
void MapBaker::sort_spans(std::uint64_t count) {
    const std::uint32_t columns = map_->tile_columns();
    TexelRun* runs = map_->runs.data();
    std::uint32_t* ends = run_ends_.data();
    FrameBounds bounds;
    next_span_ = raster_.spans().visit(next_span_, count, [&](const Span& span) {
        const std::uint32_t last = span.x + span.length;
        const auto row = static_cast<std::uint8_t>(span.y % kTileSize);
        std::uint32_t tile = span.y / kTileSize * columns + span.x / kTileSize;
        bounds.look_at(map_->frames, span.frame);
        for (std::uint32_t x = span.x; x < last; ++tile) {
            const std::uint32_t end = std::min(x / kTileSize * kTileSize + kTileSize, last);
            runs[ends[tile]++] = {span.frame, static_cast<std::uint8_t>(x % kTileSize), row,
                                  static_cast<std::uint8_t>(end - x), 0};
            bounds.add_to(boxes_[tile], x, end, span.y);
            x = end;
        }
    });
}

// ---- Gutter and bounds ------------------------------------------------------------------------------------------------

void MapBaker::begin_gutter() {
    const MapKey& key = map_->key;
    raster_.release_spans();
    gutter_ = std::make_unique<GutterSearch>(raster_.covered(), key.width, key.height, key.gutter);
    owners_ = std::make_unique<TileOwners>(*map_, run_ends_);
    gutter_bits_.resize(std::size_t{kTileSize} * raster_.covered().words());
    gutter_owners_.resize(std::size_t{kTileSize} * key.width);
    map_->tiles.reserve(run_ends_.size());
}

TxcStatus MapBaker::finish_tile_row(std::uint32_t tile_row) {
    LocalSpaceMap& map = *map_;
    const std::uint32_t rows = std::min(map.key.height - tile_row * kTileSize, kTileSize);
    find_gutter(tile_row * kTileSize, rows);
    for (std::uint32_t column = 0; column < map.tile_columns(); ++column) {
        MapTile tile{};
        tile.index = tile_row * map.tile_columns() + column;
        tile.first_run = tile.index > 0 ? run_ends_[tile.index - 1] : 0;
        tile.run_count = run_ends_[tile.index] - tile.first_run;
        tile.first_gutter_run = static_cast<std::uint32_t>(map.gutter_runs.size());
        if (const TxcStatus status = add_gutter_runs(tile_row, column, rows); status != TXC_STATUS_OK) return status;
        tile.gutter_run_count = static_cast<std::uint32_t>(map.gutter_runs.size()) - tile.first_gutter_run;
        if (tile.run_count + tile.gutter_run_count == 0) continue;
        const TileBox& box = boxes_[tile.index];
        tile.box = {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
        map.tile_of[tile.index] = static_cast<std::uint32_t>(map.tiles.size());
        map.tiles.push_back(tile);
    }
    return TXC_STATUS_OK;
}

void MapBaker::find_gutter(std::uint32_t first_row, std::uint32_t rows) {
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t y = first_row + row;
        std::uint32_t* owners = gutter_owners_.data() + std::size_t{row} * map_->key.width;
        gutter_->search_row(y, gutter_bits_.data() + std::size_t{row} * raster_.covered().words(),
                            [&](std::uint32_t x, std::uint32_t nearest_x, std::uint32_t nearest_y) {
                                owners[x] = extended_owner(x, y, nearest_x, nearest_y);
                                ++map_->gutter_texels;
                            });
    }
}

/// The frame that a gutter texel takes from the nearest covered one, with kHoldNormalMark where its normal must not be
/// continued.
std::uint32_t MapBaker::extended_owner(std::uint32_t x, std::uint32_t y, std::uint32_t nearest_x,
                                       std::uint32_t nearest_y) {
    const std::uint32_t owner = owners_->owner(nearest_x, nearest_y);
    const TexelFrame& frame = map_->frames[owner];
    const glm::vec3 there = frame.normal_at(static_cast<std::int32_t>(nearest_x), static_cast<std::int32_t>(nearest_y));
    const glm::vec3 here = frame.normal_at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
    const float cosine = glm::dot(there, here);
    const bool keeps_side = cosine > 0.0f && cosine * cosine >= 0.25f * glm::dot(there, there) * glm::dot(here, here);
    return keeps_side ? owner : owner | kHoldNormalMark;
}

TxcStatus MapBaker::add_gutter_runs(std::uint32_t tile_row, std::uint32_t tile_column, std::uint32_t rows) {
    constexpr std::uint32_t kTilesInWord = 64 / kTileSize;
    const std::uint32_t tile_x = tile_column * kTileSize;
    const std::uint32_t first_row = tile_row * kTileSize;
    std::vector<TexelRun>& runs = map_->gutter_runs;
    TileBox& box = boxes_[std::size_t{tile_row} * map_->tile_columns() + tile_column];
    FrameBounds bounds;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint64_t word =
            gutter_bits_[std::size_t{row} * raster_.covered().words() + tile_column / kTilesInWord];
        auto bits = static_cast<std::uint32_t>(word >> (tile_column % kTilesInWord * kTileSize)) & 0xffffu;
        if (bits == 0) continue;
        if (const TxcStatus status = reserve_gutter_runs(kTileSize); status != TXC_STATUS_OK) return status;
        const std::uint32_t* owners =
            gutter_owners_.data() + std::size_t{row} * map_->key.width + tile_column * kTileSize;
        while (bits != 0) {
            const auto x = static_cast<std::uint32_t>(std::countr_zero(bits));
            const std::uint32_t owner = owners[x];
            std::uint32_t end = x;
            while ((bits >> end & 1) != 0 && owners[end] == owner) bits ^= 1u << end++;
            bounds.look_at(map_->frames, owner & ~kHoldNormalMark);
            bounds.add_to(box, tile_x + x, tile_x + end, first_row + row);
            const std::uint8_t flags = (owner & kHoldNormalMark) != 0 ? kRunGutter | kRunHoldNormal : kRunGutter;
            runs.push_back({owner & ~kHoldNormalMark, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(row),
                            static_cast<std::uint8_t>(end - x), flags});
        }
    }
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::reserve_gutter_runs(std::size_t count) {
    std::vector<TexelRun>& runs = map_->gutter_runs;
    if (runs.capacity() - runs.size() >= count) return TXC_STATUS_OK;
    const std::size_t larger = std::max<std::size_t>(1024, runs.capacity() + runs.capacity() / 2);
    return reserve_counted(runs, larger, map_->share, "baking the map");
}

TxcStatus MapBaker::finish() {
    LocalSpaceMap& map = *map_;
    owners_.reset();
    gutter_.reset();
    gutter_bits_ = decltype(gutter_bits_)();
    gutter_owners_ = decltype(gutter_owners_)();
    run_ends_ = decltype(run_ends_)();
    boxes_ = decltype(boxes_)();
    scratch_.release();
    map.tiles.shrink_to_fit();
    map.gutter_runs.shrink_to_fit();
    // Frames are as many as triangles; where most of those own no texel, the rest is given back.
    if (map.frames.size() < map.frames.capacity() / 4 * 3) map.frames.shrink_to_fit();
    map.tree.build(map);
    return map.share.resize(map.byte_count(), "baking the map");
}

}  // namespace txc
