#include "stroke.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "sorted_keys.h"

namespace txc {
namespace {

constexpr std::size_t kTileValues = kTileTexels * 4;
constexpr const char* kPainting = "painting a stroke";

// A dab's projector and a layer's are the same fields in the same order.
constexpr std::size_t kProjectorBytes = sizeof(TxcDab) - offsetof(TxcDab, position_model);
static_assert(offsetof(TxcLayerDef, color) - offsetof(TxcLayerDef, position_model) == kProjectorBytes);
static_assert(offsetof(TxcLayerDef, uv_angle_degrees) - offsetof(TxcLayerDef, position_model) ==
              offsetof(TxcDab, uv_angle_degrees) - offsetof(TxcDab, position_model));

/// The stroke's tiles while dabs come down. Tiles that it reaches for the first time are kept apart, in the order in which
/// they were reached, and sorted in together: one by one they would push half of the others along each time.
class TilesUnderWay {
public:
    TilesUnderWay(LayerTiles& tiles, MemoryBudget& budget) : tiles_(tiles), fresh_(budget), place_share_(budget) {}

    TxcStatus begin(std::uint32_t tile_count) {
        if (const TxcStatus status = grow_counted(places_, tile_count, place_share_, kPainting);
            status != TXC_STATUS_OK)
            return status;
        places_.assign(tile_count, kNowhere);
        find_places();
        return TXC_STATUS_OK;
    }

    /// The texels of a tile, all 0 where the stroke did not have it. They stay in place until the next call.
    TxcStatus reach(std::uint32_t tile, std::uint16_t*& out_texels) {
        if (places_[tile] == kNowhere) {
            if (fresh_.indices.size() >= kMostFresh) {
                if (const TxcStatus status = merge(); status != TXC_STATUS_OK) return status;
            }
            const std::size_t count = fresh_.indices.size() + 1;
            if (const TxcStatus status = make_room(fresh_, count); status != TXC_STATUS_OK) return status;
            fresh_.texels.resize(count * kTileValues);
            clear_tile(fresh_.texels.data() + (count - 1) * kTileValues);
            fresh_.indices.push_back(tile);
            places_[tile] = kFresh | static_cast<std::uint32_t>(count - 1);
        }
        const std::uint32_t place = places_[tile];
        LayerTiles& holder = (place & kFresh) != 0 ? fresh_ : tiles_;
        out_texels = holder.texels.data() + (place & ~kFresh) * kTileValues;
        return TXC_STATUS_OK;
    }

    /// Sorts the fresh tiles in: from the last to the first, each to where it stays.
    TxcStatus merge() {
        const std::size_t fresh_count = fresh_.indices.size();
        if (fresh_count == 0) return TXC_STATUS_OK;
        std::size_t old_count = tiles_.indices.size();
        std::size_t to = old_count + fresh_count;
        if (const TxcStatus status = make_room(tiles_, to); status != TXC_STATUS_OK) return status;
        tiles_.indices.resize(to);
        tiles_.texels.resize(to * kTileValues);
        std::vector<std::uint64_t> order(fresh_count);  // tile above place
        for (std::uint32_t i = 0; i < fresh_count; ++i) order[i] = std::uint64_t{fresh_.indices[i]} << 32 | i;
        sort_keys(order);
        for (std::size_t next = fresh_count; next > 0;) {
            const auto fresh = static_cast<std::uint32_t>(order[next - 1]);
            --to;
            if (old_count > 0 && tiles_.indices[old_count - 1] > fresh_.indices[fresh]) {
                --old_count;
                put(to, tiles_, old_count);
            } else {
                --next;
                put(to, fresh_, fresh);
            }
        }
        fresh_.indices.clear();
        fresh_.texels.clear();
        find_places();
        return TXC_STATUS_OK;
    }

private:
    static constexpr std::uint32_t kNowhere = 0xffffffffu;
    static constexpr std::uint32_t kFresh = 0x80000000u;
    static constexpr std::size_t kMostFresh = 4096;  // 8 MiB

