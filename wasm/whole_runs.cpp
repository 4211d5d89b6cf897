#include "whole_runs.h"

#include <algorithm>

#include "bilinear.h"
#include "layer_tiles.h"

namespace txc {
namespace {

/// X and y of a vector in the picture, in fixed point on a level.
Int4 to_fixed(const PyramidLevel& level, Float4 vector) {
    return round_to_int(vector *
                        (Float4{level.scale_x, level.scale_y, 0.0f, 0.0f} * splat(static_cast<float>(kWeightOne))));
}

/// The frame's part of it, at hand for all runs.
class WholeRuns {
public:
    WholeRuns(const DecalFrame& d, RoughTexel* rough)
        : rough_(rough),
          level_(d.level),
          footprint_(&d.footprint),
          pixels_(level_->first_pixel()),
          roughness_(footprint_->smooth_list),
          stride_(level_->stride()),
          limit_(footprint_->smooth_limit),
          pair_limit_(d.pair_limit),
          four_limit_(d.four_limit) {
        const Int4 across = to_fixed(*level_, d.seen.dx);
        across_x_ = splat(across[kX]);
        across_y_ = splat(across[kY]);
    }

    __attribute__((always_inline)) void paint(const TexelRun& run, const DecalFrame& d, std::int32_t tile_x,
                                              std::int32_t tile_y, std::uint16_t* tile_texels) {
        const Int4 start = to_fixed(*level_, d.at_texel(tile_x + run.x, tile_y + run.y)) - splat(kWeightOne / 2);
        Int4 x = splat(start[kX]);
        Int4 y = splat(start[kY]);
        std::uint16_t* texels = tile_texels + (run.y * kTileSize + run.x) * 4;
        SamplePlaces places = place_samples(x, y, stride_);
        Int4 color = sample<0>(places);
        std::int32_t steps = roughness_[places.offset[0]];
        std::int32_t left = run.length;
        for (; left > 4; left -= 4, texels += 16) {
            const Int4 lanes = {1, 2, 3, 4};
            const Int4 lanes_x = x + across_x_ * lanes;
            const Int4 lanes_y = y + across_y_ * lanes;
            places = place_samples(lanes_x, lanes_y, stride_);
            const std::int32_t next[4] = {roughness_[places.offset[0]], roughness_[places.offset[1]],
                                          roughness_[places.offset[2]], roughness_[places.offset[3]]};
            const std::int32_t most = std::max(std::max(std::max(next[0], next[1]), std::max(next[2], next[3])), steps);
            const Int4 fifth = sample<3>(places);
            if (most <= four_limit_) {
                const Int4 quarter = (fifth - color) >> 2;
                store(texels, color, color + quarter, color + ((fifth - color) >> 1), fifth - quarter);
            } else {
                const Int4 third = sample<1>(places);
                if (most <= pair_limit_) {
                    store(texels, color, (color + third) >> 1, third, (third + fifth) >> 1);
                } else {
                    store(texels, color, sample<0>(places), third, sample<2>(places));
                    if (most > limit_) {
                        leave(steps, x[0], y[0], texels);
                        leave(next[0], lanes_x[0], lanes_y[0], texels + 4);
                        leave(next[1], lanes_x[1], lanes_y[1], texels + 8);
                        leave(next[2], lanes_x[2], lanes_y[2], texels + 12);
                    }
                }
            }
            color = fifth;
            steps = next[3];
            x += across_x_ << 2;
            y += across_y_ << 2;
        }
        paint_last(x, y, color, steps, left, texels);
    }

    RoughTexel* rough() const { return rough_; }

private:
    /// One to four texels, of which the first is known.
    __attribute__((always_inline)) void paint_last(Int4 x, Int4 y, Int4 color, std::int32_t steps, std::int32_t left,
                                                   std::uint16_t* texels) {
        store_ushort4(texels, color + kBias);
        if (steps > limit_) leave(steps, x[0], y[0], texels);
        if (left == 1) return;
        // Places beyond the last texel are the last one's.
        const Int4 lanes = lesser(Int4{1, 2, 3, 3}, splat(left - 1));
        const Int4 lanes_x = x + across_x_ * lanes;
        const Int4 lanes_y = y + across_y_ * lanes;
        const SamplePlaces places = place_samples(lanes_x, lanes_y, stride_);
        const std::int32_t next[3] = {roughness_[places.offset[0]], roughness_[places.offset[1]],
                                      roughness_[places.offset[2]]};
        const Int4 last = sample<2>(places);
        const std::int32_t most = std::max(next[0], std::max(next[1], next[2]));
        if (left == 2) {
            store_ushort4(texels + 4, last + kBias);
        } else {
            const Int4 third = sample<1>(places);
            const Int4 second = std::max(most, steps) <= pair_limit_ ? (color + third) >> 1 : sample<0>(places);
            store_ushort8(texels + 4, second + kBias, third + kBias);
            if (left > 3) store_ushort4(texels + 12, last + kBias);
        }
        if (most <= limit_) return;
        leave(next[0], lanes_x[0], lanes_y[0], texels + 4);
        if (left > 2) leave(next[1], lanes_x[1], lanes_y[1], texels + 8);
        if (left > 3) leave(next[2], lanes_x[2], lanes_y[2], texels + 12);
    }

    template <int kLane>
    __attribute__((always_inline)) Int4 sample(const SamplePlaces& places) const {
        return sample_lane<kLane>(pixels_, stride_, places);
    }

    static void store(std::uint16_t* texels, Int4 first, Int4 second, Int4 third, Int4 fourth) {
        store_ushort8(texels, first + kBias, second + kBias);
        store_ushort8(texels + 8, third + kBias, fourth + kBias);
    }

    /// Leaves a texel to its footprint where it is rough. Writes in any case: no branch.
    void leave(std::int32_t steps, std::int32_t x, std::int32_t y, std::uint16_t* texel) {
        *rough_ = {level_, footprint_, x, y, texel};
        rough_ += steps > limit_ ? 1 : 0;
    }

    // All that the loops read is their own: what lies behind pointers would be read anew after every store.
    RoughTexel* rough_;  // the next one
    const PyramidLevel* level_;
    const Footprint* footprint_;
    const std::int16_t* pixels_;
    const std::uint8_t* roughness_;
    std::int32_t stride_;
    std::int32_t limit_;
    std::int32_t pair_limit_;
    std::int32_t four_limit_;
    Int4 across_x_{};  // from a texel to the next, in fixed point on the level
    Int4 across_y_{};
};

}  // namespace

RoughTexel* paint_whole_runs(const TexelRun* run, const TexelRun* end, const DecalFrame& d, std::int32_t tile_x,
                             std::int32_t tile_y, std::uint16_t* texels, RoughTexel* rough) {
    WholeRuns runs(d, rough);
    for (; run != end; ++run) runs.paint(*run, d, tile_x, tile_y, texels);
    return runs.rough();
}

}  // namespace txc
