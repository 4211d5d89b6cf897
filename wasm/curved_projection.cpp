#include "curved_projection.h"

#include <algorithm>
#include <cmath>

#include "picture_sampler.h"

namespace txc {
namespace {

/// A frame in the projector's view space: what is affine over a triangle.
struct SeenFrame {
    std::uint32_t frame = 0xffffffffu;
    TexelPlace place{};      // at the frame's own texel (x0, y0)
    glm::dvec3 normal{0.0};  // not normalised
    glm::dvec3 normal_dx{0.0};
    glm::dvec3 normal_dy{0.0};
};

template <typename Projector>
class CurvedPainter {
public:
    CurvedPainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings, const Projector& projector,
                  PictureSampler& sampler, const OcclusionTree* tree)
        : map_(map), mesh_(mesh), settings_(settings), projector_(projector), sampler_(sampler), tree_(tree) {}

    /// Paints one tile's texels into `texels`.
    bool paint_tile(const MapTile& tile, std::uint16_t* texels) {
        clear_tile(texels);
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        ray_count_ = 0;
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            paint_run(run, seen_frame(run.frame), tile_x + run.x, tile_y + run.y,
                      texels + (run.y * kTileSize + run.x) * 4);
        });
        // Last, as it costs most: where the picture is transparent it need not be asked.
        if (ray_count_ > 0) tree_->clear_blocked(rays_, rays_ + ray_count_);
        return true;
    }

private:
    /// Frames recur from row to row and from tile to tile; a direct-mapped cache spares most of their set-up.
    const SeenFrame& seen_frame(std::uint32_t frame) {
        SeenFrame& cached = cache_[frame % cache_.size()];
        if (cached.frame != frame) cached = look_at_frame(frame);
        return cached;
    }

    SeenFrame look_at_frame(std::uint32_t index) const {
        const TexelFrame& frame = map_.frames[index];
        const ProjectorPose& pose = projector_.pose;
        SeenFrame seen;
        seen.frame = index;
        using Coordinate = TexelFrame::Coordinate;
        const auto part = [](const Coordinate(&of)[3], float Coordinate::*member) {
            return glm::dvec3(TexelFrame::part(of, member));
        };
        seen.place.position = pose.to_view(part(frame.position, &Coordinate::at));
        seen.place.across = pose.turn_to_view(part(frame.position, &Coordinate::dx));
        seen.place.down = pose.turn_to_view(part(frame.position, &Coordinate::dy));
        seen.normal = pose.turn_to_view(part(frame.normal, &Coordinate::at));
        seen.normal_dx = pose.turn_to_view(part(frame.normal, &Coordinate::dx));
        seen.normal_dy = pose.turn_to_view(part(frame.normal, &Coordinate::dy));
        return seen;
    }

    void paint_run(const TexelRun& run, const SeenFrame& seen, std::int32_t x0, std::int32_t y0,
                   std::uint16_t* texels) {
        const TexelFrame& frame = map_.frames[run.frame];
        const double down = y0 - frame.y0;
        const bool holds_normal = (run.flags & kRunHoldNormal) != 0;
        for (std::int32_t i = 0; i < run.length; ++i) {
            const double across = x0 + i - frame.x0;
            TexelPlace at = seen.place;
            at.position += seen.place.across * across + seen.place.down * down;
            TexelSight sight;
            if (!projector_.look(at, sight) || !sampler_.aim(sight.picture)) continue;
            const glm::dvec3 normal =
                holds_normal ? seen.normal : seen.normal + seen.normal_dx * across + seen.normal_dy * down;
            const float weight = facing_weight(normal, sight.ray);
            if (!(weight > 0.0f)) continue;
            const Float4 color = sampler_.sample();
            if (tree_ != nullptr && color[3] > 0.0f) ask_for_blockers(run, frame, at.position, texels + i * 4);
            store_rounded_ushort4(texels + i * 4, color * splat(weight));
        }
    }

    /// Tests 2 and 3: the weight by the angle between normal and ray, 0 where the texel is culled.
    float facing_weight(const glm::dvec3& normal, const glm::dvec3& ray) const {
        double facing = glm::dot(normal, ray);
        if (settings_.backfaces) facing = std::fabs(facing);
        if (!(facing > 0.0)) return 0.0f;
        if (settings_.fade_start_cosine <= 0.0f) return 1.0f;  // a hard angle of 90 degrees needs no cosine
        return settings_.fade_weight(static_cast<float>(facing / std::sqrt(glm::dot(normal, normal))));
    }

    /// Test 4. A gutter texel's own place lies off the surface, so it asks for the nearest point of its triangle, as
    /// with the planar projector.
    void ask_for_blockers(const TexelRun& run, const TexelFrame& frame, const glm::dvec3& position_view,
                          std::uint16_t* texel) {
        const ProjectorPose& pose = projector_.pose;
        glm::dvec3 origin = pose.position + pose.turn_to_model(position_view);
        if ((run.flags & kRunGutter) != 0) origin = nearest_point_on_triangle(mesh_, frame.triangle, origin);
        glm::dvec3 direction;
        double length = 0.0;
        if (!projector_.ray_from(pose.to_view(origin), direction, length)) return;
        rays_[ray_count_++] = {origin, pose.turn_to_model(direction), length, frame.triangle, texel};
    }

    const LocalSpaceMap& map_;
    const Mesh& mesh_;
    const DecalSettings& settings_;
    const Projector& projector_;
    PictureSampler& sampler_;
    const OcclusionTree* tree_;
    std::vector<SeenFrame> cache_ = std::vector<SeenFrame>(256);
    // Of the tile's texels that may be hidden.
    TexelRay rays_[kTileTexels];
    std::uint32_t ray_count_ = 0;
};

