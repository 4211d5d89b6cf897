#include "map_baker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gutter.h"

namespace txc {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffu;
constexpr std::uint32_t kGutterMark = 0x80000000u;
constexpr std::uint32_t kHoldNormalMark = 0x40000000u;
constexpr std::uint32_t kFrameMask = 0x3fffffffu;
// A triangle that repeats the texture more often than this is no skin to paint, and would take hours to rasterise.
constexpr double kMaxRepeats = 256.0;

std::int64_t floor_divide(std::int64_t value, std::int64_t by) {
    if (value >= 0 && value < by) return 0;  // nearly always: UVs inside [0, 1)
    const std::int64_t quotient = value / by;
    return value % by < 0 ? quotient - 1 : quotient;
}

/// True where no texel of the span has an owner yet: without overlap, always.
bool is_free(const std::uint32_t* owners, std::uint32_t count) {
    std::uint32_t taken = 0;
    for (std::uint32_t i = 0; i < count; ++i) taken |= owners[i] ^ kNobody;
    return taken == 0;
}

TexelTriangle in_texels(const Mesh& mesh, std::uint32_t triangle, const MapKey& key) {
    TexelTriangle texels;
    for (int corner = 0; corner < 3; ++corner) {
        const glm::vec2 uv = mesh.uvs[mesh.triangles[triangle].vertex[corner]];
        texels.x[corner] = static_cast<double>(uv.x) * key.width;
        texels.y[corner] = static_cast<double>(uv.y) * key.height;
    }
    return texels;
}

double extent(const double (&values)[3]) {
    return std::fmax(values[0], std::fmax(values[1], values[2])) -
           std::fmin(values[0], std::fmin(values[1], values[2]));
}

// A UV sliver can have a gradient that no float holds; it then keeps its position and normal over its few texels.
glm::vec3 finite_or_zero(const glm::dvec3& gradient) {
    const double largest = std::fmax(std::fabs(gradient.x), std::fmax(std::fabs(gradient.y), std::fabs(gradient.z)));
    return largest < 1e18 ? glm::vec3(gradient) : glm::vec3(0.0f);
}

}  // namespace

MapBaker::MapBaker(const Mesh& mesh, const MapKey& key, MemoryBudget& budget)
    : mesh_(mesh),
      material_(mesh.materials[key.material]),
      map_(std::make_shared<LocalSpaceMap>(key, budget)),
      scratch_(budget) {}