    static TxcStatus make_room(LayerTiles& tiles, std::size_t count) {
        const TxcStatus status = grow_counted(tiles.texels, count * kTileValues, tiles.share, kPainting);
        return status == TXC_STATUS_OK ? grow_counted(tiles.indices, count, tiles.share, kPainting) : status;
    }

    void put(std::size_t to, const LayerTiles& from, std::size_t place) {
        tiles_.indices[to] = from.indices[place];
        std::memcpy(tiles_.texels.data() + to * kTileValues, from.texels.data() + place * kTileValues,
                    kTileValues * sizeof(std::uint16_t));
    }

    void find_places() {
        for (std::uint32_t i = 0; i < tiles_.indices.size(); ++i) places_[tiles_.indices[i]] = i;
    }

    LayerTiles& tiles_;
    LayerTiles fresh_;                   // unsorted
    std::vector<std::uint32_t> places_;  // per tile of the map: in tiles_, or with kFresh in fresh_
    BudgetShare place_share_;
};

/// How a dab's texels become what goes over the stroke: premultiplied, on the scale of kFullScale.
struct Ink {
    Float4 gain;
    bool is_mask;

    Ink(const Brush& brush, float flow) : gain(splat(flow)), is_mask(brush.is_mask) {
        if (!is_mask) return;
        gain = brush.color * splat(brush.color[3] * flow);
        gain[3] = brush.color[3] * flow;
    }
    Float4 of(Float4 texel) const { return (is_mask ? splat(texel[3]) : texel) * gain; }
};

/// Source over, all premultiplied: of n equal dabs of flow f remains (1 - f)^n of what was below. Where a dab is solid the
/// rest is 0 to the last bit.
void lay_over(const std::uint16_t* dab, const Ink& ink, std::uint16_t* below) {
    for (std::uint32_t t = 0; t < kTileTexels; ++t) {
        if (dab[t * 4 + 3] == 0) continue;
        const Float4 source = ink.of(load_ushort4(dab + t * 4));
        const Float4 rest = splat(1.0f - source[3] / kFullScale);
        store_rounded_ushort4(below + t * 4, source + load_ushort4(below + t * 4) * rest);
    }
}

// Texels across a dab whose texels are not looked at one by one: its tip is then sharp enough for most.
constexpr double kUsualTexelsAcross = 200.0;

/// How many texels a dab is wide where they are finest. Of a frame that is seen askew its longer side counts.
double texels_across(const LocalSpaceMap& map, const PictureCast& cast, std::vector<std::uint32_t>& tiles) {
    if (cast.projector != TXC_PROJECTOR_PLANAR) return kUsualTexelsAcross;
    map.tree.find(map, cast.settings.projector.to_decal, tiles);
    float finest = 1.0f;  // the square of a texel's side, in dabs
    std::uint32_t frame = 0xffffffffu;
    for (const std::uint32_t tile : tiles) {
        map.for_each_run_of(map.tiles[tile], [&](const TexelRun& run) {
            if (run.frame == frame) return;
            frame = run.frame;
            const ProjectedFrame seen = project_frame(cast.settings.projector, map.frames[frame]);
            const float across = seen.dx[0] * seen.dx[0] + seen.dx[1] * seen.dx[1];
            const float down = seen.dy[0] * seen.dy[0] + seen.dy[1] * seen.dy[1];
            finest = std::min(finest, std::max(across, down));
        });
    }
    return 1.0 / std::sqrt(std::max(static_cast<double>(finest), 1e-12));
}

}  // namespace

TxcDab dab_from_def(const TxcLayerDef& def) {
    TxcDab dab{};
    dab.flow = 1.0f;
    dab.projector = def.projector;
    std::memcpy(reinterpret_cast<char*>(&dab) + offsetof(TxcDab, position_model),
                reinterpret_cast<const char*>(&def) + offsetof(TxcLayerDef, position_model), kProjectorBytes);
    return dab;
}

TxcStatus read_dab(const TxcDab& dab, PictureCast& cast) {
    if (!(dab.flow >= 0.0f && dab.flow <= 1.0f))
        return fail(TXC_STATUS_BAD_ARGUMENT, "flow is %g; it must be from 0 to 1", static_cast<double>(dab.flow));
    if (dab.projector >= TXC_PROJECTOR_COUNT) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "projector is %u; it must be below %d", dab.projector,
                    TXC_PROJECTOR_COUNT);
    }
    if (dab.flip_x > 1) return fail(TXC_STATUS_BAD_ARGUMENT, "flip_x is %u; it must be below 2", dab.flip_x);
    TxcLayerDef def{};
    def.projector = dab.projector;
    std::memcpy(reinterpret_cast<char*>(&def) + offsetof(TxcLayerDef, position_model),
                reinterpret_cast<const char*>(&dab) + offsetof(TxcDab, position_model), kProjectorBytes);
    return cast.read_projector(def);
}

