#include "projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bilinear.h"
#include "footprint.h"

namespace txc {
namespace {

/// Lanes of a frame's affine map into the decal: where its texels meet the picture (pixels of the picture, 0 at its left
/// and top edge), how deep they lie (decal space), how they face (normal . ray, before the normal is normalised).
enum Lane { kX, kY, kDepth, kFacing };

constexpr float kAny = std::numeric_limits<float>::max();

/// What is known of the triangles that may hide a frame.
enum class Hiding { kUnasked, kNone, kBlockers, kUnknown };

/// A frame as this decal sees it.
struct DecalFrame {
    std::uint32_t frame = 0xffffffffu;
    std::int32_t x0 = 0;
    std::int32_t y0 = 0;
    ProjectedFrame seen{};         // x and y in pixels of the picture
    std::uint32_t tile = kNoTile;  // that looked at it last
    bool has_footprint = false;
    Footprint footprint{};
    const PyramidLevel* level = nullptr;  // the footprint's
    Hiding hiding = Hiding::kUnasked;
    std::vector<std::uint32_t> blockers;  // where hiding says that these are all

    Float4 at_texel(std::int32_t x, std::int32_t y) const {
        return seen.at + seen.dx * splat(static_cast<float>(x - x0)) + seen.dy * splat(static_cast<float>(y - y0));
    }
};

/// Bounds of what a frame's texels show to the tests, lane by lane.
struct LaneBounds {
    Float4 low;
    Float4 high;
};

/// A frame's covered texels in a tile.
struct TileFrame {
    const TexelRun* first;
    const TexelRun* end;
    ProjectedFrame seen;
    LaneBounds bounds;
};

/// X and y of a vector in the picture, in fixed point on a level.
Int4 to_fixed(const PyramidLevel& level, Float4 vector) {
    return round_to_int(vector *
                        (Float4{level.scale_x, level.scale_y, 0.0f, 0.0f} * splat(static_cast<float>(kWeightOne))));
}

/// Paints runs of one frame whose texels all lie well inside the padded picture and take its full weight. Texels for which one
/// sample does not stand are left to `rough`; returns what follows the last of them.
///
/// Four texels at a time are asked and taken together, whether one sample stands for all of them or not: asked texel by
/// texel, a branch that no processor foresees came with each. Where the picture is smooth enough they take not four
/// samples but two or one, and the colours between are interpolated.
class WholeRuns {
public:
    WholeRuns(const DecalFrame& d, RoughTexel* rough)
        : rough_(rough),
          level_(d.level),
          footprint_(&d.footprint),
          pixels_(level_->first_pixel()),
          roughness_(level_->first_roughness(footprint_->smooth_reach)),
          stride_(level_->stride()),
          limit_(footprint_->smooth_limit),
          pair_limit_(footprint_->pair_limit),
          four_limit_(footprint_->four_limit) {
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
    const std::uint16_t* pixels_;
    const std::uint8_t* roughness_;
    std::int32_t stride_;
    std::int32_t limit_;
    std::int32_t pair_limit_;
    std::int32_t four_limit_;
    Int4 across_x_{};  // from a texel to the next, in fixed point on the level
    Int4 across_y_{};
};

__attribute__((noinline)) RoughTexel* paint_whole_runs(const TexelRun* run, const TexelRun* end, const DecalFrame& d,
                                                       std::int32_t tile_x, std::int32_t tile_y, std::uint16_t* texels,
                                                       RoughTexel* rough) {
    WholeRuns runs(d, rough);
    for (; run != end; ++run) runs.paint(*run, d, tile_x, tile_y, texels);
    return runs.rough();
}

/// What becomes of texels that the decal's tests see together: some or all of them are painted at full weight.
enum class Fate { kSome, kAll };

class DecalPainter {
public:
    DecalPainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings, const ImagePyramid& image,
                 OccluderGrid* occluders)
        : map_(map),
          mesh_(mesh),
          settings_(settings),
          image_(image),
          occluders_(occluders),
          width_(static_cast<float>(image.levels[0].width)),
          height_(static_cast<float>(image.levels[0].height)),
          fade_(settings.repeat || settings.nearest ? 0.0f : 0.5f),
          projector_(settings.projector) {
        // Left to right is x from -1/2 to 1/2; bottom to top is y, and picture rows run down (spec section 1).
        const float scale_x = settings.flip_x ? -width_ : width_;
        const float scale_y = settings.flip_y ? height_ : -height_;
        for (int c = 0; c < 3; ++c) {
            projector_.rows[kX][c] *= splat(scale_x);
            projector_.rows[kY][c] *= splat(scale_y);
        }
        if (occluders != nullptr) known_clear_.assign(map.frames.size(), 0);
    }

