#include "projection.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "footprint.h"

namespace txc {
namespace {

/// A frame as this decal sees it: where its texels meet the picture (pixels), how deep they lie, how they face.
struct DecalFrame {
    std::uint32_t frame = 0xffffffffu;
    float x = 0, x_dx = 0, x_dy = 0;  // pixels of the picture, 0 at its left edge
    float y = 0, y_dx = 0, y_dy = 0;  // pixels, 0 at its top edge
    float z = 0, z_dx = 0, z_dy = 0;  // decal space
    float facing = 0, facing_dx = 0, facing_dy = 0;
    Footprint footprint{};
};

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
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            painted += paint_run(run, decal_frame(run.frame), tile_x + run.x, tile_y + run.y,
                                 texels + (run.y * kTileSize + run.x) * 4);
        });
        return painted;
    }

private:
    /// Frames recur from row to row and from tile to tile; a direct-mapped cache spares most of their set-up.
    const DecalFrame& decal_frame(std::uint32_t frame) {
        DecalFrame& cached = cache_[frame % cache_.size()];
        if (cached.frame != frame) cached = make_decal_frame(frame);
        return cached;
    }

    DecalFrame make_decal_frame(std::uint32_t frame) const {
        const ProjectedFrame seen = project_frame(settings_.projector, map_.frames[frame]);
        // Left to right is x from -1/2 to 1/2; bottom to top is y, and picture rows run down (spec section 1).
        const float scale_x = settings_.flip_x ? -width_ : width_;
        const float scale_y = settings_.flip_y ? height_ : -height_;
        DecalFrame d;
        d.frame = frame;
        d.x = seen.decal.x * scale_x + 0.5f * width_;
        d.x_dx = seen.decal_dx.x * scale_x;
        d.x_dy = seen.decal_dy.x * scale_x;
        d.y = seen.decal.y * scale_y + 0.5f * height_;
        d.y_dx = seen.decal_dx.y * scale_y;
        d.y_dy = seen.decal_dy.y * scale_y;
        d.z = seen.decal.z;
        d.z_dx = seen.decal_dx.z;
        d.z_dy = seen.decal_dy.z;
        d.facing = seen.facing;
        d.facing_dx = seen.facing_dx;
        d.facing_dy = seen.facing_dy;
        d.footprint = make_footprint(image_, d.x_dx, d.y_dx, d.x_dy, d.y_dy, settings_.repeat);
        return d;
    }

    std::uint32_t paint_run(const TexelRun& run, const DecalFrame& d, std::int32_t x0, std::int32_t y0,
                            std::uint16_t* texels) const {
        const TexelFrame& frame = map_.frames[run.frame];
        const auto down = static_cast<float>(y0 - frame.y0);
        // A linear picture reaches half a pixel beyond its rectangle, and its edge half a pixel into it.
        const float margin_x = settings_.nearest ? 0.0f : d.footprint.reach_x + fade_;
        const float margin_y = settings_.nearest ? 0.0f : d.footprint.reach_y + fade_;
        const float inset_x = d.footprint.inset_x;
        const float inset_y = d.footprint.inset_y;
        if (misses_run(run, d, static_cast<float>(x0 - frame.x0), down, margin_x, margin_y)) return 0;
        std::uint32_t painted = 0;
        for (std::int32_t i = 0; i < run.length; ++i) {
            const auto across = static_cast<float>(x0 + i - frame.x0);
            // Test 1: depth on the centre, sides on the footprint.
            const float z = d.z + d.z_dx * across + d.z_dy * down;
            if (!(z >= -0.5f && z <= 0.5f)) continue;
            const float x = d.x + d.x_dx * across + d.x_dy * down;
            const float y = d.y + d.y_dx * across + d.y_dy * down;
            if (!(x >= -margin_x && x <= width_ + margin_x && y >= -margin_y && y <= height_ + margin_y)) continue;
            const float weight = facing_weight(run, d, frame, across, down);
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
    bool misses_run(const TexelRun& run, const DecalFrame& d, float first, float down, float margin_x,
                    float margin_y) const {
        const float last = first + static_cast<float>(run.length - 1);
        const auto below = [&](float at, float dx, float dy, float limit) {
            return at + dx * first + dy * down < limit && at + dx * last + dy * down < limit;
        };
        const auto above = [&](float at, float dx, float dy, float limit) {
            return at + dx * first + dy * down > limit && at + dx * last + dy * down > limit;
        };
        if (!settings_.backfaces && (run.flags & kRunHoldNormal) == 0 &&
            below(d.facing, d.facing_dx, d.facing_dy, 0.0f))
            return true;
        return below(d.z, d.z_dx, d.z_dy, -0.5f) || above(d.z, d.z_dx, d.z_dy, 0.5f) ||
               below(d.x, d.x_dx, d.x_dy, -margin_x) || above(d.x, d.x_dx, d.x_dy, width_ + margin_x) ||
               below(d.y, d.y_dx, d.y_dy, -margin_y) || above(d.y, d.y_dx, d.y_dy, height_ + margin_y);
    }

    /// Tests 2 and 3: the weight by the angle between normal and ray, 0 where the texel is culled.
    float facing_weight(const TexelRun& run, const DecalFrame& d, const TexelFrame& frame, float across,
                        float down) const {
        const bool hold = (run.flags & kRunHoldNormal) != 0;
        float facing = hold ? d.facing : d.facing + d.facing_dx * across + d.facing_dy * down;
        if (settings_.backfaces) facing = std::fabs(facing);
        if (!(facing > 0.0f)) return 0.0f;
        if (settings_.fade_start_cosine <= 0.0f) return 1.0f;  // a hard angle of 90 degrees needs no cosine
        const glm::vec3 n = hold ? frame.normal : frame.normal + frame.normal_dx * across + frame.normal_dy * down;
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
