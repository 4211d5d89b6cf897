#include "patch_painter.h"

#include <algorithm>
#include <cstring>

#include "bilinear.h"
#include "layer_tiles.h"
#include "short8.h"

namespace txc {
namespace {

/// Two neighbours on a straight line, channel by channel.
Int4 pair_up(Int4 a, Int4 b) { return (a & 0xffff) | (b << 16); }

/// A colour on the way from one to the other.
template <int kStep, int kSteps>
Int4 between(Int4 pairs) {
    constexpr std::int32_t kShare = (kWeightOne * kStep + kSteps / 2) / kSteps;
    return dot_halves(pairs, splat((kShare << 16) + (kWeightOne - kShare))) >> kWeightBits;
}

/// Of lists of places, of which each lane of one is the least of its kind and of the other the greatest.
PlaceBounds bounds_of(Int4 least_x, Int4 least_y, Int4 most_x, Int4 most_y) {
#if defined(__wasm_simd128__)
    const auto v = [](Int4 lanes) { return reinterpret_cast<v128_t>(lanes); };
    const v128_t least = wasm_i32x4_min(wasm_i32x4_shuffle(v(least_x), v(least_y), 0, 4, 1, 5),
                                        wasm_i32x4_shuffle(v(least_x), v(least_y), 2, 6, 3, 7));
    const v128_t most = wasm_i32x4_max(wasm_i32x4_shuffle(v(most_x), v(most_y), 0, 4, 1, 5),
                                       wasm_i32x4_shuffle(v(most_x), v(most_y), 2, 6, 3, 7));
    const v128_t low = wasm_i32x4_min(least, wasm_i64x2_shuffle(least, least, 1, 0));
    const v128_t high = wasm_i32x4_max(most, wasm_i64x2_shuffle(most, most, 1, 0));
    return reinterpret_cast<PlaceBounds>(wasm_i64x2_shuffle(low, high, 0, 2));
#else
    const auto low = [](Int4 v) { return std::min(std::min(v[0], v[1]), std::min(v[2], v[3])); };
    const auto high = [](Int4 v) { return std::max(std::max(v[0], v[1]), std::max(v[2], v[3])); };
    return PlaceBounds{low(least_x), low(least_y), high(most_x), high(most_y)};
#endif
}

/// What the loops over a tile have at hand: in registers, since what lies behind a reference would be read anew after every
/// store.
struct Ground {
    const std::int16_t* pixels;
    std::int32_t stride;
    PatchView view;

    __attribute__((always_inline)) void find(Int4 xy, Int4 z, Int4& x, Int4& y) const {
        x = turn(xy, z, view.xy_to_x, view.z_to_x, view.base_x, view.least_x, view.most_x);
        y = turn(xy, z, view.xy_to_y, view.z_to_y, view.base_y, view.least_y, view.most_y);
    }
    template <int kLane>
    __attribute__((always_inline)) Int4 sample(const SamplePlaces& places) const {
        return sample_lane<kLane>(pixels, stride, places);
    }

private:
    __attribute__((always_inline)) Int4 turn(Int4 xy, Int4 z, Int4 by_xy, Int4 by_z, std::int32_t base,
                                             std::int32_t least, std::int32_t most) const {
        const Int4 place = ((dot_halves(xy, by_xy) + dot_halves(z, by_z)) >> kSlopeBits) + splat(base);
        return lesser(greater(place, splat(least)), splat(most));
    }
};

constexpr std::int16_t kFifth = (32768 + 2) / 5;
constexpr std::int16_t kThird = (32768 + 1) / 3;
constexpr Short8 kSecondTexel = {0, 0, 0, 0, -1, -1, -1, -1};

/// A row of a tile: the colours of its texels 0 and 5, 10 and 15, and the changes from a texel to the next in between.
struct FiveChords {
    Short8 ab, cd;
    Short8 steps_ab;  // from a, from b
    Short8 step_c;    // twice

    FiveChords() = default;
    FiveChords(Short8 first, Short8 second, Short8& overflow) : ab(first), cd(second) {
        steps_ab = part_of(subtract(pick<1, 2>(ab, cd), ab, overflow), kFifth);
        step_c = part_of(subtract(pick<1, 1>(cd, cd), pick<0, 0>(cd, cd), overflow), kFifth);
    }