    /// Paints one tile's texels into `texels` (zeroed before).
    void paint_tile(const MapTile& tile, std::uint16_t* texels) {
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        tile_ = tile.index;
        const std::uint32_t count = see_frames(tile, tile_x, tile_y);
        for (std::uint32_t i = 0; i < count; ++i) {
            const TileFrame& frame = tile_frames_[i];
            DecalFrame& d = decal_frame(frame.first->frame, &frame.seen);
            const Fate fate = fate_within(d, frame.bounds, 0);
            if (fate == Fate::kAll) {
                paint_whole(frame.first, frame.end, d, tile_x, tile_y, texels);
            } else {
                for (const TexelRun* run = frame.first; run != frame.end; ++run)
                    paint_run(*run, d, tile_x, tile_y, texels);
            }
        }
        for (std::uint32_t r = 0; r < tile.gutter_run_count; ++r) {
            const TexelRun& gutter = map_.gutter_runs[tile.first_gutter_run + r];
            paint_run(gutter, decal_frame(gutter.frame, nullptr), tile_x, tile_y, texels);
        }
        finish_rough();
    }

private:
    /// Projects the frames that own covered texels of a tile, and lists those that the decal may reach. All before the first
    /// is painted: so the reads from here and there in the map's frames go on side by side, and not one by one.
    std::uint32_t see_frames(const MapTile& tile, std::int32_t tile_x, std::int32_t tile_y) {
        constexpr float kHalf = 0.5f * static_cast<float>(kTileSize - 1);
        const TexelRun* run = map_.runs.data() + tile.first_run;
        const TexelRun* const end = run + tile.run_count;
        std::uint32_t count = 0;
        while (run != end) {
            TileFrame& listed = tile_frames_[count];
            listed.first = run;
            while (++run != end && run->frame == listed.first->frame) continue;
            listed.end = run;
            const TexelFrame& frame = map_.frames[listed.first->frame];
            listed.seen = see(frame);
            // All that the tests look at is affine over the tile, so it lies within its bounds there.
            const Float4 centre = listed.seen.at +
                                  listed.seen.dx * splat(static_cast<float>(tile_x - frame.x0) + kHalf) +
                                  listed.seen.dy * splat(static_cast<float>(tile_y - frame.y0) + kHalf);
            const Float4 reach = (absolute(listed.seen.dx) + absolute(listed.seen.dy)) * splat(kHalf);
            listed.bounds = {centre - reach, centre + reach};
            if (may_meet(listed.seen, listed.bounds, 0)) ++count;
        }
        return count;
    }

    ProjectedFrame see(const TexelFrame& frame) const {
        ProjectedFrame seen = project_frame(projector_, frame);
        seen.at += Float4{0.5f * width_, 0.5f * height_, 0.0f, 0.0f};
        return seen;
    }

    /// Frames recur from tile to tile; a direct-mapped cache spares most of their set-up. `seen`: may be null.
    DecalFrame& decal_frame(std::uint32_t index, const ProjectedFrame* seen) {
        DecalFrame& cached = cache_[index % cache_.size()];
        if (cached.frame != index) {
            if (cached.tile == tile_) finish_rough();  // texels of this tile may still look at the frame that goes
            const TexelFrame& frame = map_.frames[index];
            cached.frame = index;
            cached.x0 = frame.x0;
            cached.y0 = frame.y0;
            cached.seen = seen != nullptr ? *seen : see(frame);
            cached.has_footprint = false;
            cached.hiding = Hiding::kUnasked;
            cached.blockers.clear();
        }
        cached.tile = tile_;
        return cached;
    }

    void finish_rough() {
        paint_rough(rough_, rough_count_);
        rough_count_ = 0;
    }

    /// Only frames that paint need one.
    void ensure_footprint(DecalFrame& d) const {
        if (d.has_footprint) return;
        d.footprint =
            make_footprint(image_, d.seen.dx[kX], d.seen.dx[kY], d.seen.dy[kX], d.seen.dy[kY], settings_.repeat);
        d.level = &image_.levels[d.footprint.level];
        d.has_footprint = true;
    }

