#include "tile_patch.h"

#include <algorithm>
#include <limits>

#include "local_space_map.h"

namespace txc {
namespace {

static_assert(kTileSize == 16, "a row's coverage is 16 bits");

// Fewer texels are painted as soon run by run.
constexpr std::uint32_t kFewestTexels = 8;
// Frames that differ by more than this share of the longest side differ too much from any side.
constexpr float kMostSpread = 0.3f;
constexpr float kLargestWhole = 32767.0f;

/// Bounds lane by lane.
struct Bounds4 {
    Float4 low = splat(std::numeric_limits<float>::max());
    Float4 high = splat(-std::numeric_limits<float>::max());

    void add(Float4 v) {
        low = lesser(low, v);
        high = greater(high, v);
    }
    Float4 middle() const { return (low + high) * splat(0.5f); }
    Float4 half() const { return (high - low) * splat(0.5f); }
};

/// A frame's vectors as they are needed texel by texel.
struct PatchFrame {
    std::uint32_t index = kNoTile;
    std::int32_t x0 = 0;
    std::int32_t y0 = 0;
    Float4 position{}, position_dx{}, position_dy{};
    Float4 normal{}, normal_dx{}, normal_dy{};

    void look_at(const LocalSpaceMap& map, std::uint32_t frame_index) {
        if (index == frame_index) return;
        index = frame_index;
        const TexelFrame& frame = map.frames[frame_index];
        using Coordinate = TexelFrame::Coordinate;
        const auto load = [](const Coordinate(&of)[3], float Coordinate::*part) {
            return load_vec3(TexelFrame::part(of, part));
        };
        x0 = frame.x0;
        y0 = frame.y0;
        position = load(frame.position, &Coordinate::at);
        position_dx = load(frame.position, &Coordinate::dx);
        position_dy = load(frame.position, &Coordinate::dy);
        normal = load(frame.normal, &Coordinate::at);
        normal_dx = load(frame.normal, &Coordinate::dx);
        normal_dy = load(frame.normal, &Coordinate::dy);
    }
};

float largest_lane(Float4 v) { return std::max(v[0], std::max(v[1], v[2])); }
float dot3(Float4 a, Float4 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct TileCorner {
    std::int32_t x, y;
    TileCorner(const LocalSpaceMap& map, const MapTile& tile)
        : x(static_cast<std::int32_t>(tile.index % map.tile_columns() * kTileSize)),
          y(static_cast<std::int32_t>(tile.index / map.tile_columns() * kTileSize)) {}
};

void make_patch(const LocalSpaceMap& map, const MapTile& tile, TilePatch& out) {
    out = TilePatch{};
    const TileCorner corner(map, tile);
    Bounds4 positions;
    Bounds4 across;
    Bounds4 down;
    Bounds4 normals;
    float longest = 0.0f;
    std::uint32_t count = 0;
    PatchFrame frame;
    map.for_each_run_of(tile, [&](const TexelRun& run) {
        if (frame.index != run.frame) {
            frame.look_at(map, run.frame);
            across.add(frame.position_dx);
            down.add(frame.position_dy);
        }
        const Float4 right = splat(static_cast<float>(corner.x + run.x - frame.x0));
        const Float4 below = splat(static_cast<float>(corner.y + run.y - frame.y0));
        const Float4 length = splat(static_cast<float>(run.length - 1));
        const Float4 first = frame.position + frame.position_dx * right + frame.position_dy * below;
        positions.add(first);
        positions.add(first + frame.position_dx * length);
        const auto add_normal = [&](Float4 normal) {
            normals.add(normal);
            longest = std::max(longest, dot3(normal, normal));
        };
        if ((run.flags & kRunHoldNormal) != 0) {
            add_normal(frame.normal);
        } else {
            const Float4 normal = frame.normal + frame.normal_dx * right + frame.normal_dy * below;
            add_normal(normal);
            add_normal(normal + frame.normal_dx * length);
        }
        out.there.add(run.x, run.y, (1u << run.length) - 1);
        count += run.length;
    });
    out.there.is_full = count == kTileSize * kTileSize;
    out.longest_normal = std::sqrt(longest);
    out.middle = positions.middle();
    // A flat tile has no extent along one axis: any step does for it.
    out.step = greater(positions.half() * splat(1.0f / kLargestWhole), splat(1e-30f));
    out.across = across.middle();
    out.across_spread = across.half();
    out.down = down.middle();
    out.down_spread = down.half();
    out.normal = normals.middle();
    out.normal_spread = normals.half();
    const float side = std::max(largest_lane(absolute(out.across)), largest_lane(absolute(out.down)));
    const float spread = std::max(largest_lane(out.across_spread), largest_lane(out.down_spread));
    const bool is_uniform = count >= kFewestTexels && spread <= kMostSpread * side;
    out.state = is_uniform ? TilePatch::State::kUniform : TilePatch::State::kBounds;
}

/// Charts are continued into their gutters triangle by triangle, which leaves small steps there: up to half a texel is none.
bool is_continuous(const TilePatch& patch, const PatchTexels& texels, Float4 wholes) {
    const float side = std::max(largest_lane(absolute(patch.across)), largest_lane(absolute(patch.down)));
    const Float4 slack = splat(0.5f * side) * wholes + splat(2.0f);
    const auto is_there = [&](std::size_t at) {
        return (patch.there.rows[at / kTileSize] >> at % kTileSize & 1u) != 0;
    };
    const auto joins = [&](std::size_t at, std::size_t next, Float4 step, Float4 spread) {
        if (!is_there(at) || !is_there(next)) return true;
        return !any_lane(absolute(texels.at(next) - texels.at(at) - step * wholes) > spread * wholes + slack);
    };
    for (std::size_t at = 0; at < 256; ++at) {
        if ((at + 1) % kTileSize != 0 && !joins(at, at + 1, patch.across, patch.across_spread)) return false;
        if (at + kTileSize < 256 && !joins(at, at + kTileSize, patch.down, patch.down_spread)) return false;
    }
    return true;
}

void make_texels(const LocalSpaceMap& map, const MapTile& tile, TilePatch& patch, PatchTexels& out) {
    if (!patch.there.is_full) out = PatchTexels{};
    const TileCorner corner(map, tile);
    const Float4 wholes = {1.0f / patch.step[0], 1.0f / patch.step[1], 1.0f / patch.step[2], 0.0f};
    const Float4 most = splat(kLargestWhole);
    PatchFrame frame;
    map.for_each_run_of(tile, [&](const TexelRun& run) {
        frame.look_at(map, run.frame);
        const Float4 right = splat(static_cast<float>(corner.x + run.x - frame.x0));
        const Float4 below = splat(static_cast<float>(corner.y + run.y - frame.y0));
        const Float4 first = frame.position + frame.position_dx * right + frame.position_dy * below;
        const Float4 start = (first - patch.middle) * wholes;
        const Float4 change = frame.position_dx * wholes;
        const std::size_t at = std::size_t{run.y} * kTileSize + run.x;
        for (std::size_t i = 0; i < run.length; ++i) {
            const Float4 place = start + change * splat(static_cast<float>(i));
            const Int4 whole = round_to_int(greater(lesser(place, most), -most));
            out.xy[at + i] =
                (whole[0] & 0xffff) | static_cast<std::int32_t>(static_cast<std::uint32_t>(whole[1]) << 16);
            out.z[at + i] = static_cast<std::int16_t>(whole[2]);
        }
    });
    using Continuity = TilePatch::Continuity;
    if (patch.continuity == Continuity::kUnasked)
        patch.continuity = is_continuous(patch, out, wholes) ? Continuity::kWhole : Continuity::kBroken;
}

}  // namespace

/// Half of the budget stays for all else.
bool TilePatches::has_room(std::uint64_t bytes) { return share_.resize_within_half(share_.bytes() + bytes); }

const TilePatch& TilePatches::find(const LocalSpaceMap& map, std::uint32_t place) {
    if (patches_.empty() && has_room(map.tiles.size() * (sizeof(TilePatch) + sizeof(std::unique_ptr<PatchTexels>)))) {
        patches_.resize(map.tiles.size());
        texels_.resize(map.tiles.size());
    }
    TilePatch& patch = patches_.empty() ? unkept_ : patches_[place];
    if (patches_.empty() || patch.state == TilePatch::State::kUnmade) make_patch(map, map.tiles[place], patch);
    return patch;
}

const PatchTexels& TilePatches::texels(const LocalSpaceMap& map, std::uint32_t place) {
    if (!texels_.empty() && texels_[place] != nullptr) return *texels_[place];
    const bool keeps = !texels_.empty() && has_room(sizeof(PatchTexels));
    std::unique_ptr<PatchTexels>& made = keeps ? texels_[place] : unkept_texels_;
    if (made == nullptr) made = std::make_unique<PatchTexels>();
    make_texels(map, map.tiles[place], patches_.empty() ? unkept_ : patches_[place], *made);
    return *made;
}

}  // namespace txc
