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

/// A frame as this decal sees it.
struct DecalFrame {
    std::uint32_t frame = 0xffffffffu;
    std::int32_t x0 = 0;
    std::int32_t y0 = 0;
    Float4 at{};
    Float4 dx{};
    Float4 dy{};
    Footprint footprint{};
    // The footprint's level: pixels of the level a pixel of the picture.
    float scale_x = 1.0f;
    float scale_y = 1.0f;

    Float4 at_texel(std::int32_t x, std::int32_t y) const {
        return at + dx * splat(static_cast<float>(x - x0)) + dy * splat(static_cast<float>(y - y0));
    }
};

const Int4 kBias = {kChannelBias, kChannelBias, kChannelBias, kChannelBias};

/// How the texels of a frame lie in one tile.
enum class Fate { kNone, kSome, kAll };

class DecalPainter {
public:
    DecalPainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings, const ImagePyramid& image,
                 const OccluderGrid* occluders)
        : map_(map),
          mesh_(mesh),
          settings_(settings),
          image_(image),
          occluders_(occluders),
          width_(static_cast<float>(image.levels[0].width)),
          height_(static_cast<float>(image.levels[0].height)),
          fade_(settings.repeat ? 0.0f : 0.5f) {}

    /// Paints one tile's texels into `texels` (zeroed before). Returns how many took colour.
    std::uint32_t paint_tile(const MapTile& tile, std::uint16_t* texels) {
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        std::uint32_t painted = 0;
        const TexelRun* run = map_.runs.data() + tile.first_run;
        const TexelRun* const end = run + tile.run_count;
        while (run != end) {
            const std::uint32_t frame = run->frame;
            const DecalFrame& d = decal_frame(frame);
            const Fate fate = fate_in_tile(d, tile_x, tile_y);
            for (; run != end && run->frame == frame; ++run) {
                std::uint16_t* out = texels + (run->y * kTileSize + run->x) * 4;
                if (fate == Fate::kAll) {
                    painted += paint_whole_run(*run, d, tile_x + run->x, tile_y + run->y, out);
                } else if (fate == Fate::kSome) {
                    painted += paint_run(*run, d, tile_x + run->x, tile_y + run->y, out);
                }
            }
        }
        for (std::uint32_t r = 0; r < tile.gutter_run_count; ++r) {
            const TexelRun& gutter = map_.gutter_runs[tile.first_gutter_run + r];
            painted += paint_run(gutter, decal_frame(gutter.frame), tile_x + gutter.x, tile_y + gutter.y,
                                 texels + (gutter.y * kTileSize + gutter.x) * 4);
        }
        return painted;
    }

