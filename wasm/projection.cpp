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

/// What is known of the triangles that may hide a frame.
enum class Hiding { kUnasked, kNone, kBlockers, kUnknown };

/// A frame as this decal sees it.
struct DecalFrame {
    std::uint32_t frame = 0xffffffffu;
    std::int32_t x0 = 0;
    std::int32_t y0 = 0;
    Float4 at{};
    Float4 dx{};
    Float4 dy{};
    std::uint32_t tile = kNoTile;  // that looked at it last
    bool has_footprint = false;
    Footprint footprint{};
    const PyramidLevel* level = nullptr;  // the footprint's
    Hiding hiding = Hiding::kUnasked;
    std::vector<std::uint32_t> blockers;  // where hiding says that these are all

    Float4 at_texel(std::int32_t x, std::int32_t y) const {
        return at + dx * splat(static_cast<float>(x - x0)) + dy * splat(static_cast<float>(y - y0));
    }
};

const Int4 kBias = {kChannelBias, kChannelBias, kChannelBias, kChannelBias};

/// What becomes of texels that the decal's tests see together: none, some or all of them are painted at full weight.
enum class Fate { kNone, kSome, kAll };

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
          fade_(settings.repeat ? 0.0f : 0.5f) {
        if (occluders != nullptr) known_clear_.assign(map.frames.size(), 0);
    }

    /// Paints one tile's texels into `texels` (zeroed before). Returns how many took colour.
    std::uint32_t paint_tile(const MapTile& tile, std::uint16_t* texels) {
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        tile_ = tile.index;
        painted_ = 0;
        const TexelRun* run = map_.runs.data() + tile.first_run;
        const TexelRun* const end = run + tile.run_count;
        while (run != end) {
            const std::uint32_t frame = run->frame;
            DecalFrame& d = decal_frame(frame);
            const Fate fate = fate_in_tile(d, tile_x, tile_y);
            for (; run != end && run->frame == frame; ++run) {
                std::uint16_t* out = texels + (run->y * kTileSize + run->x) * 4;
                if (fate == Fate::kAll) {
                    paint_whole_run(*run, d, tile_x + run->x, tile_y + run->y, out);
                } else if (fate == Fate::kSome) {
                    paint_run(*run, d, tile_x + run->x, tile_y + run->y, out);
                }
            }
        }
        for (std::uint32_t r = 0; r < tile.gutter_run_count; ++r) {
            const TexelRun& gutter = map_.gutter_runs[tile.first_gutter_run + r];
            paint_run(gutter, decal_frame(gutter.frame), tile_x + gutter.x, tile_y + gutter.y,
                      texels + (gutter.y * kTileSize + gutter.x) * 4);
        }
        paint_rough();
        return painted_;
    }