TxcStatus MapBaker::begin(const Mesh& mesh, const MapKey& key, MemoryBudget& budget,
                          std::unique_ptr<MapBaker>& out_baker) {
    const Material& material = mesh.materials[key.material];
    for (const std::uint32_t triangle : material.triangles) {
        const TexelTriangle texels = in_texels(mesh, triangle, key);
        if (extent(texels.x) > kMaxRepeats * key.width || extent(texels.y) > kMaxRepeats * key.height) {
            return fail(
                TXC_STATUS_BAD_UVS,
                "triangle %u of material %u repeats the texture more than %g times; unwrap the model to paint it",
                triangle, key.material, kMaxRepeats);
        }
    }
    std::unique_ptr<MapBaker> baker(new MapBaker(mesh, key, budget));
    const std::uint64_t texels = static_cast<std::uint64_t>(key.width) * key.height;
    const std::uint64_t tiles = static_cast<std::uint64_t>(baker->map_->tile_columns()) * baker->map_->tile_rows();
    if (const TxcStatus status = baker->scratch_.resize(texels * 5 + tiles, "baking the map"); status != TXC_STATUS_OK)
        return status;
    if (const TxcStatus status = baker->map_->share.resize(tiles * sizeof(std::uint32_t), "baking the map");
        status != TXC_STATUS_OK)
        return status;
    baker->map_->bounds = material.bounds;
    baker->map_->tile_of.assign(static_cast<std::size_t>(tiles), kNoTile);
    baker->owners_.assign(static_cast<std::size_t>(texels), kNobody);
    out_baker = std::move(baker);
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::step(std::uint32_t work_limit) {
    std::int64_t work = std::max<std::int64_t>(work_limit, 1);
    const MapKey& key = map_->key;
    while (work > 0 && phase_ != Phase::kDone) {
        switch (phase_) {
            case Phase::kRaster:
                if (const TxcStatus status = raster(work); status != TXC_STATUS_OK) return status;
                if (next_triangle_ < material_.triangles.size() || rows_.first < rows_.last) break;
                claimed_ = {};
                row_distances_.resize(owners_.size());
                near_tiles_.assign(map_->tile_of.size(), 0);
                next_row_ = 0;
                phase_ = Phase::kRows;
                break;
            case Phase::kRows:
                measure_row(next_row_);
                work -= key.width;
                if (++next_row_ < key.height) break;
                next_row_ = 0;
                phase_ = Phase::kGutter;
                break;
            case Phase::kGutter:
                find_gutter_row(next_row_);
                work -= key.width;
                if (++next_row_ < key.height) break;
                if (const TxcStatus status = begin_packing(); status != TXC_STATUS_OK) return status;
                next_row_ = 0;
                phase_ = Phase::kPack;
                break;
            case Phase::kPack:
                pack_tile_row(next_row_);
                work -= static_cast<std::int64_t>(key.width) * kTileSize;
                if (++next_row_ < map_->tile_rows()) break;
                map_->tree.build(*map_);
                owners_ = {};
                scratch_.release();
                phase_ = Phase::kDone;
                break;
            case Phase::kDone:
                break;
        }
    }
    return phase_ == Phase::kDone ? TXC_STATUS_OK : TXC_STATUS_PENDING;
}

float MapBaker::progress() const {
    const float height = static_cast<float>(map_ != nullptr ? map_->key.height : 1);
    switch (phase_) {
        case Phase::kRaster:
            return 0.6f * static_cast<float>(next_triangle_) /
                   static_cast<float>(std::max<std::size_t>(material_.triangles.size(), 1));
        case Phase::kRows:
            return 0.6f + 0.1f * static_cast<float>(next_row_) / height;
        case Phase::kGutter:
            return 0.7f + 0.1f * static_cast<float>(next_row_) / height;
        case Phase::kPack:
            return 0.8f + 0.2f * static_cast<float>(next_row_ * kTileSize) / (height + kTileSize);
        case Phase::kDone:
            break;
    }
    return 1.0f;
}

// ---- Raster -----------------------------------------------------------------------------------------------------------

TxcStatus MapBaker::raster(std::int64_t& work) {
    while (work > 0) {
        while (rows_.first < rows_.last && work > 0) {
            const std::int64_t row = rows_.first++;
            if (const TxcStatus status = raster_row(row, work); status != TXC_STATUS_OK) return status;
        }
        if (rows_.first < rows_.last) break;
        if (next_triangle_ == material_.triangles.size()) break;
        open_triangle(material_.triangles[next_triangle_++]);
        work -= 16;
    }
    return TXC_STATUS_OK;
}

void MapBaker::open_triangle(std::uint32_t triangle) {
    triangle_ = triangle;
    rows_ = {0, 0};
    for (const std::uint32_t vertex : mesh_.triangles[triangle].vertex) {
        if (mesh_.vertex_has_uv[vertex] == 0) return;
    }
    texels_ = in_texels(mesh_, triangle, map_->key);
    if (texels_.doubled_area() == 0.0) return;
    rows_ = raster_rows(texels_);
    open_frames_.clear();
    overlaps_itself_ = extent(texels_.x) > map_->key.width || extent(texels_.y) > map_->key.height;
    if (overlaps_itself_) claimed_.assign(owners_.size(), false);
}

TxcStatus MapBaker::raster_row(std::int64_t row, std::int64_t& work) {
    const auto width = static_cast<std::int64_t>(map_->key.width);
    const auto height = static_cast<std::int64_t>(map_->key.height);
    const RowRange span = raster_span(texels_, row);
    work -= 4 + std::max<std::int64_t>(span.last - span.first, 0);
    const std::int64_t repeat_y = floor_divide(row, height);
    for (std::int64_t x = span.first; x < span.last;) {
        const std::int64_t repeat_x = floor_divide(x, width);
        const std::int64_t wrapped = x - repeat_x * width;
        const std::int64_t count = std::min(span.last - x, width - wrapped);
        const TxcStatus status =
            claim_span(static_cast<std::uint32_t>(row - repeat_y * height), static_cast<std::uint32_t>(wrapped),
                       static_cast<std::uint32_t>(count), repeat_x, repeat_y);
        if (status != TXC_STATUS_OK) return status;
        x += count;
    }
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::claim_span(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                               std::int64_t repeat_y) {
    const std::size_t row_start = static_cast<std::size_t>(row) * map_->key.width;
    std::uint32_t frame = kNobody;
    if (!overlaps_itself_ && is_free(owners_.data() + row_start + first, count)) {
        const TxcStatus status = frame_for(first, row, repeat_x, repeat_y, frame);
        if (status != TXC_STATUS_OK) return status;
        std::fill_n(owners_.begin() + static_cast<std::ptrdiff_t>(row_start + first), count, frame);
        map_->covered_texels += count;
        return TXC_STATUS_OK;
    }
    for (std::uint32_t x = first; x < first + count; ++x) {
        const std::size_t texel = row_start + x;
        if (overlaps_itself_) {
            if (claimed_[texel]) continue;
            claimed_[texel] = true;
        }
        if (owners_[texel] != kNobody) {
            if (const TxcStatus status = count_overlap(x, row); status != TXC_STATUS_OK) return status;
            continue;
        }
        if (frame == kNobody) {
            if (const TxcStatus status = frame_for(x, row, repeat_x, repeat_y, frame); status != TXC_STATUS_OK)
                return status;
        }
        owners_[texel] = frame;
        ++map_->covered_texels;
    }
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::count_overlap(std::uint32_t x, std::uint32_t y) {
    LocalSpaceMap& map = *map_;
    if (map.overlap_tiles.empty()) map.overlap_tiles.resize(map.tile_of.size());
    auto& claims = map.overlap_tiles[y / kTileSize * map.tile_columns() + x / kTileSize];
    constexpr std::uint32_t kTileTexels = kTileSize * kTileSize;
    if (claims == nullptr) {
        if (const TxcStatus status = map.share.resize(map.share.bytes() + kTileTexels, "counting overlaps");
            status != TXC_STATUS_OK)
            return status;
        claims = std::make_unique<std::uint8_t[]>(kTileTexels);
        std::fill_n(claims.get(), kTileTexels, std::uint8_t{1});
    }
    std::uint8_t& claim = claims[y % kTileSize * kTileSize + x % kTileSize];
    if (claim == 1) ++map.overlapping_texels;
    if (claim < 255) ++claim;
    return TXC_STATUS_OK;
}

TxcStatus MapBaker::frame_for(std::uint32_t x, std::uint32_t y, std::int64_t repeat_x, std::int64_t repeat_y,
                              std::uint32_t& out_frame) {
    for (auto open = open_frames_.rbegin(); open != open_frames_.rend(); ++open) {
        if (open->repeat_x == repeat_x && open->repeat_y == repeat_y) {
            out_frame = open->frame;
            return TXC_STATUS_OK;
        }
    }
    std::vector<TexelFrame>& frames = map_->frames;
    if (frames.size() == frames.capacity()) {
        const std::size_t larger = std::max<std::size_t>(1024, frames.size() + frames.size() / 2);
        const std::uint64_t added = (larger - frames.size()) * sizeof(TexelFrame);
        if (const TxcStatus status = map_->share.resize(map_->share.bytes() + added, "baking the map");
            status != TXC_STATUS_OK)
            return status;
        frames.reserve(larger);
    }
    out_frame = static_cast<std::uint32_t>(frames.size());
    frames.push_back(make_frame(x, y, repeat_x, repeat_y));
    open_frames_.push_back({repeat_x, repeat_y, out_frame});
    return TXC_STATUS_OK;
}

TexelFrame MapBaker::make_frame(std::uint32_t x, std::uint32_t y, std::int64_t repeat_x, std::int64_t repeat_y) const {
    const Triangle& triangle = mesh_.triangles[triangle_];
    const double area = texels_.doubled_area();
    const double ab_x = texels_.x[1] - texels_.x[0];
    const double ab_y = texels_.y[1] - texels_.y[0];
    const double ac_x = texels_.x[2] - texels_.x[0];
    const double ac_y = texels_.y[2] - texels_.y[0];
    const double at_x = static_cast<double>(x) + 0.5 + static_cast<double>(repeat_x * map_->key.width) - texels_.x[0];
    const double at_y = static_cast<double>(y) + 0.5 + static_cast<double>(repeat_y * map_->key.height) - texels_.y[0];
    // Barycentric weights of the second and third corner, and how they change a texel to the right and a texel down.
    const double b = (at_x * ac_y - at_y * ac_x) / area;
    const double c = (ab_x * at_y - ab_y * at_x) / area;
    const double b_dx = ac_y / area;
    const double b_dy = -ac_x / area;
    const double c_dx = -ab_y / area;
    const double c_dy = ab_x / area;

    const glm::dvec3 p0(mesh_.positions[triangle.vertex[0]]);
    const glm::dvec3 p01 = glm::dvec3(mesh_.positions[triangle.vertex[1]]) - p0;
    const glm::dvec3 p02 = glm::dvec3(mesh_.positions[triangle.vertex[2]]) - p0;
    TexelFrame frame{};
    frame.position = glm::vec3(p0 + p01 * b + p02 * c);
    frame.position_dx = finite_or_zero(p01 * b_dx + p02 * c_dx);
    frame.position_dy = finite_or_zero(p01 * b_dy + p02 * c_dy);
    frame.x0 = static_cast<std::int32_t>(x);
    frame.y0 = static_cast<std::int32_t>(y);
    frame.triangle = triangle_;

    const glm::dvec3 n0(mesh_.normals[triangle.vertex[0]]);
    const glm::dvec3 n1(mesh_.normals[triangle.vertex[1]]);
    const glm::dvec3 n2(mesh_.normals[triangle.vertex[2]]);
    const glm::dvec3 n = n0 + (n1 - n0) * b + (n2 - n0) * c;
    const glm::dvec3 zero(0.0);
    if (n0 == zero || n1 == zero || n2 == zero || glm::dot(n, n) < 1e-12) {
        frame.normal = mesh_.flat_normal(triangle);
    } else {
        frame.normal = glm::vec3(n);
        frame.normal_dx = finite_or_zero((n1 - n0) * b_dx + (n2 - n0) * c_dx);
        frame.normal_dy = finite_or_zero((n1 - n0) * b_dy + (n2 - n0) * c_dy);
    }
    return frame;
}

// ---- Gutter -----------------------------------------------------------------------------------------------------------

void MapBaker::measure_row(std::uint32_t row) {
    const std::uint32_t width = map_->key.width;
    const std::uint32_t* owners = owners_.data() + static_cast<std::size_t>(row) * width;
    std::int8_t* distances = row_distances_.data() + static_cast<std::size_t>(row) * width;
    nearest_in_row(owners, kNobody, width, map_->key.gutter, distances);
    std::uint8_t* near = near_tiles_.data() + static_cast<std::size_t>(row / kTileSize) * map_->tile_columns();
    for (std::uint32_t column = 0; column < map_->tile_columns(); ++column) {
        if (near[column] != 0) continue;
        const std::uint32_t x_end = std::min((column + 1) * kTileSize, width);
        for (std::uint32_t x = column * kTileSize; x < x_end && near[column] == 0; ++x) {
            near[column] = distances[x] != kNoNeighbour ? 1 : 0;
        }
    }
}

bool MapBaker::may_have_texels(std::uint32_t row, std::uint32_t tile_column) const {
    const std::uint32_t gutter = map_->key.gutter;
    const std::uint32_t first = (row > gutter ? row - gutter : 0) / kTileSize;
    const std::uint32_t last = std::min(row + gutter, map_->key.height - 1) / kTileSize;
    for (std::uint32_t tile_row = first; tile_row <= last; ++tile_row) {
        if (near_tiles_[static_cast<std::size_t>(tile_row) * map_->tile_columns() + tile_column] != 0) return true;
    }
    return false;
}

void MapBaker::find_gutter_row(std::uint32_t row) {
    static constexpr std::int8_t kAllOwned[kTileSize] = {};
    const MapKey& key = map_->key;
    const std::uint32_t* owners = owners_.data() + static_cast<std::size_t>(row) * key.width;
    const std::int8_t* distances = row_distances_.data() + static_cast<std::size_t>(row) * key.width;
    for (std::uint32_t column = 0; column < map_->tile_columns(); ++column) {
        const std::uint32_t x_begin = column * kTileSize;
        const std::uint32_t x_end = std::min(x_begin + kTileSize, key.width);
        if (x_end - x_begin == kTileSize && std::memcmp(distances + x_begin, kAllOwned, kTileSize) == 0) {
            std::uint32_t changes = 0;
            for (std::uint32_t x = x_begin + 1; x < x_end; ++x) changes += owners[x] != owners[x - 1] ? 1 : 0;
            run_count_ += 1 + changes;
            continue;
        }
        if (!may_have_texels(row, column)) continue;
        std::uint32_t before = kNobody;
        for (std::uint32_t x = x_begin; x < x_end; ++x) {
            if (distances[x] != 0) extend_to(x, row);
            if (owners[x] != kNobody && owners[x] != before) ++run_count_;
            before = owners[x];
        }
    }
}

void MapBaker::extend_to(std::uint32_t x, std::uint32_t row) {
    const MapKey& key = map_->key;
    const NearestTexel nearest = nearest_owned(row_distances_, key.width, key.height, key.gutter, x, row);
    if (!nearest.found) return;
    // Rows above are marked already, but a covered texel's own entry never carries a mark.
    const std::uint32_t owner =
        owners_[static_cast<std::size_t>(nearest.y) * key.width + static_cast<std::size_t>(nearest.x)];
    const TexelFrame& frame = map_->frames[owner];
    const glm::vec3 there = frame.normal_at(nearest.x, nearest.y);
    const glm::vec3 here = frame.normal_at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(row));
    const float cosine = glm::dot(there, here);
    const bool keeps_side = cosine > 0.0f && cosine * cosine >= 0.25f * glm::dot(there, there) * glm::dot(here, here);
    owners_[static_cast<std::size_t>(row) * key.width + x] = owner | kGutterMark | (keeps_side ? 0u : kHoldNormalMark);
    ++map_->gutter_texels;
}

// ---- Packing ----------------------------------------------------------------------------------------------------------

TxcStatus MapBaker::begin_packing() {
    LocalSpaceMap& map = *map_;
    row_distances_ = {};
    near_tiles_ = {};
    map.frames.shrink_to_fit();
    const std::uint64_t tiles = map.tile_of.size();
    const std::uint64_t groups =
        tiles / (TileTree::kGroupSize * TileTree::kGroupSize) + map.tile_columns() + map.tile_rows() + 1;
    const std::uint64_t bytes =
        map.byte_count() + run_count_ * sizeof(TexelRun) + tiles * sizeof(MapTile) + groups * 32;
    if (const TxcStatus status = map.share.resize(bytes, "baking the map"); status != TXC_STATUS_OK) return status;
    map.runs.reserve(static_cast<std::size_t>(run_count_));
    return TXC_STATUS_OK;
}

void MapBaker::pack_tile_row(std::uint32_t tile_row) {
    for (std::uint32_t column = 0; column < map_->tile_columns(); ++column) pack_tile(tile_row, column);
}

void MapBaker::pack_tile(std::uint32_t tile_row, std::uint32_t tile_column) {
    LocalSpaceMap& map = *map_;
    const std::uint32_t x_end = std::min(map.key.width - tile_column * kTileSize, kTileSize);
    const std::uint32_t y_end = std::min(map.key.height - tile_row * kTileSize, kTileSize);
    MapTile tile{};
    tile.index = tile_row * map.tile_columns() + tile_column;
    tile.first_run = static_cast<std::uint32_t>(map.runs.size());
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(-std::numeric_limits<float>::max());
    for (std::uint32_t y = 0; y < y_end; ++y) {
        const std::uint32_t* owners = owners_.data() +
                                      static_cast<std::size_t>(tile_row * kTileSize + y) * map.key.width +
                                      tile_column * kTileSize;
        for (std::uint32_t x = 0; x < x_end;) {
            const std::uint32_t owner = owners[x];
            std::uint32_t end = x + 1;
            while (end < x_end && owners[end] == owner) ++end;
            if (owner != kNobody) {
                std::uint8_t flags = (owner & kGutterMark) != 0 ? kRunGutter : 0;
                if ((owner & kHoldNormalMark) != 0) flags |= kRunHoldNormal;
                map.runs.push_back({owner & kFrameMask, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                    static_cast<std::uint8_t>(end - x), flags});
                const TexelFrame& frame = map.frames[owner & kFrameMask];
                const auto run_x =
                    static_cast<float>(static_cast<std::int32_t>(tile_column * kTileSize + x) - frame.x0);
                const auto run_y = static_cast<float>(static_cast<std::int32_t>(tile_row * kTileSize + y) - frame.y0);
                const glm::vec3 first = frame.position + frame.position_dx * run_x + frame.position_dy * run_y;
                const glm::vec3 last = first + frame.position_dx * static_cast<float>(end - x - 1);
                // The footprints reach half a texel beyond the first and last centre, and above and below.
                const glm::vec3 reach = (glm::abs(frame.position_dx) + glm::abs(frame.position_dy)) * 0.5f;
                low = glm::min(low, glm::min(first, last) - reach);
                high = glm::max(high, glm::max(first, last) + reach);
            }
            x = end;
        }
    }
    tile.run_count = static_cast<std::uint32_t>(map.runs.size()) - tile.first_run;
    if (tile.run_count == 0) return;
    tile.box = {low, high};
    map.tile_of[tile.index] = static_cast<std::uint32_t>(map.tiles.size());
    map.tiles.push_back(tile);
}

}  // namespace txc
