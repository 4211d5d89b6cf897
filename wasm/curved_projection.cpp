#include "curved_projection.h"

#include <algorithm>
#include <cmath>

#include "picture_sampler.h"

namespace txc {
namespace {

// A tile is painted at once where what its texels see beside their own places differs by no more than this: pixels, or as much of half
// a footprint's side where that is longer. On textures of few texels less: there each tile is large on the model, and all cost little.
//
// Against texel by texel, slides and labels over a sphere with checkers of 1, 3 and 5 pixels, at up to two pixels a texel, then keep 49
// dB at 1024 x 1024, 50 at 2048 x 2048 and 74 at 512 x 512. (With as much of the whole side checkers seen at three pixels a texel keep
// 44 dB where they have 53, and a slide of 1024 pixels takes 0.81 of the time.)
constexpr float kMostStray = 1.0f / 16.0f;
constexpr float kMostStrayOfFew = 1.0f / 64.0f;

glm::dvec3 three(Float4 v) { return {v[0], v[1], v[2]}; }

/// A perspective projector or a cylindrical one. (A painter for each is 0.4 kB more of the module, and none is quicker.)
class SolidProjector {
public:
    explicit SolidProjector(const CurvedProjector& projector)
        : perspective_(std::get_if<PerspectiveProjector>(&projector)),
          cylindrical_(std::get_if<CylindricalProjector>(&projector)) {}

    const ProjectorPose& pose() const { return perspective_ != nullptr ? perspective_->pose : cylindrical_->pose; }
    bool look(const TexelPlace& at, TexelSight& out) const {
        return perspective_ != nullptr ? perspective_->look(at, out) : cylindrical_->look(at, out);
    }
    bool holds(const glm::dvec3& point, double reach) const {
        return perspective_ != nullptr ? perspective_->holds(point, reach) : cylindrical_->holds(point, reach);
    }
    bool ray_from(const glm::dvec3& point, glm::dvec3& out_direction, double& out_length) const {
        return perspective_ != nullptr ? perspective_->ray_from(point, out_direction, out_length)
                                       : cylindrical_->ray_from(point, out_direction, out_length);
    }
    bool may_touch(const ModelBox& box, const PictureMargin& margin) const {
        return perspective_ != nullptr ? perspective_->may_touch(box, margin) : cylindrical_->may_touch(box, margin);
    }

private:
    const PerspectiveProjector* perspective_;
    const CylindricalProjector* cylindrical_;
};

class CurvedPainter final : public LayerPainter {
public:
    CurvedPainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                  const CurvedProjector& projector, const ImagePyramid& image, PictureSampler& sampler,
                  const OcclusionTree* tree, OccluderGrid* occluders)
        : map_(map),
          mesh_(mesh),
          settings_(settings),
          projector_(projector),
          sampler_(sampler),
          tree_(tree),
          occluders_(occluders),
          tiles_(map, mesh, settings, image, occluders) {}

    /// Paints one tile's texels into `texels`. False where it has none to paint.
    bool paint_tile(const MapTile& tile, std::uint16_t* texels) override {
        ray_count_ = 0;
        TileView view;
        TileFate fate = TileFate::kNot;
        if (!settings_.nearest && find_view(tile, view)) fate = tiles_.paint(tile, view, texels);
        if (fate == TileFate::kMissed) return false;
        if (fate == TileFate::kPainted && !asks_tree() && tiles_.is_clear(tile)) return true;
        if (fate == TileFate::kNot) clear_tile(texels);
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            paint_run(run, fate, tile_x + run.x, tile_y + run.y, texels + (run.y * kTileSize + run.x) * 4);
        });
        // Last, as it costs most: where the picture is transparent it need not be asked.
        if (ray_count_ > 0) tree_->clear_blocked(rays_, rays_ + ray_count_);
        return true;
    }