    Hiding hiding_of(DecalFrame& d) {
        if (d.hiding == Hiding::kUnasked && known_clear_[d.frame] != 0) d.hiding = Hiding::kNone;
        if (d.hiding == Hiding::kUnasked) {
            const bool is_known = occluders_->find_blockers(map_.frames[d.frame].triangle, d.blockers);
            d.hiding = !is_known ? Hiding::kUnknown : d.blockers.empty() ? Hiding::kNone : Hiding::kBlockers;
            known_clear_[d.frame] = d.hiding == Hiding::kNone ? 1 : 0;
        }
        return d.hiding;
    }

    /// Whether texels of runs with these flags may take colour, as far as their bounds tell.
    bool may_meet(const ProjectedFrame& seen, const LaneBounds& bounds, std::uint8_t flags) const {
        const bool any_side = settings_.backfaces || (flags & kRunHoldNormal) != 0;
        const Float4 margin = margins(seen);
        const Float4 least = Float4{0.0f, 0.0f, -0.5f, any_side ? -kAny : 0.0f} - margin;
        const Float4 most = Float4{width_, height_, 0.5f, kAny} + margin;
        return !any_lane((bounds.high < least) | (bounds.low > most));
    }

    /// All tests at once for texels that may meet the decal.
    Fate fate_within(DecalFrame& d, const LaneBounds& bounds, std::uint8_t flags) {
        ensure_footprint(d);
        // Covered texels' normals are means of unit ones, so no longer than 1: where n . ray is beyond the fade's start
        // the cosine is all the more. A continued normal may be longer, so of that only the sign is known.
        const bool fades_in_gutter = (flags & kRunGutter) != 0 && settings_.fade_start_cosine > 0.0f;
        if (settings_.nearest || (flags & kRunHoldNormal) != 0 || fades_in_gutter) return Fate::kSome;
        const Float4 least = {d.footprint.inset_x, d.footprint.inset_y, -0.5f,
                              std::max(settings_.fade_start_cosine, 1e-6f)};
        const Float4 most = {width_ - d.footprint.inset_x, height_ - d.footprint.inset_y, 0.5f, kAny};
        if (any_lane((bounds.low < least) | (bounds.high > most))) return Fate::kSome;
        return occluders_ != nullptr && hiding_of(d) != Hiding::kNone ? Fate::kSome : Fate::kAll;
    }

    /// How far beyond the picture a texel's centre may lie: by its footprint, and by the half pixel over which a linear
    /// picture fades out.
    Float4 margins(const ProjectedFrame& seen) const {
        if (settings_.nearest) return splat(0.0f);
        const Float4 reach = (absolute(seen.dx) + absolute(seen.dy)) * splat(0.5f) + splat(fade_);
        return Float4{reach[kX], reach[kY], 0.0f, 0.0f};
    }

    void paint_whole(const TexelRun* first, const TexelRun* end, const DecalFrame& d, std::int32_t tile_x,
                     std::int32_t tile_y, std::uint16_t* texels) {
        RoughTexel* const rough = paint_whole_runs(first, end, d, tile_x, tile_y, texels, rough_ + rough_count_);
        rough_count_ = static_cast<std::uint32_t>(rough - rough_);
    }

