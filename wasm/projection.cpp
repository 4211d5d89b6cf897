#include "projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bilinear.h"
#include "decal_frame.h"
#include "patch_painter.h"
#include "whole_runs.h"

namespace txc {
namespace {

constexpr float kAny = std::numeric_limits<float>::max();

// How much the sides of a tile's footprints may differ from the one that stands for all of them, on either side: pixels, and as
// much again for each pixel of the longest. (On a torus of 20,000 triangles, whose facets are as large as its tiles, 0.06 leaves
// 524 of the 1,450 tiles of a decal to the frames, and 0.1 fewer than 130. With 0.15 a drag takes 0.96 of the time, and the worst of
// those tiles comes to 35 dB against their own footprints where it has 37, on a checker of 3 pixels. A patch painted frame by frame
// there, each with its own footprint, took 1.02 to 1.06 of the time: loops that paint some of four texels are slower ones.)
constexpr float kFootprintSpread = 0.1f;
// The same where there are so few texels that each tile is large on the model: on a sphere at 256 x 128 stripes and
// checkers of a pixel keep 42 dB, and have 36 with 0.1; at 640 x 448 stripes of a pixel have 39.5 with 0.1, at 1024 x 512 41.4. A drag
// at 512 x 512 takes 0.99 to 1.01 of the time. (At 2048 x 2048 it would take 1.15 to 1.26.)
constexpr float kFineFootprintSpread = 0.04f;
// Half a tile may be this many pixels wide: slopes are 16 bits (kSlopeBits).
constexpr float kMostReach = 127.0f;

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
          footprint_spread_(has_large_tiles(map) ? kFineFootprintSpread : kFootprintSpread),
          fade_(settings.repeat ? 0.0f : 0.5f),
          projector_(settings.projector) {
        // Left to right is x from -1/2 to 1/2; bottom to top is y, and picture rows run down (spec section 1).
        const float scale_x = settings.flip_x ? -width_ : width_;
        const float scale_y = settings.flip_y ? height_ : -height_;
        for (int c = 0; c < 3; ++c) {
            projector_.rows[kX][c] *= splat(scale_x);
            projector_.rows[kY][c] *= splat(scale_y);
        }
        for (int c = 0; c < 3; ++c) {
            view_.centre[c] = projector_.centre[c][0];
            view_.columns[c] = Float4{projector_.rows[kX][c][0], projector_.rows[kY][c][0],
                                      projector_.rows[kDepth][c][0], projector_.rows[kFacing][c][0]};
        }
        view_.at = Float4{0.5f * width_, 0.5f * height_, 0.0f, 0.0f};
        if (occluders != nullptr) known_clear_.assign(map.frames.size(), 0);
    }

    /// Paints one tile's texels into `texels`. False where it has none to paint.
    bool paint_tile(const MapTile& tile, std::uint16_t* texels) {
        if (!settings_.nearest) {
            const TileFate fate = paint_as_one(tile, true, texels);
            if (fate != TileFate::kNot) return fate == TileFate::kPainted;
        }
        clear_tile(texels);
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
        return true;
    }

    TileFate paint_through(const TileView& view, const MapTile& tile, std::uint16_t* texels) {
        view_ = view;
        return paint_as_one(tile, false, texels);
    }

    /// Whether nothing hides any texel of a tile.
    bool is_clear(const MapTile& tile) {
        if (occluders_ == nullptr) return true;
        bool clear = true;
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            clear =
                clear && (known_clear_[run.frame] != 0 || hiding_of(decal_frame(run.frame, nullptr)) == Hiding::kNone);
        });
        return clear;
    }

    bool is_hidden(const TexelRun& run, std::int32_t x, std::int32_t y) {
        return known_clear_[run.frame] == 0 &&
               is_hidden(run, decal_frame(run.frame, nullptr), map_.frames[run.frame], x, y);
    }