private:
    /// The projector's map about a tile's middle, as an affine one. False where it is not as good as that, and where some texels may
    /// lie before the volume or behind it.
    bool find_view(const MapTile& tile, TileView& view) const {
        const std::uint32_t place = map_.tile_of[tile.index];
        const TilePatch& patch = map_.patches->find(map_, place);
        if (patch.state != TilePatch::State::kUniform) return false;
        const ProjectorPose& pose = projector_.pose();
        TexelPlace at{};
        TexelSight sight;
        const auto look = [&](Float4 point) {
            at.position = pose.to_view(three(point));
            return projector_.look(at, sight);
        };
        const double reach = glm::length(three(patch.step)) * 32767.0;
        if (!projector_.holds(pose.to_view(three(patch.middle)), reach)) return false;
        for (int c = 0; c < 3; ++c) {
            at.across = glm::dvec3(pose.right[c], pose.up[c], pose.towards[c]);
            if (!look(patch.middle)) return false;
            const PictureSight& seen = sight.picture;
            view.at = sampler_.in_pixels(seen.x, seen.y, 0.5);
            view.columns[c] = sampler_.in_pixels(seen.across_x, seen.across_y, 0.0);
            view.columns[c][3] = static_cast<float>(pose.turn_to_model(sight.ray)[c]);
        }
        view.centre = patch.middle;
        view.comes_round = sampler_.comes_round();
        const glm::dvec3 ray = sight.ray;
        // How far texels are seen beside their own places, least and most: by the ends of every fifth row of a full tile, else of all.
        Float4 low{};
        Float4 high{};
        const PatchTexels& places = map_.patches->texels(map_, place);
        for (std::uint32_t y = 0; y < kTileSize; y += patch.there.is_full ? 5 : 1) {
            const std::uint32_t row = patch.there.rows[y];
            if (row == 0) continue;
            for (const int x : {__builtin_ctz(row), 31 - __builtin_clz(row)}) {
                const Float4 from_middle = places.at(y * kTileSize + static_cast<std::uint32_t>(x)) * patch.step;
                if (!look(patch.middle + from_middle)) return false;
                const Float4 stray =
                    sampler_.in_pixels(sight.picture.x, sight.picture.y, 0.5) - view.at - view.turn(from_middle);
                low = lesser(low, stray);
                high = greater(high, stray);
                view.ray_spread = std::max(view.ray_spread, static_cast<float>(glm::length(sight.ray - ray)));
            }
        }
        view.at += (low + high) * splat(0.5f);
        const Float4 sides = greater(absolute(view.turn(patch.across)), absolute(view.turn(patch.down)));
        const Float4 strays = high - low;
        const float most = has_large_tiles(map_) ? kMostStrayOfFew : kMostStray;
        return std::max(strays[0], strays[1]) <= most * std::max(1.0f, 0.5f * std::max(sides[0], sides[1]));
    }

    /// What `fate` has left to do for the run's texels: their colours, their weights, or no more than to ask what hides them.
    void paint_run(const TexelRun& run, TileFate fate, std::int32_t x0, std::int32_t y0, std::uint16_t* texels) {
        const TexelFrame& frame = map_.frames[run.frame];
        const ProjectorPose& pose = projector_.pose();
        using Coordinate = TexelFrame::Coordinate;
        const auto turned = [&pose](const Coordinate(&of)[3], float Coordinate::*member) {
            return pose.turn_to_view(glm::dvec3(TexelFrame::part(of, member)));
        };
        const bool has_colors = fate != TileFate::kNot;
        const bool holds_normal = (run.flags & kRunHoldNormal) != 0;
        const double down = y0 - frame.y0;
        TexelPlace at{{}, turned(frame.position, &Coordinate::dx), turned(frame.position, &Coordinate::dy)};
        const glm::dvec3 first =
            pose.to_view(glm::dvec3(TexelFrame::part(frame.position, &Coordinate::at))) + at.down * down;
        glm::dvec3 normal = turned(frame.normal, &Coordinate::at);
        glm::dvec3 normal_dx(0.0);
        if (!holds_normal) {
            normal_dx = turned(frame.normal, &Coordinate::dx);
            normal += turned(frame.normal, &Coordinate::dy) * down;
        }
        for (std::int32_t i = 0; i < run.length; ++i, texels += 4) {
            if (has_colors && texels[3] == 0) continue;
            const double across = x0 + i - frame.x0;
            at.position = first + at.across * across;
            Float4 color = load_ushort4(texels);
            if (fate != TileFate::kPainted) {
                TexelSight sight;
                float weight = 0.0f;
                if (projector_.look(at, sight) && (has_colors || sampler_.aim(sight.picture)))
                    weight = facing_weight(normal + normal_dx * across, sight.ray);
                if (weight > 0.0f && !has_colors) color = sampler_.sample();
                color *= splat(weight);
                store_rounded_ushort4(texels, color);
            }
            if (!(color[3] > 0.0f)) continue;
            if (asks_tree()) {
                ask_for_blockers(run, frame, at.position, texels);
            } else if (occluders_ != nullptr && tiles_.is_hidden(run, x0 + i, y0)) {
                std::fill_n(texels, 4, std::uint16_t{0});
            }
        }
    }

    /// Whether what hides texels is asked ray by ray.
    bool asks_tree() const { return tree_ != nullptr && occluders_ == nullptr; }

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
        const ProjectorPose& pose = projector_.pose();
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
    SolidProjector projector_;
    PictureSampler& sampler_;
    const OcclusionTree* tree_;
    OccluderGrid* occluders_;
    TilePainter tiles_;
    // Of the tile's texels that may be hidden.
    TexelRay rays_[kTileTexels];
    std::uint32_t ray_count_ = 0;
};