private:
    /// Frames recur from tile to tile; a direct-mapped cache spares most of their set-up.
    DecalFrame& decal_frame(std::uint32_t frame) {
        DecalFrame& cached = cache_[frame % cache_.size()];
        if (cached.frame != frame) {
            if (cached.tile == tile_) paint_rough();  // texels of this tile may still look at the frame that goes
            make_decal_frame(frame, cached);
        }
        cached.tile = tile_;
        return cached;
    }

    void paint_rough() {
        painted_ += paint_lattices(rough_, rough_count_);
        rough_count_ = 0;
    }

    void make_decal_frame(std::uint32_t index, DecalFrame& d) const {
        const TexelFrame& frame = map_.frames[index];
        const ProjectedFrame seen = project_frame(settings_.projector, frame);
        // Left to right is x from -1/2 to 1/2; bottom to top is y, and picture rows run down (spec section 1).
        const float scale_x = settings_.flip_x ? -width_ : width_;
        const float scale_y = settings_.flip_y ? height_ : -height_;
        d.frame = index;
        d.x0 = frame.x0;
        d.y0 = frame.y0;
        const Float4 scale = {scale_x, scale_y, 1.0f, 1.0f};
        const Float4 corner = {0.5f * width_, 0.5f * height_, 0.0f, 0.0f};
        d.at = seen.at * scale + corner;
        d.dx = seen.dx * scale;
        d.dy = seen.dy * scale;
        d.has_footprint = false;
        d.hiding = Hiding::kUnasked;
        d.blockers.clear();
    }

    /// Only frames that paint need one.
    void ensure_footprint(DecalFrame& d) const {
        if (d.has_footprint) return;
        d.footprint = make_footprint(image_, d.dx[kX], d.dx[kY], d.dy[kX], d.dy[kY], settings_.repeat);
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

    /// What becomes of the covered texels that a frame may have in a tile: all that the tests look at is affine over the
    /// tile, so it lies within its bounds there.
    Fate fate_in_tile(DecalFrame& d, std::int32_t tile_x, std::int32_t tile_y) {
        constexpr float kHalf = 0.5f * static_cast<float>(kTileSize - 1);
        const Float4 centre = d.at + d.dx * splat(static_cast<float>(tile_x - d.x0) + kHalf) +
                              d.dy * splat(static_cast<float>(tile_y - d.y0) + kHalf);
        const Float4 reach = (absolute(d.dx) + absolute(d.dy)) * splat(kHalf);
        return fate_between(d, centre - reach, centre + reach, 0);
    }

    /// All tests at once for texels between these bounds, of runs with these flags.
    Fate fate_between(DecalFrame& d, Float4 low, Float4 high, std::uint8_t flags) {
        constexpr float kAny = std::numeric_limits<float>::max();
        const bool holds_normal = (flags & kRunHoldNormal) != 0;
        const Float4 margin = margins(d);
        const Float4 least = Float4{0.0f, 0.0f, -0.5f, settings_.backfaces || holds_normal ? -kAny : 0.0f} - margin;
        const Float4 most = Float4{width_, height_, 0.5f, kAny} + margin;
        if (any_lane((high < least) | (low > most))) return Fate::kNone;
        ensure_footprint(d);
        // Covered texels' normals are means of unit ones, so no longer than 1: where n . ray is beyond the fade's start
        // the cosine is all the more. A continued normal may be longer, so of that only the sign is known.
        const bool fades_in_gutter = (flags & kRunGutter) != 0 && settings_.fade_start_cosine > 0.0f;
        if (settings_.nearest || holds_normal || fades_in_gutter) return Fate::kSome;
        const Float4 inner_least = {d.footprint.inset_x, d.footprint.inset_y, -0.5f,
                                    std::max(settings_.fade_start_cosine, 1e-6f)};
        const Float4 inner_most = {width_ - d.footprint.inset_x, height_ - d.footprint.inset_y, 0.5f, kAny};
        if (any_lane((low < inner_least) | (high > inner_most))) return Fate::kSome;
        return occluders_ != nullptr && hiding_of(d) != Hiding::kNone ? Fate::kSome : Fate::kAll;
    }

    /// How far beyond the picture a texel's centre may lie: by its footprint, and by the half pixel over which a linear
    /// picture fades out.
    Float4 margins(const DecalFrame& d) const {
        if (settings_.nearest) return splat(0.0f);
        const Float4 reach = (absolute(d.dx) + absolute(d.dy)) * splat(0.5f) + splat(fade_);
        return Float4{reach[kX], reach[kY], 0.0f, 0.0f};
    }

    /// A run whose texels all lie well inside the picture and take its full weight.
    void paint_whole_run(const TexelRun& run, const DecalFrame& d, std::int32_t x0, std::int32_t y0,
                         std::uint16_t* texels) {
        const Float4 first = d.at_texel(x0, y0);
        const Float4 step_x = splat(d.dx[kX] * d.level->scale_x);
        const Float4 step_y = splat(d.dx[kY] * d.level->scale_y);
        const Float4 lanes = {0.0f, 1.0f, 2.0f, 3.0f};
        Float4 x = splat(first[kX] * d.level->scale_x - 0.5f) + step_x * lanes;
        Float4 y = splat(first[kY] * d.level->scale_y - 0.5f) + step_y * lanes;
        for (std::int32_t left = run.length;; left -= 4) {
            const SamplePlaces places = place_samples(x, y, static_cast<std::int32_t>(d.level->width));
            paint_lane<0>(d, places, x, y, texels);
            if (left > 1) paint_lane<1>(d, places, x, y, texels);
            if (left > 2) paint_lane<2>(d, places, x, y, texels);
            if (left > 3) paint_lane<3>(d, places, x, y, texels);
            if (left <= 4) return;
            x += step_x * splat(4.0f);
            y += step_y * splat(4.0f);
            texels += 16;
        }
    }

    template <int kLane>
    void paint_lane(const DecalFrame& d, const SamplePlaces& places, Float4 x, Float4 y, std::uint16_t* texels) {
        const Footprint& f = d.footprint;
        std::uint16_t* texel = texels + kLane * 4;
        if (d.level->roughness[f.smooth_reach - 1][static_cast<std::size_t>(places.offset[kLane])] <= f.smooth_limit) {
            store_ushort4(texel, sample_lane<kLane>(*d.level, places) + kBias);
            if (texel[3] != 0) ++painted_;
        } else {
            rough_[rough_count_++] = {d.level, &f, x[kLane], y[kLane], texel};
        }
    }

    /// Any run: by its bounds, which are its ends, or else texel by texel.
    void paint_run(const TexelRun& run, DecalFrame& d, std::int32_t x0, std::int32_t y0, std::uint16_t* texels) {
        const Float4 first = d.at_texel(x0, y0);
        const Float4 last = first + d.dx * splat(static_cast<float>(run.length - 1));
        const Fate fate = fate_between(d, lesser(first, last), greater(first, last), run.flags);
        if (fate == Fate::kNone) return;
        if (fate == Fate::kAll) {
            paint_whole_run(run, d, x0, y0, texels);
            return;
        }
        const TexelFrame& frame = map_.frames[run.frame];
        const Float4 margin = margins(d);
        const float margin_x = margin[kX];
        const float margin_y = margin[kY];
        const float inset_x = d.footprint.inset_x;
        const float inset_y = d.footprint.inset_y;
        for (std::int32_t i = 0; i < run.length; ++i) {
            const Float4 q = first + d.dx * splat(static_cast<float>(i));
            // Test 1: depth on the centre, sides on the footprint.
            if (!(q[kDepth] >= -0.5f && q[kDepth] <= 0.5f)) continue;
            const float x = q[kX];
            const float y = q[kY];
            if (!(x >= -margin_x && x <= width_ + margin_x && y >= -margin_y && y <= height_ + margin_y)) continue;
            const float weight = facing_weight(run, d, frame, q[kFacing], x0 + i, y0);
            if (!(weight > 0.0f)) continue;
            Float4 color;
            if (settings_.nearest) {
                color = sample_nearest(image_.levels[0], x, y);
            } else if (x >= inset_x && x <= width_ - inset_x && y >= inset_y && y <= height_ - inset_y) {
                color = sample_inside(image_, d.footprint, x, y);
            } else {
                color = sample_edge(image_, d.footprint, x, y, settings_.repeat);
            }
            // Last, as it costs most: where the picture is transparent it need not be asked.
            if (occluders_ != nullptr && color[3] > 0.0f && is_hidden(run, d, frame, x0 + i, y0)) continue;
            std::uint16_t* texel = texels + i * 4;
            store_rounded_ushort4(texel, color * splat(weight));
            if (texel[3] != 0) ++painted_;
        }
    }

    /// Tests 2 and 3: the weight by the angle between normal and ray, 0 where the texel is culled.
    float facing_weight(const TexelRun& run, const DecalFrame& d, const TexelFrame& frame, float facing, std::int32_t x,
                        std::int32_t y) const {
        const bool hold = (run.flags & kRunHoldNormal) != 0;
        if (hold) facing = d.at[kFacing];
        if (settings_.backfaces) facing = std::fabs(facing);
        if (!(facing > 0.0f)) return 0.0f;
        if (settings_.fade_start_cosine <= 0.0f) return 1.0f;  // a hard angle of 90 degrees needs no cosine
        const glm::vec3 n = hold ? frame.normal : frame.normal_at(x, y);
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
    std::vector<std::uint8_t> known_clear_;  // per frame: 1 where nothing hides it (the cache below forgets)
    LatticeTexel rough_[kTileTexels];        // of the tile under way: they take their lattices in one go
    std::uint32_t rough_count_ = 0;
    std::uint32_t tile_ = kNoTile;
    std::uint32_t painted_ = 0;  // of the tile under way
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