private:
    /// Paints a tile whose texels are all alike to the decal. `may_weigh`: a planar decal's, where those that are too deep or turned too
    /// far are told from the others by their frames, and what hides any is asked first.
    TileFate paint_as_one(const MapTile& tile, bool may_weigh, std::uint16_t* texels) {
        const std::uint32_t place = map_.tile_of[tile.index];
        const TilePatch& patch = map_.patches->find(map_, place);
        // First, since it is all that most tiles on a model's far side are asked.
        const float facing = turn_normal(patch.normal);
        const float facing_spread = turn_normal_extent(patch.normal_spread) + view_.ray_spread * patch.longest_normal;
        if (!settings_.backfaces && facing + facing_spread <= 0.0f) return TileFate::kMissed;
        const Float4 middle = view_.turn(patch.middle - view_.centre) + view_.at;
        const Float4 reach = turn_extent(patch.step) * splat(32767.0f);
        const Float4 across = view_.turn(patch.across);
        const Float4 down = view_.turn(patch.down);
        const Float4 margin =
            (absolute(across) + absolute(down) + turn_extent(patch.across_spread) + turn_extent(patch.down_spread)) *
                splat(0.5f) +
            splat(fade_);
        const Float4 low = middle - reach;
        const Float4 high = middle + reach;
        if (high[kX] < -margin[kX] || low[kX] > width_ + margin[kX] || high[kY] < -margin[kY] ||
            low[kY] > height_ + margin[kY] || high[kDepth] < -0.5f || low[kDepth] > 0.5f)
            return TileFate::kMissed;
        if (patch.state != TilePatch::State::kUniform) return TileFate::kNot;
        // Written so that what is no number is not as one.
        const bool is_deep = low[kDepth] >= -0.5f && high[kDepth] <= 0.5f;
        const float least_facing = settings_.backfaces ? std::fabs(facing) - facing_spread : facing - facing_spread;
        const bool is_facing =
            least_facing > 1e-6f && least_facing >= settings_.fade_start_cosine * patch.longest_normal;
        const Float4 spread = greater(turn_extent(patch.across_spread), turn_extent(patch.down_spread));
        const Float4 sides = greater(absolute(across), absolute(down));
        const float most_spread = footprint_spread_ * (1.0f + std::max(sides[kX], sides[kY]));
        if (!(spread[kX] <= most_spread && spread[kY] <= most_spread)) return TileFate::kNot;
        if (!(reach[kX] <= kMostReach && reach[kY] <= kMostReach)) return TileFate::kNot;
        const Footprint footprint =
            make_footprint(image_, across[kX], across[kY], down[kX], down[kY], settings_.repeat);
        const float inset_x =
            view_.comes_round ? std::max(footprint.inset_x, footprint.reach_x + 0.51f) : footprint.inset_x;
        const bool is_inside = low[kX] >= inset_x && high[kX] <= width_ - inset_x && low[kY] >= footprint.inset_y &&
                               high[kY] <= height_ - footprint.inset_y;
        // Beyond the picture all is alike, if the padding holds a whole footprint and what the picture fades into.
        const bool is_padded = inset_x <= -footprint.reach_x - 1.0f && footprint.inset_y <= -footprint.reach_y - 1.0f;
        if (!is_inside && !is_padded) return TileFate::kNot;
        const PyramidLevel& level = image_.levels[footprint.level];
        // (Reading a number of each line of the next tile's patch here, ahead of its turn, made a drag 1.03 times as long.)
        const PatchView view = view_of(patch, level, footprint, middle, reach);
        if (is_clear_around(level, footprint, view)) return TileFate::kMissed;
        // Not before: where the picture is transparent, nothing need be asked. (Of 200,000 triangles a drag takes 0.95 of the time.)
        if (may_weigh && !is_clear(tile)) return TileFate::kNot;
        const TileCoverage painted = !may_weigh || (is_deep && is_facing) ? patch.there : weigh_texels(tile);
        if (painted.is_empty()) return TileFate::kMissed;
        const PatchTexels& places = map_.patches->texels(map_, place);
        const bool may_join = patch.continuity == TilePatch::Continuity::kWhole;
        RoughTexel* const rough = paint_patch(painted, may_join, places, view, level, footprint, texels, rough_);
        paint_rough(rough_, static_cast<std::uint32_t>(rough - rough_));
        if (may_weigh && !is_facing && settings_.fades()) fade_texels(weights_, texels);
        clear_uncovered(painted, texels);
        if (!may_weigh && !is_facing) return TileFate::kUnweighed;
        return TileFate::kPainted;
    }

    /// Whether the picture has nothing that footprints of these texels reach.
    static bool is_clear_around(const PyramidLevel& level, const Footprint& footprint, const PatchView& view) {
        // The pixels around a place are the one before it and the one after it.
        const std::int32_t x = static_cast<std::int32_t>(footprint.reach_x * level.scale_x) + 1;
        const std::int32_t y = static_cast<std::int32_t>(footprint.reach_y * level.scale_y) + 1;
        return level.is_clear(view.first_column - x, view.first_row - y, view.last_column + 1 + x,
                              view.last_row + 1 + y);
    }

    /// The texels of a tile that are deep enough in the box and face the right way, and where the decal fades by the angle their
    /// weights (of others, anything). Those beside the picture may be among them.
    TileCoverage weigh_texels(const MapTile& tile) {
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        std::fill_n(weights_, kTileTexels, kFullWeight);
        TileCoverage met;
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            met.add(run.x, run.y, weigh_run(run, decal_frame(run.frame, nullptr).seen, tile_x, tile_y));
        });
        return met;
    }

    /// Tests 2 and 3 on a run's texels, to the weights that facing_weight gives: a bit for each that passes them, the first in the
    /// lowest. (Inlined, it and decal_frame make the module larger, and nothing quicker.)
    __attribute__((noinline)) std::uint32_t weigh_run(const TexelRun& run, const ProjectedFrame& seen,
                                                      std::int32_t tile_x, std::int32_t tile_y) {
        const TexelFrame& frame = map_.frames[run.frame];
        const std::int32_t x = tile_x + run.x;
        const std::int32_t y = tile_y + run.y;
        const Float4 first = seen.at + seen.dx * splat(static_cast<float>(x - frame.x0)) +
                             seen.dy * splat(static_cast<float>(y - frame.y0));
        const bool hold = (run.flags & kRunHoldNormal) != 0;
        const float facing = hold ? seen.at[kFacing] : first[kFacing];
        const float facing_dx = hold ? 0.0f : seen.dx[kFacing];
        const glm::vec3 normal = hold ? frame.normal_at(frame.x0, frame.y0) : frame.normal_at(x, y);
        const glm::vec3 normal_dx =
            hold ? glm::vec3(0.0f) : TexelFrame::part(frame.normal, &TexelFrame::Coordinate::dx);
        std::int16_t* const weights = weights_ + run.y * kTileSize + run.x;
        const auto length = static_cast<float>(run.length);
        std::uint32_t met = 0;
        Float4 step = {0.0f, 1.0f, 2.0f, 3.0f};
        for (std::uint32_t i = 0; i < run.length; i += 4, step += splat(4.0f)) {
            const Float4 depths = splat(first[kDepth]) + splat(seen.dx[kDepth]) * step;
            const Float4 facings = splat(facing) + splat(facing_dx) * step;
            const Float4 towards = settings_.backfaces ? absolute(facings) : facings;
            Int4 pass = (depths >= splat(-0.5f)) & (depths <= splat(0.5f)) & (towards > splat(0.0f));
            if (settings_.fades()) {
                Float4 squares = splat(0.0f);
                for (int axis = 0; axis < 3; ++axis) {
                    const Float4 along = splat(normal[axis]) + splat(normal_dx[axis]) * step;
                    squares += along * along;
                }
                const Float4 weight = settings_.fade_weights(towards / square_root(squares));
                pass &= weight > splat(0.0f);
                const Float4 lost = (splat(1.0f) - weight) * splat(static_cast<float>(kFullWeight));
                subtract_short4(weights + i, round_to_int(select(step < splat(length), lost, splat(0.0f))));
            }
            met |= lane_bits(pass) << i;
        }
        return met & ((1u << run.length) - 1);
    }

    PatchView view_of(const TilePatch& patch, const PyramidLevel& level, const Footprint& footprint, Float4 middle,
                      Float4 reach) const {
        // Four numbers at a time: x and y, twice.
        const Float4 scale =
            Float4{level.scale_x, level.scale_y, level.scale_x, level.scale_y} * splat(static_cast<float>(kWeightOne));
        PatchView view;
        view.chords = tile_chord_limits(image_, footprint);
        // Sums of slopes times whole numbers stay within 2^30, up to kMostReach.
        const auto slopes = [&](int axis) {
            return round_to_int(view_.columns[axis] * splat(patch.step[axis]) * scale *
                                splat(static_cast<float>(1 << kSlopeBits)));
        };
        const Int4 by_z = slopes(2) & 0xffff;
        const Int4 by_xy = (slopes(0) & 0xffff) | slopes(1) << 16;
        view.xy_to_x = broadcast<kX>(by_xy);
        view.z_to_x = broadcast<kX>(by_z);
        view.xy_to_y = broadcast<kY>(by_xy);
        view.z_to_y = broadcast<kY>(by_z);
        const Int4 base = floor_to_int(middle * scale) - splat(kWeightOne / 2);
        view.base_x = base[kX];
        view.base_y = base[kY];
        const Float4 insets = {footprint.inset_x, footprint.inset_y, width_ - footprint.inset_x,
                               height_ - footprint.inset_y};
        const Int4 limits = floor_to_int(insets * scale) - splat(kWeightOne / 2);
        view.least_x = limits[0];
        view.least_y = limits[1];
        view.most_x = limits[2];
        view.most_y = limits[3];
        const Float4 low = middle - reach;
        const Float4 high = middle + reach;
        const Int4 least = {limits[0], limits[1], limits[0], limits[1]};
        const Int4 most = {limits[2], limits[3], limits[2], limits[3]};
        const Int4 places = floor_to_int(Float4{low[kX], low[kY], high[kX], high[kY]} * scale);
        const Int4 pixels = lesser(greater(places, least), most) >> kWeightBits;
        view.first_column = pixels[0];
        view.first_row = pixels[1];
        view.last_column = pixels[2];
        view.last_row = pixels[3];
        return view;
    }

    /// Half the extents of what a box with such half extents becomes.
    Float4 turn_extent(Float4 v) const {
        return absolute(view_.columns[0]) * splat(v[0]) + absolute(view_.columns[1]) * splat(v[1]) +
               absolute(view_.columns[2]) * splat(v[2]);
    }
    float turn_normal(Float4 v) const {
        return view_.columns[0][kFacing] * v[0] + view_.columns[1][kFacing] * v[1] + view_.columns[2][kFacing] * v[2];
    }
    float turn_normal_extent(Float4 v) const {
        return std::fabs(view_.columns[0][kFacing]) * v[0] + std::fabs(view_.columns[1][kFacing]) * v[1] +
               std::fabs(view_.columns[2][kFacing]) * v[2];
    }

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
    __attribute__((noinline)) DecalFrame& decal_frame(std::uint32_t index, const ProjectedFrame* seen) {
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

    /// Only frames that paint need one. (Of 200,000 triangles at 1024 x 1024 they are a quarter of a drag. But few are alike: shared
    /// between frames whose sides agree to a 32nd of the longest they made it 1.05 to 1.08 times as long, to an 8th 0.89 to 0.95.)
    void ensure_footprint(DecalFrame& d) const {
        if (d.has_footprint) return;
        make_footprint(image_, d.seen.dx[kX], d.seen.dx[kY], d.seen.dy[kX], d.seen.dy[kY], settings_.repeat,
                       d.footprint);
        d.level = &image_.levels[d.footprint.level];
        d.pair_limit = chord_limit(image_, d.footprint, 2.0f);
        d.four_limit = chord_limit(image_, d.footprint, 4.0f);
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
        const bool fades_in_gutter = (flags & kRunGutter) != 0 && settings_.fades();
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
        if (!settings_.fades()) return 1.0f;  // a hard angle of 90 degrees needs no cosine
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
    float footprint_spread_;
    float fade_;                             // pixels on either side of the picture's edge
    PlanarProjector projector_;              // into pixels of the picture, from its middle
    TileView view_;                          // the same map, and depth in place of nothing
    TileFrame tile_frames_[kTileTexels];     // of the tile under way
    std::vector<std::uint8_t> known_clear_;  // per frame: 1 where nothing hides it (the cache below forgets)
    RoughTexel rough_[kTileTexels + 1];      // of the tile under way: they are painted in one go
    std::uint32_t rough_count_ = 0;
    std::int16_t weights_[kTileTexels + 3];  // of the tile under way, where weigh_texels has met them
    std::uint32_t tile_ = kNoTile;
    std::vector<DecalFrame> cache_ = std::vector<DecalFrame>(256);
};

}  // namespace