    /// Any run: by its bounds, which are its ends, or else texel by texel.
    void paint_run(const TexelRun& run, DecalFrame& d, std::int32_t tile_x, std::int32_t tile_y,
                   std::uint16_t* tile_texels) {
        const std::int32_t x0 = tile_x + run.x;
        const std::int32_t y0 = tile_y + run.y;
        const Float4 first = d.at_texel(x0, y0);
        const Float4 last = first + d.seen.dx * splat(static_cast<float>(run.length - 1));
        const LaneBounds bounds = {lesser(first, last), greater(first, last)};
        if (!may_meet(d.seen, bounds, run.flags)) return;
        if (fate_within(d, bounds, run.flags) == Fate::kAll) {
            paint_whole(&run, &run + 1, d, tile_x, tile_y, tile_texels);
            return;
        }
        std::uint16_t* texels = tile_texels + (run.y * kTileSize + run.x) * 4;
        const TexelFrame& frame = map_.frames[run.frame];
        const Float4 margin = margins(d.seen);
        const float margin_x = margin[kX];
        const float margin_y = margin[kY];
        const float inset_x = d.footprint.inset_x;
        const float inset_y = d.footprint.inset_y;
        for (std::int32_t i = 0; i < run.length; ++i) {
            const Float4 q = first + d.seen.dx * splat(static_cast<float>(i));
            // Test 1: depth on the centre, sides on the footprint.
            if (!(q[kDepth] >= -0.5f && q[kDepth] <= 0.5f)) continue;
            const float x = q[kX];
            const float y = q[kY];
            if (!(x >= -margin_x && x <= width_ + margin_x && y >= -margin_y && y <= height_ + margin_y)) continue;
            const float weight = facing_weight(run, d, frame, q[kFacing], x0 + i, y0);
            if (!(weight > 0.0f)) continue;
            // Where its blockers are at hand they cost less than a sample, and hide most of what is asked.
            const bool knows_blockers = d.hiding == Hiding::kBlockers;
            if (knows_blockers && is_hidden(run, d, frame, x0 + i, y0)) continue;
            Float4 color;
            if (settings_.nearest) {
                color = sample_nearest(image_.levels[0], x, y);
            } else if (x >= inset_x && x <= width_ - inset_x && y >= inset_y && y <= height_ - inset_y) {
                color = sample_inside(image_, d.footprint, x, y);
            } else {
                color = sample_edge(image_, d.footprint, x, y, settings_.repeat);
            }
            // Else last, as it costs most: where the picture is transparent it need not be asked.
            if (occluders_ != nullptr && !knows_blockers && color[3] > 0.0f && is_hidden(run, d, frame, x0 + i, y0))
                continue;
            store_rounded_ushort4(texels + i * 4, color * splat(weight));
        }
    }

    /// Tests 2 and 3: the weight by the angle between normal and ray, 0 where the texel is culled.
    float facing_weight(const TexelRun& run, const DecalFrame& d, const TexelFrame& frame, float facing, std::int32_t x,
                        std::int32_t y) const {
        const bool hold = (run.flags & kRunHoldNormal) != 0;
        if (hold) facing = d.seen.at[kFacing];
        if (settings_.backfaces) facing = std::fabs(facing);
        if (!(facing > 0.0f)) return 0.0f;
        if (settings_.fade_start_cosine <= 0.0f) return 1.0f;  // a hard angle of 90 degrees needs no cosine
        const glm::vec3 n = hold ? frame.normal_at(frame.x0, frame.y0) : frame.normal_at(x, y);
        return settings_.fade_weight(facing / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z));
    }

    /// Test 4. A gutter texel's own place lies off the surface, so it asks for the nearest point of its triangle: else
    /// the gutter at an inner edge would be hidden by the neighbour, and a seam would show.
    bool is_hidden(const TexelRun& run, DecalFrame& d, const TexelFrame& frame, std::int32_t x, std::int32_t y) {
        glm::dvec3 origin(frame.position_at(x, y));
        if ((run.flags & kRunGutter) != 0) origin = nearest_point_on_triangle(mesh_, frame.triangle, origin);
        if (hiding_of(d) == Hiding::kUnknown) return occluders_->is_blocked(origin, frame.triangle);
        return occluders_->is_blocked_by(d.blockers, origin, frame.triangle);
    }

    const LocalSpaceMap& map_;
    const Mesh& mesh_;
    const DecalSettings& settings_;
    const ImagePyramid& image_;
    OccluderGrid* occluders_;
    float width_;
    float height_;
    float fade_;                             // pixels on either side of the picture's edge
    PlanarProjector projector_;              // into pixels of the picture, from its middle
    TileFrame tile_frames_[kTileTexels];     // of the tile under way
    std::vector<std::uint8_t> known_clear_;  // per frame: 1 where nothing hides it (the cache below forgets)
    RoughTexel rough_[kTileTexels + 1];      // of the tile under way: they are painted in one go
    std::uint32_t rough_count_ = 0;
    std::uint32_t tile_ = kNoTile;
    std::vector<DecalFrame> cache_ = std::vector<DecalFrame>(256);
};

}  // namespace

TxcStatus project_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                        const ImagePyramid& image, OccluderGrid* occluders, LayerTiles& out,
                        std::uint32_t& out_texels) {
    std::vector<std::uint32_t> candidates;
    ModelToDecal to_decal = settings.projector.to_decal;
    if (!settings.nearest && !settings.repeat) {
        to_decal.reach.x += 0.5 / image.levels[0].width;
        to_decal.reach.y += 0.5 / image.levels[0].height;
    }
    map.tree.find(map, to_decal, candidates);
    return paint_tiles(map, candidates, DecalPainter(map, mesh, settings, image, occluders), out, out_texels);
}

}  // namespace txc