    /// The change from a row to the next, of which `below` is the fifth.
    FiveChords step_to(const FiveChords& below, Short8& overflow) const {
        FiveChords step;
        step.ab = part_of(subtract(below.ab, ab, overflow), kFifth);
        step.cd = part_of(subtract(below.cd, cd, overflow), kFifth);
        step.steps_ab = part_of(below.steps_ab - steps_ab, kFifth);
        step.step_c = part_of(below.step_c - step_c, kFifth);
        return step;
    }
    void go(const FiveChords& step) {
        ab = add_clamped(ab, step.ab);
        cd = add_clamped(cd, step.cd);
        steps_ab += step.steps_ab;
        step_c += step.step_c;
    }

    /// Rounded steps may go by a hair beyond full; black they cannot leave.
    void store(std::uint16_t* out) const {
        const Short8 step_a = pick<0, 0>(steps_ab, steps_ab);
        const Short8 step_b = pick<1, 1>(steps_ab, steps_ab);
        const Short8 two_a = step_a + step_a;
        const Short8 two_b = step_b + step_b;
        const Short8 two_c = step_c + step_c;
        Short8 two = add_clamped(pick<0, 0>(ab, ab), step_a & kSecondTexel);
        store_texels(out, two);
        two = add_clamped(two, two_a);
        store_texels(out + 8, two);
        store_texels(out + 16, pick<0, 3>(add_clamped(two, two_a), ab));
        two = add_clamped(pick<1, 1>(ab, ab), step_b + (step_b & kSecondTexel));
        store_texels(out + 24, two);
        store_texels(out + 32, add_clamped(two, two_b));
        two = add_clamped(pick<0, 0>(cd, cd), step_c & kSecondTexel);
        store_texels(out + 40, two);
        two = add_clamped(two, two_c);
        store_texels(out + 48, two);
        store_texels(out + 56, pick<0, 3>(add_clamped(two, two_c), cd));
    }
};

/// A whole tile from sixteen of its texels, three by three squares of five by five. False where the picture is not as smooth
/// as that, or so steep that a square spans more than half of a channel.
///
/// (A layer that keeps such a tile as its sixteen texels, unfolded each time that it is composited, took 0.98 to 1.01 of the time and
/// 1.1 kB more of the module: a tenth of the tiles of a decal at a pixel a texel are such, and two fifths at a third.)
__attribute__((always_inline)) inline bool paint_squares(const Ground& ground, const PatchTexels& places,
                                                         std::uint16_t* texels) {
    const SmoothTest& test = ground.view.chords.tile;
    Int4 x[4];
    Int4 y[4];
    for (std::size_t r = 0; r < 4; ++r) {
        const std::int32_t* xy = places.xy + r * 5 * kTileSize;
        const std::int16_t* z = places.z + r * 5 * kTileSize;
        ground.find(Int4{xy[0], xy[5], xy[10], xy[15]}, Int4{z[0], z[5], z[10], z[15]}, x[r], y[r]);
    }
    const PlaceBounds bounds =
        bounds_of(lesser(lesser(x[0], x[1]), lesser(x[2], x[3])), lesser(lesser(y[0], y[1]), lesser(y[2], y[3])),
                  greater(greater(x[0], x[1]), greater(x[2], x[3])), greater(greater(y[0], y[1]), greater(y[2], y[3])));
    if (!test.is_smooth(bounds, ground.stride)) return false;
    Short8 overflow{};
    FiveChords rows[4];
    FiveChords steps[3];
    for (std::size_t r = 0; r < 4; ++r) {
        const SamplePlaces at = place_samples(x[r], y[r], ground.stride);
        rows[r] = FiveChords(narrow(ground.sample<0>(at), ground.sample<1>(at)),
                             narrow(ground.sample<2>(at), ground.sample<3>(at)), overflow);
        if (r > 0) steps[r - 1] = rows[r - 1].step_to(rows[r], overflow);
    }
    if (any_lane(overflow)) return false;
    for (std::size_t r = 0; r < 3; ++r) {
        FiveChords row = rows[r];
        for (int i = 0; i < 5; ++i, texels += kTileSize * 4) {
            row.store(texels);
            row.go(steps[r]);
        }
    }
    rows[3].store(texels);
    return true;
}

/// Four by four texels from those at its corners; false as paint_squares.
__attribute__((always_inline)) inline bool paint_block(const Ground& ground, const PatchTexels& places, std::size_t at,
                                                       std::uint16_t* out) {
    const SmoothTest& test = ground.view.chords.block;
    const std::int32_t* xy = places.xy + at;
    const std::int16_t* z = places.z + at;
    constexpr std::size_t kLast = 3 * kTileSize;
    Int4 x;
    Int4 y;
    ground.find(Int4{xy[0], xy[3], xy[kLast], xy[kLast + 3]}, Int4{z[0], z[3], z[kLast], z[kLast + 3]}, x, y);
    if (!test.is_smooth(bounds_of(x, y, x, y), ground.stride)) return false;
    const SamplePlaces place = place_samples(x, y, ground.stride);
    Short8 ends = narrow(ground.sample<0>(place), ground.sample<1>(place));
    const Short8 last_ends = narrow(ground.sample<2>(place), ground.sample<3>(place));
    Short8 overflow{};
    const auto step_of = [&](Short8 row) {
        return part_of(subtract(pick<1, 1>(row, row), pick<0, 0>(row, row), overflow), kThird);
    };
    Short8 step = step_of(ends);
    const Short8 last_step = step_of(last_ends);
    const Short8 ends_down = part_of(subtract(last_ends, ends, overflow), kThird);
    const Short8 step_down = part_of(last_step - step, kThird);
    if (any_lane(overflow)) return false;
    const auto store = [](std::uint16_t* to, Short8 row, Short8 along) {
        store_texels(to, add_clamped(pick<0, 0>(row, row), along & kSecondTexel));
        store_texels(to + 8, add_clamped(pick<1, 1>(row, row), -along & ~kSecondTexel));
    };
    for (int row = 0; row < 3; ++row, out += kTileSize * 4) {
        store(out, ends, step);
        ends = add_clamped(ends, ends_down);
        step += step_down;
    }
    store(out, last_ends, last_step);
    return true;
}

/// The roughness that a patch's texels are held against one by one, and where those that are too rough are left.
struct RoughSearch {
    const PyramidLevel* level;
    const Footprint* footprint;
    const std::uint8_t* roughness;
    std::int32_t limit;
    std::int32_t three;
    RoughTexel* next;