private:
    /// Frames recur from tile to tile; a direct-mapped cache spares most of their set-up.
    const DecalFrame& decal_frame(std::uint32_t frame) {
        DecalFrame& cached = cache_[frame % cache_.size()];
        if (cached.frame != frame) make_decal_frame(frame, cached);
        return cached;
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
        d.at = Float4{seen.decal.x, seen.decal.y, seen.decal.z, seen.facing} * scale + corner;
        d.dx = Float4{seen.decal_dx.x, seen.decal_dx.y, seen.decal_dx.z, seen.facing_dx} * scale;
        d.dy = Float4{seen.decal_dy.x, seen.decal_dy.y, seen.decal_dy.z, seen.facing_dy} * scale;
        d.footprint = make_footprint(image_, d.dx[kX], d.dx[kY], d.dy[kX], d.dy[kY], settings_.repeat);
        d.scale_x = image_.levels[d.footprint.level].scale_x;
        d.scale_y = image_.levels[d.footprint.level].scale_y;
    }

    /// All tests at once for the covered texels that a frame may have in a tile: what they look at is affine over the
    /// tile, so it lies within its bounds there.
    Fate fate_in_tile(const DecalFrame& d, std::int32_t tile_x, std::int32_t tile_y) const {
        constexpr float kHalf = 0.5f * static_cast<float>(kTileSize - 1);
        const Float4 centre = d.at + d.dx * splat(static_cast<float>(tile_x - d.x0) + kHalf) +
                              d.dy * splat(static_cast<float>(tile_y - d.y0) + kHalf);
        const Float4 reach = (absolute(d.dx) + absolute(d.dy)) * splat(kHalf);
        const Float4 low = centre - reach;
        const Float4 high = centre + reach;
        constexpr float kAny = std::numeric_limits<float>::max();
        const float margin_x = settings_.nearest ? 0.0f : d.footprint.reach_x + fade_;
        const float margin_y = settings_.nearest ? 0.0f : d.footprint.reach_y + fade_;
        const Float4 least = {-margin_x, -margin_y, -0.5f, settings_.backfaces ? -kAny : 0.0f};
        const Float4 most = {width_ + margin_x, height_ + margin_y, 0.5f, kAny};
        if (any_lane((high < least) | (low > most))) return Fate::kNone;
        if (settings_.nearest || occluders_ != nullptr) return Fate::kSome;
        // Covered texels' normals are means of unit ones, so no longer than 1: where n . ray is beyond the fade's start
        // the cosine is all the more.
        const Float4 inner_least = {d.footprint.inset_x, d.footprint.inset_y, -0.5f,
                                    std::max(settings_.fade_start_cosine, 1e-6f)};
        const Float4 inner_most = {width_ - d.footprint.inset_x, height_ - d.footprint.inset_y, 0.5f, kAny};
        return any_lane((low < inner_least) | (high > inner_most)) ? Fate::kSome : Fate::kAll;
    }

    /// A run whose texels all lie well inside the picture and take its full weight.
    std::uint32_t paint_whole_run(const TexelRun& run, const DecalFrame& d, std::int32_t x0, std::int32_t y0,
                                  std::uint16_t* texels) const {
        const Footprint& f = d.footprint;
        const PyramidLevel& level = image_.levels[f.level];
        const auto width = static_cast<std::int32_t>(level.width);
        const std::size_t stride = static_cast<std::size_t>(level.width) * 4;
        const bool single = f.across_samples * f.down_samples == 1;
        const std::uint8_t* roughness = level.roughness[f.smooth_reach - 1].data();
        const Float4 first = d.at_texel(x0, y0);
        const Float4 lanes = {0.0f, 1.0f, 2.0f, 3.0f};
        const Float4 step_x = splat(d.dx[kX]);
        const Float4 step_y = splat(d.dx[kY]);
        std::uint32_t painted = 0;
        for (std::int32_t i = 0; i < run.length; i += 4) {
            const Float4 across = lanes + splat(static_cast<float>(i));
            const Float4 x = (splat(first[kX]) + step_x * across) * splat(d.scale_x) - splat(0.5f);
            const Float4 y = (splat(first[kY]) + step_y * across) * splat(d.scale_y) - splat(0.5f);
            const SamplePlaces places = place_samples(x, y, width);
            const Lanes offsets(places.offset);
            const Lanes weights_x(places.weights_x);
            const Lanes weights_y(places.weights_y);
            const std::int32_t count = std::min(run.length - i, 4);
            for (std::int32_t k = 0; k < count; ++k) {
                const auto offset = static_cast<std::size_t>(offsets.at[k]);
                std::uint16_t* texel = texels + (i + k) * 4;
                if (single || roughness[offset] <= f.smooth_limit) {
                    store_ushort4(
                        texel, sample_biased(level.rgba.data() + offset * 4, stride, weights_x.at[k], weights_y.at[k]) +
                                   kBias);
                } else {
                    store_rounded_ushort4(texel, sample_lattice(level, f, x[k], y[k]));
                }
                painted += texel[3] != 0 ? 1 : 0;
            }
        }
        return painted;
    }

    /// Any run, texel by texel.
    std::uint32_t paint_run(const TexelRun& run, const DecalFrame& d, std::int32_t x0, std::int32_t y0,
                            std::uint16_t* texels) const {
        const TexelFrame& frame = map_.frames[run.frame];
        // A linear picture reaches half a pixel beyond its rectangle, and its edge half a pixel into it.
        const float margin_x = settings_.nearest ? 0.0f : d.footprint.reach_x + fade_;
        const float margin_y = settings_.nearest ? 0.0f : d.footprint.reach_y + fade_;
        const float inset_x = d.footprint.inset_x;
        const float inset_y = d.footprint.inset_y;
        const Float4 first = d.at_texel(x0, y0);
        if (misses_run(run, d, first, margin_x, margin_y)) return 0;
        std::uint32_t painted = 0;
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
                color = sample_nearest(x, y);
            } else if (x >= inset_x && x <= width_ - inset_x && y >= inset_y && y <= height_ - inset_y) {
                color = sample_inside(image_, d.footprint, x, y);
            } else {
                color = sample_edge(image_, d.footprint, x, y, settings_.repeat);
            }
            // Last, as it costs most: where the picture is transparent it need not be asked.
            if (occluders_ != nullptr && color[3] > 0.0f && is_hidden(run, frame, x0 + i, y0)) continue;
            std::uint16_t* texel = texels + i * 4;
            store_rounded_ushort4(texel, color * splat(weight));
            if (texel[3] != 0) ++painted;
        }
        return painted;
    }

    /// True where no texel of the run can pass tests 1 and 2: what they look at is affine along the run, so it lies
    /// between its values at the two ends.
    bool misses_run(const TexelRun& run, const DecalFrame& d, Float4 first, float margin_x, float margin_y) const {
        constexpr float kAny = std::numeric_limits<float>::max();
        const bool culls = !settings_.backfaces && (run.flags & kRunHoldNormal) == 0;
        const Float4 last = first + d.dx * splat(static_cast<float>(run.length - 1));
        const Float4 least = {-margin_x, -margin_y, -0.5f, culls ? 0.0f : -kAny};
        const Float4 most = {width_ + margin_x, height_ + margin_y, 0.5f, kAny};
        return any_lane((greater(first, last) < least) | (lesser(first, last) > most));
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
        const float f = facing / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        if (f >= settings_.fade_start_cosine) return 1.0f;
        if (f <= settings_.fade_end_cosine) return 0.0f;
        return (f - settings_.fade_end_cosine) / (settings_.fade_start_cosine - settings_.fade_end_cosine);
    }

    /// Test 4. A gutter texel's own place lies off the surface, so it asks for the nearest point of its triangle: else
    /// the gutter at an inner edge would be hidden by the neighbour, and a seam would show.
    bool is_hidden(const TexelRun& run, const TexelFrame& frame, std::int32_t x, std::int32_t y) const {
        glm::dvec3 origin(frame.position_at(x, y));
        if ((run.flags & kRunGutter) != 0) origin = nearest_point_on_triangle(mesh_, frame.triangle, origin);
        return occluders_->is_blocked(origin, frame.triangle);
    }

    Float4 sample_nearest(float x, float y) const {
        const PyramidLevel& level = image_.levels[0];
        const std::uint32_t column = std::min(static_cast<std::uint32_t>(x), level.width - 1);
        const std::uint32_t row = std::min(static_cast<std::uint32_t>(y), level.height - 1);
        return load_ushort4(level.pixel(column, row));
    }

    const LocalSpaceMap& map_;
    const Mesh& mesh_;
    const DecalSettings& settings_;
    const ImagePyramid& image_;
    const OccluderGrid* occluders_;
    float width_;
    float height_;
    float fade_;  // pixels on either side of the picture's edge
    std::vector<DecalFrame> cache_ = std::vector<DecalFrame>(1024);
};

}  // namespace