/// Paints the flat stamp: every texel that there is, whatever lies under it.
class StampPainter final : public LayerPainter {
public:
    StampPainter(const LocalSpaceMap& map, const UvProjector& projector, PictureSampler& sampler)
        : map_(map), projector_(projector), sampler_(sampler) {}

    bool paint_tile(const MapTile& tile, std::uint16_t* texels) override {
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

PictureSettings picture_settings(const DecalSettings& settings, const CurvedProjector& projector) {
    const auto* label = std::get_if<CylindricalProjector>(&projector);
    return {settings.nearest, settings.repeat, settings.flip_x, settings.flip_y,
            label != nullptr ? label->period : 0.0};
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

TxcStatus read_curved_projector(const TxcLayerDef& def, const glm::vec3& origin, CurvedProjector& out) {
    if (def.projector == TXC_PROJECTOR_PERSPECTIVE)
        return PerspectiveProjector::from_def(def, origin, out.emplace<PerspectiveProjector>());
    if (def.projector == TXC_PROJECTOR_CYLINDRICAL)
        return CylindricalProjector::from_def(def, origin, out.emplace<CylindricalProjector>());
    return UvProjector::from_def(def, out.emplace<UvProjector>());
}

std::vector<std::uint32_t> find_curved_candidates(const LocalSpaceMap& map, const DecalSettings& settings,
                                                  const CurvedProjector& projector, const ImagePyramid& image) {
    std::vector<std::uint32_t> candidates;
    const PictureMargin margin = settings.margin(image);
    if (const auto* stamp = std::get_if<UvProjector>(&projector)) {
        find_stamp_candidates(map, *stamp, margin, candidates);
    } else {
        const SolidProjector solid(projector);
        map.tree.find(
            map, [&](const ModelBox& box) { return solid.may_touch(box, margin); }, candidates);
    }
    return candidates;
}

TxcStatus project_curved_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image,
                               const std::vector<std::uint32_t>& candidates, const OcclusionTree* tree,
                               OccluderGrid* occluders, LayerTiles& out, std::uint32_t& out_texels) {
    PictureSampler sampler(image, picture_settings(settings, projector));
    if (const auto* stamp = std::get_if<UvProjector>(&projector)) {
        StampPainter painter(map, *stamp, sampler);
        return paint_tiles(map, candidates, painter, out, out_texels);
    }
    CurvedPainter painter(map, mesh, settings, projector, image, sampler, tree, occluders);
    return paint_tiles(map, candidates, painter, out, out_texels);
}

}  // namespace txc