    /// Leaves one of four texels to its footprint where its lane says so. Writes in any case: no branch. (A loop over lanes goes
    /// through memory.)
    template <int kLane>
    __attribute__((always_inline)) void leave(Int4 x, Int4 y, Int4 is_rough, std::uint16_t* out) {
        *next = {level, footprint, x[kLane], y[kLane], out + kLane * 4};
        next -= is_rough[kLane];
    }
};

/// Four texels of a row. (Where one is rough three are, as a rule; but their kernels for all four at once, in place of the samples,
/// made a drag 1.01 to 1.02 times as long.) `may_join`: colours may be interpolated between the first and the last (the place of one that is not
/// there says nothing).
__attribute__((always_inline)) inline void paint_four(const Ground& ground, const PatchTexels& places, std::size_t at,
                                                      bool may_join, std::uint16_t* out, RoughSearch& search) {
    Int4 x;
    Int4 y;
    ground.find(load_int4(places.xy + at), load_short4(places.z + at), x, y);
    const SamplePlaces place = place_samples(x, y, ground.stride);
    const Int4 steps = {search.roughness[place.offset[0]], search.roughness[place.offset[1]],
                        search.roughness[place.offset[2]], search.roughness[place.offset[3]]};
    const std::int32_t most = std::max(std::max(steps[0], steps[1]), std::max(steps[2], steps[3]));
    const Int4 first = ground.sample<0>(place);
    const Int4 fourth = ground.sample<3>(place);
    if (most <= search.three && may_join) {
        const Int4 pairs = pair_up(first, fourth);
        store_texels(out, narrow(first, between<1, 3>(pairs)));
        store_texels(out + 8, narrow(between<2, 3>(pairs), fourth));
        return;
    }
    store_texels(out, narrow(first, ground.sample<1>(place)));
    store_texels(out + 8, narrow(ground.sample<2>(place), fourth));
    if (most <= search.limit) return;
    const Int4 rough = are_rough(*search.footprint, steps, x, y);
    search.leave<0>(x, y, rough, out);
    search.leave<1>(x, y, rough, out);
    search.leave<2>(x, y, rough, out);
    search.leave<3>(x, y, rough, out);
}

/// Reads one number of each line of memory that the loops below are about to read here and there, behind branches that depend on
/// what they have read: so the lines come side by side, and not one by one. (A drag takes 0.81 to 0.96 of the time. The tile's own
/// texels, which are only written, are better left alone: 1.05. So are the next tile's bounds, 1.0, and
/// the places of the next eight tiles, 0.98 at 2048 x 2048 and 1.03 at 4096 x 4096.)
inline void fetch_ahead(const Ground& ground, const PatchTexels& places, const std::uint8_t* roughness) {
    constexpr std::size_t kLine = 64;
    const PatchView& view = ground.view;
    std::int32_t read = 0;
    for (std::size_t i = 0; i < 256; i += kLine / sizeof(std::int32_t)) read ^= places.xy[i] ^ places.z[i];
    for (std::int32_t y = view.first_row; y <= view.last_row; ++y) {
        const std::int32_t row = y * ground.stride;
        for (std::int32_t x = view.first_column; x <= view.last_column; x += 8) read ^= ground.pixels[(row + x) * 4];
        read ^= roughness[row + view.first_column];
        if (view.chords.block.limit >= 0) read ^= view.chords.block.list[row + view.first_column];
    }
    asm volatile("" ::"r"(read));
}

}  // namespace

RoughTexel* paint_patch(const TileCoverage& painted, bool may_join, const PatchTexels& places, const PatchView& view,
                        const PyramidLevel& level, const Footprint& footprint, std::uint16_t* texels,
                        RoughTexel* rough) {
    const Ground ground{level.first_pixel(), level.stride(), view};
    if (may_join && painted.is_full && view.chords.tile.limit >= 0 && paint_squares(ground, places, texels))
        return rough;
    RoughSearch search{&level, &footprint, footprint.smooth_list, footprint.smooth_limit, view.chords.three, rough};
    fetch_ahead(ground, places, footprint.smooth_list);
    constexpr std::uint32_t kBlock = 4;
    for (std::uint32_t row = 0; row < kTileSize; row += kBlock) {
        const std::uint32_t blocks = painted.columns_of_four(row);
        for (std::uint32_t column = 0; column < kTileSize; column += kBlock) {
            const std::size_t at = row * kTileSize + column;
            if (may_join && (blocks >> column & 15u) == 15u && view.chords.block.limit >= 0 &&
                paint_block(ground, places, at, texels + at * 4))
                continue;
            for (std::uint32_t i = 0; i < kBlock; ++i) {
                const std::uint32_t there = painted.rows[row + i] >> column & 15u;
                if (there == 0) continue;
                const std::size_t four = at + i * kTileSize;
                paint_four(ground, places, four, may_join && there == 15u, texels + four * 4, search);
            }
        }
    }
    return search.next;
}

void fade_texels(const std::int16_t* weights, std::uint16_t* texels) {
    for (std::uint32_t i = 0; i < kTileTexels; i += 2) {
        if (weights[i] == kFullWeight && weights[i + 1] == kFullWeight) continue;
        const Short8 share = narrow(splat(std::int32_t{weights[i]}), splat(std::int32_t{weights[i + 1]}));
        std::uint16_t* const two = texels + std::size_t{i} * 4;
        // Colours around 0 are colours less a half, and of that the share is half the weight: the weight less a half, added.
        store_texels(two, (share ^ std::numeric_limits<std::int16_t>::min()) + part_of(load_texels(two), share));
    }
}

void clear_uncovered(const TileCoverage& covered, std::uint16_t* texels) {
    if (covered.is_full) return;
    for (std::uint32_t row = 0; row < kTileSize; ++row) {
        const std::uint32_t coverage = covered.rows[row];
        if (coverage == 0xffffu) continue;
        std::uint16_t* const first = texels + row * kTileSize * 4;
        if (coverage == 0) {
            std::memset(first, 0, kTileSize * 4 * sizeof *first);
            continue;
        }
        for (std::uint32_t column = 0; column < kTileSize; ++column) {
            if ((coverage >> column & 1u) == 0) std::memset(first + column * 4, 0, 8);
        }
    }
}

}  // namespace txc