TxcStatus Stroke::add(const TxcDab* added, std::uint32_t count) {
    if (count > TXC_MAX_DABS || dabs.size() + count > TXC_MAX_DABS) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "dab_count is %u, beside %zu dabs; a stroke takes at most %u", count,
                    dabs.size(), TXC_MAX_DABS);
    }
    PictureCast cast;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (const TxcStatus status = read_dab(added[i], cast); status != TXC_STATUS_OK) {
            const std::string reason = error_detail();
            return fail(status, "dabs[%u]: %s", i, reason.c_str());
        }
    }
    if (const TxcStatus status = grow_counted(dabs, dabs.size() + count, share, "a stroke's dabs");
        status != TXC_STATUS_OK)
        return status;
    dabs.insert(dabs.end(), added, added + count);
    return TXC_STATUS_OK;
}

void Stroke::clear() {
    dabs = decltype(dabs)();
    round_tips.reset();
    painted = 0;
    share.release();
}

TxcStatus paint_dabs(const CastScene& scene, PictureCast cast, const Brush& brush, const std::vector<TxcDab>& dabs,
                     std::size_t& first, LayerTiles& tiles, std::vector<std::uint8_t>& dirty_tiles, WorkLeft& work_left,
                     std::uint64_t& out_texels) {
    out_texels = 0;
    TilesUnderWay under_way(tiles, scene.budget);
    if (const TxcStatus status = under_way.begin(static_cast<std::uint32_t>(dirty_tiles.size()));
        status != TXC_STATUS_OK)
        return status;
    LayerTiles dab_tiles(scene.budget);  // one for all dabs
    std::vector<std::uint32_t> near_tiles;
    const bool flip_x = cast.settings.flip_x;
    for (; first < dabs.size() && work_left.any(); ++first) {
        const TxcDab& dab = dabs[first];
        const float flow = brush.flow * dab.flow;
        if (!(flow > 0.0f)) continue;
        if (const TxcStatus status = read_dab(dab, cast); status != TXC_STATUS_OK) return status;
        cast.settings.flip_x = flip_x != (dab.flip_x != 0);
        const ImagePyramid* picture = brush.picture;
        if (brush.round_tips != nullptr) {
            const TxcStatus status = brush.round_tips->find(texels_across(scene.map, cast, near_tiles), picture);
            if (status != TXC_STATUS_OK) return status;
        }
        std::uint32_t texels = 0;
        if (const TxcStatus status = cast_picture(scene, cast, *picture, dab_tiles, texels); status != TXC_STATUS_OK)
            return status;
        out_texels += texels;
        work_left.spend(texels);
        const Ink ink(brush, flow);
        for (std::size_t t = 0; t < dab_tiles.indices.size(); ++t) {
            const std::uint32_t tile = dab_tiles.indices[t];
            std::uint16_t* below = nullptr;
            if (const TxcStatus status = under_way.reach(tile, below); status != TXC_STATUS_OK) return status;
            lay_over(dab_tiles.texels.data() + t * kTileValues, ink, below);
            dirty_tiles[tile] = 1;
        }
    }
    return under_way.merge();
}

void release_tiles(LayerTiles& tiles) {
    tiles.indices = decltype(tiles.indices)();
    tiles.texels = decltype(tiles.texels)();
    tiles.share.release();
}

}  // namespace txc