TxcStatus project_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                        const ImagePyramid& image, const OccluderGrid* occluders, LayerTiles& out,
                        std::uint32_t& out_texels) {
    out.indices.clear();
    out.texels.clear();
    out_texels = 0;
    std::vector<std::uint32_t> candidates;
    ModelToDecal to_decal = settings.projector.to_decal;
    if (!settings.nearest && !settings.repeat) {
        to_decal.reach.x += 0.5 / image.levels[0].width;
        to_decal.reach.y += 0.5 / image.levels[0].height;
    }
    map.tree.find(map, to_decal, candidates);
    constexpr std::size_t kTileBytes = kTileTexels * 4 * sizeof(std::uint16_t) + sizeof(std::uint32_t);
    // Dragged layers keep their arrays from step to step; one that shrank a lot gives them back.
    if (out.texels.capacity() > candidates.size() * kTileTexels * 4 * 4) out.texels.shrink_to_fit();
    const std::size_t tiles = std::max(candidates.size(), out.texels.capacity() / (kTileTexels * 4));
    if (const TxcStatus status = out.share.resize(tiles * kTileBytes, "projecting a layer"); status != TXC_STATUS_OK)
        return status;
    out.texels.reserve(candidates.size() * kTileTexels * 4);
    DecalPainter painter(map, mesh, settings, image, occluders);
    for (const std::uint32_t place : candidates) {
        const std::size_t start = out.texels.size();
        out.texels.resize(start + kTileTexels * 4);
        const std::uint32_t painted = painter.paint_tile(map.tiles[place], out.texels.data() + start);
        if (painted == 0) {
            out.texels.resize(start);
            continue;
        }
        out.indices.push_back(map.tiles[place].index);
        out_texels += painted;
    }
    return TXC_STATUS_OK;
}

}  // namespace txc
