#include "patch_painter.h"

#include <algorithm>
#include <cstring>

#include "bilinear.h"
#include "layer_tiles.h"

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

/// What the loop over a tile's rows has at hand: in registers, since what lies behind a reference would be read anew after
/// every store.
struct Ground {
    const std::uint16_t* pixels;
    std::int32_t stride;
    PatchView view;

    __attribute__((always_inline)) void find(Int4 xy, Int4 z, Int4& x, Int4& y) const {
        x = turn(xy, z, view.xy_to_x, view.z_to_x, view.base_x, view.least_x, view.most_x);
        y = turn(xy, z, view.xy_to_y, view.z_to_y, view.base_y, view.least_y, view.most_y);
    }

private:
    __attribute__((always_inline)) Int4 turn(Int4 xy, Int4 z, Int4 by_xy, Int4 by_z, std::int32_t base,
                                             std::int32_t least, std::int32_t most) const {
        const Int4 place = shift_right(dot_halves(xy, by_xy) + dot_halves(z, by_z), view.shift) + splat(base);
        return lesser(greater(place, splat(least)), splat(most));
    }
};

void store_two(std::uint16_t* to, Int4 low, Int4 high) { store_ushort8(to, low + kBias, high + kBias); }

/// Three chords of five texels, where the picture is smooth all along the row. False where it is not.
__attribute__((always_inline)) inline bool paint_row(const Ground& ground, const std::uint8_t* roughness,
                                                     const PatchTexels& places, std::uint32_t at, std::uint16_t* out) {
    const std::int32_t* xy = places.xy + at;
    const std::int32_t* z = places.z + at;
    Int4 x;
    Int4 y;
    ground.find(Int4{xy[0], xy[5], xy[10], xy[15]}, Int4{z[0], z[5], z[10], z[15]}, x, y);
    const SamplePlaces place = place_samples(x, y, ground.stride);
    const std::int32_t most = std::max(std::max<std::int32_t>(roughness[place.offset[0]], roughness[place.offset[1]]),
                                       std::max<std::int32_t>(roughness[place.offset[2]], roughness[place.offset[3]]));
    if (most > ground.view.chords.five) return false;
    const Int4 a = sample_lane<0>(ground.pixels, ground.stride, place);
    const Int4 b = sample_lane<1>(ground.pixels, ground.stride, place);
    const Int4 c = sample_lane<2>(ground.pixels, ground.stride, place);
    const Int4 d = sample_lane<3>(ground.pixels, ground.stride, place);
    const Int4 ab = pair_up(a, b);
    const Int4 bc = pair_up(b, c);
    const Int4 cd = pair_up(c, d);
    store_two(out, a, between<1, 5>(ab));
    store_two(out + 8, between<2, 5>(ab), between<3, 5>(ab));
    store_two(out + 16, between<4, 5>(ab), b);
    store_two(out + 24, between<1, 5>(bc), between<2, 5>(bc));
    store_two(out + 32, between<3, 5>(bc), between<4, 5>(bc));
    store_two(out + 40, c, between<1, 5>(cd));
    store_two(out + 48, between<2, 5>(cd), between<3, 5>(cd));
    store_two(out + 56, between<4, 5>(cd), d);
    return true;
}

}  // namespace

RoughTexel* paint_patch(const TilePatch& patch, const PatchTexels& places, const PatchView& view,
                        const PyramidLevel& level, const Footprint& footprint, std::uint16_t* texels,
                        RoughTexel* rough) {
    const Ground ground{level.first_pixel(), level.stride(), view};
    const std::uint8_t* const roughness = level.first_roughness(footprint.smooth_reach);
    const std::uint8_t* const wide_roughness = level.first_roughness(kRoughnessReaches);
    const std::int32_t limit = footprint.smooth_limit;
    const auto leave = [&](std::int32_t steps, std::int32_t x, std::int32_t y, std::uint16_t* texel) {
        *rough = {&level, &footprint, x, y, texel};
        rough += steps > limit ? 1 : 0;
    };
    for (std::uint32_t row = 0; row < kTileSize; ++row) {
        const std::uint32_t coverage = patch.coverage[row];
        if (view.chords.five >= 0 && coverage == 0xffffu &&
            paint_row(ground, wide_roughness, places, row * kTileSize, texels + row * kTileSize * 4))
            continue;
        for (std::uint32_t column = 0; column < kTileSize; column += 4) {
            if ((coverage >> column & 15u) == 0) continue;
            const std::uint32_t at = row * kTileSize + column;
            Int4 x;
            Int4 y;
            ground.find(load_int4(places.xy + at), load_int4(places.z + at), x, y);
            const SamplePlaces place = place_samples(x, y, ground.stride);
            const std::int32_t steps[4] = {roughness[place.offset[0]], roughness[place.offset[1]],
                                           roughness[place.offset[2]], roughness[place.offset[3]]};
            const std::int32_t most = std::max(std::max(steps[0], steps[1]), std::max(steps[2], steps[3]));
            std::uint16_t* const out = texels + at * 4;
            const Int4 first = sample_lane<0>(ground.pixels, ground.stride, place);
            const Int4 fourth = sample_lane<3>(ground.pixels, ground.stride, place);
            if (most <= ground.view.chords.three) {
                const Int4 pairs = pair_up(first, fourth);
                store_two(out, first, between<1, 3>(pairs));
                store_two(out + 8, between<2, 3>(pairs), fourth);
                continue;
            }
            store_two(out, first, sample_lane<1>(ground.pixels, ground.stride, place));
            store_two(out + 8, sample_lane<2>(ground.pixels, ground.stride, place), fourth);
            if (most > limit) {
                leave(steps[0], x[0], y[0], out);
                leave(steps[1], x[1], y[1], out + 4);
                leave(steps[2], x[2], y[2], out + 8);
                leave(steps[3], x[3], y[3], out + 12);
            }
        }
    }
    return rough;
}

void clear_uncovered(const TilePatch& patch, std::uint16_t* texels) {
    if (patch.is_full) return;
    for (std::uint32_t row = 0; row < kTileSize; ++row) {
        const std::uint32_t coverage = patch.coverage[row];
        if (coverage == 0xffffu) continue;
        for (std::uint32_t column = 0; column < kTileSize; ++column) {
            if ((coverage >> column & 1u) == 0) std::memset(texels + (row * kTileSize + column) * 4, 0, 8);
        }
    }
}

}  // namespace txc