/// Paints the flat stamp: every texel that there is, whatever lies under it.
class StampPainter {
public:
    StampPainter(const LocalSpaceMap& map, const UvProjector& projector, PictureSampler& sampler)
        : map_(map), projector_(projector), sampler_(sampler) {}

    bool paint_tile(const MapTile& tile, std::uint16_t* texels) {
        clear_tile(texels);
        const std::uint32_t tile_x = tile.index % map_.tile_columns() * kTileSize;
        const std::uint32_t tile_y = tile.index / map_.tile_columns() * kTileSize;
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            for (std::uint32_t x = run.x; x < std::uint32_t{run.x} + run.length; ++x) {
                const MapKey& key = map_.key;
                if (!sampler_.aim(projector_.look(key.origin_x + tile_x + x, key.origin_y + tile_y + run.y,
                                                  key.texture_width(), key.texture_height())))
                    continue;
                store_rounded_ushort4(texels + (run.y * kTileSize + x) * 4, sampler_.sample());
            }
        });
        return true;
    }

private:
    const LocalSpaceMap& map_;
    const UvProjector& projector_;
    PictureSampler& sampler_;
};

double period_of(const PerspectiveProjector&) { return 0.0; }
double period_of(const CylindricalProjector& projector) { return projector.period; }
double period_of(const UvProjector&) { return 0.0; }

PictureSettings picture_settings(const DecalSettings& settings, const CurvedProjector& projector) {
    const double period = std::visit([](const auto& p) { return period_of(p); }, projector);
    return {settings.nearest, settings.repeat, settings.flip_x, settings.flip_y, period};
}

void find_stamp_candidates(const LocalSpaceMap& map, const UvProjector& projector, const PictureMargin& margin,
                           std::vector<std::uint32_t>& out) {
    out.clear();
    const MapKey& key = map.key;
    for (std::uint32_t place = 0; place < map.tiles.size(); ++place) {
        const std::uint32_t x = map.tiles[place].index % map.tile_columns() * kTileSize + key.origin_x;
        const std::uint32_t y = map.tiles[place].index / map.tile_columns() * kTileSize + key.origin_y;
        if (projector.may_touch(x, y, x + kTileSize, y + kTileSize, key.texture_width(), key.texture_height(), margin))
            out.push_back(place);
    }
}

}  // namespace

TxcStatus read_curved_projector(const TxcLayerDef& def, CurvedProjector& out) {
    if (def.projector == TXC_PROJECTOR_PERSPECTIVE)
        return PerspectiveProjector::from_def(def, out.emplace<PerspectiveProjector>());
    if (def.projector == TXC_PROJECTOR_CYLINDRICAL)
        return CylindricalProjector::from_def(def, out.emplace<CylindricalProjector>());
    return UvProjector::from_def(def, out.emplace<UvProjector>());
}

void find_curved_candidates(const LocalSpaceMap& map, const CurvedProjector& projector, const PictureMargin& margin,
                            std::vector<std::uint32_t>& out) {
    if (const auto* stamp = std::get_if<UvProjector>(&projector)) {
        find_stamp_candidates(map, *stamp, margin, out);
    } else if (const auto* perspective = std::get_if<PerspectiveProjector>(&projector)) {
        map.tree.find(
            map, [&](const ModelBox& box) { return perspective->may_touch(box, margin); }, out);
    } else if (const auto* cylindrical = std::get_if<CylindricalProjector>(&projector)) {
        map.tree.find(
            map, [&](const ModelBox& box) { return cylindrical->may_touch(box, margin); }, out);
    }
}

TxcStatus project_curved_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image, const OcclusionTree* tree,
                               LayerTiles& out, std::uint32_t& out_texels) {
    std::vector<std::uint32_t> candidates;
    const PictureSampler sampler(image, picture_settings(settings, projector));
    find_curved_candidates(map, projector, sampler.margin(), candidates);
    return project_curved_tiles(map, mesh, settings, projector, image, tree, candidates, out, out_texels);
}

TxcStatus project_curved_tiles(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image, const OcclusionTree* tree,
                               const std::vector<std::uint32_t>& candidates, LayerTiles& out,
                               std::uint32_t& out_texels) {
    PictureSampler sampler(image, picture_settings(settings, projector));
    if (const auto* stamp = std::get_if<UvProjector>(&projector))
        return paint_tiles(map, candidates, StampPainter(map, *stamp, sampler), out, out_texels);
    if (const auto* perspective = std::get_if<PerspectiveProjector>(&projector)) {
        return paint_tiles(map, candidates, CurvedPainter(map, mesh, settings, *perspective, sampler, tree), out,
                           out_texels);
    }
    const auto& cylindrical = *std::get_if<CylindricalProjector>(&projector);
    return paint_tiles(map, candidates, CurvedPainter(map, mesh, settings, cylindrical, sampler, tree), out,
                       out_texels);
}

}  // namespace txc