struct TilePainter::Painter : DecalPainter {
    using DecalPainter::DecalPainter;
};

TilePainter::TilePainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                         const ImagePyramid& image, OccluderGrid* occluders)
    : painter_(std::make_unique<Painter>(map, mesh, settings, image, occluders)) {}
TilePainter::~TilePainter() = default;

TileFate TilePainter::paint(const MapTile& tile, const TileView& view, std::uint16_t* texels) {
    return painter_->paint_through(view, tile, texels);
}

bool TilePainter::is_clear(const MapTile& tile) { return painter_->is_clear(tile); }

bool TilePainter::is_hidden(const TexelRun& run, std::int32_t x, std::int32_t y) {
    return painter_->is_hidden(run, x, y);
}

bool TilePainter::paint_tile(const MapTile& tile, std::uint16_t* texels) { return painter_->paint_tile(tile, texels); }

std::vector<std::uint32_t> find_candidates(const LocalSpaceMap& map, const DecalSettings& settings,
                                           const ImagePyramid& image) {
    std::vector<std::uint32_t> candidates;
    ModelToDecal to_decal = settings.projector.to_decal;
    const PictureMargin margin = settings.margin(image);
    to_decal.reach += glm::dvec3(margin.x, margin.y, 0.0);
    map.tree.find(map, to_decal, candidates);
    return candidates;
}

TxcStatus project_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                        const ImagePyramid& image, const std::vector<std::uint32_t>& candidates,
                        OccluderGrid* occluders, LayerTiles& out, std::uint32_t& out_texels) {
    TilePainter painter(map, mesh, settings, image, occluders);
    return paint_tiles(map, candidates, painter, out, out_texels);
}

}  // namespace txc
