#include "picture_cast.h"

#include "exact_math.h"

namespace txc {

void PictureCast::read_settings(const TxcLayerDef& def) {
    settings.nearest = def.filter == TXC_FILTER_NEAREST;
    settings.repeat = def.wrap == TXC_WRAP_REPEAT;
    settings.flip_x = def.flip_x != 0;
    settings.flip_y = def.flip_y != 0;
    settings.backfaces = def.backfaces != 0;
    settings.fade_start_cosine = static_cast<float>(exact_cos_degrees(static_cast<double>(def.angle_fade_start)));
    settings.fade_end_cosine = static_cast<float>(exact_cos_degrees(static_cast<double>(def.angle_fade_end)));
    occludes = def.occlusion == TXC_OCCLUSION_SELF;
}

TxcStatus PictureCast::read_projector(const TxcLayerDef& def) {
    projector = def.projector;
    if (projector != TXC_PROJECTOR_PLANAR) return read_curved_projector(def, origin, curved);
    return PlanarProjector::from_def(def, origin, settings.projector);
}

std::vector<std::uint32_t> find_candidates(const LocalSpaceMap& map, const PictureCast& cast,
                                           const ImagePyramid& image) {
    return cast.projector == TXC_PROJECTOR_PLANAR ? find_candidates(map, cast.settings, image)
                                                  : find_curved_candidates(map, cast.settings, cast.curved, image);
}

TxcStatus cast_picture(const CastScene& scene, const PictureCast& cast, const ImagePyramid& image, LayerTiles& out,
                       std::uint32_t& out_texels) {
    const OcclusionTree* tree = cast.asks_for_occluders() ? scene.tree : nullptr;
    const std::vector<std::uint32_t> candidates = find_candidates(scene.map, cast, image);
    const auto project = [&](OccluderGrid* occluders) {
        if (cast.projector == TXC_PROJECTOR_PLANAR)
            return project_decal(scene.map, scene.mesh, cast.settings, image, candidates, occluders, out, out_texels);
        return project_curved_decal(scene.map, scene.mesh, cast.settings, cast.curved, image, candidates, tree,
                                    occluders, out, out_texels);
    };
    if (tree == nullptr || candidates.empty() || cast.projector == TXC_PROJECTOR_CYLINDRICAL) return project(nullptr);
    const RaySpace space = cast.projector == TXC_PROJECTOR_PLANAR
                               ? RaySpace(cast.settings.projector)
                               : RaySpace(std::get<PerspectiveProjector>(cast.curved), scene.mesh.bounds);
    // Not the scene's while they are in use: where memory runs short, that is given up.
    std::unique_ptr<OccluderGrid> occluders = std::move(scene.occluders);
    if (occluders == nullptr || !occluders->is_of(space)) {
        occluders.reset();
        occluders = std::make_unique<OccluderGrid>(scene.mesh, *tree, space, scene.budget);
        if (const TxcStatus status = occluders->build(); status != TXC_STATUS_OK) return status;
    }
    const TxcStatus status = project(occluders->is_whole() ? occluders.get() : nullptr);
    scene.occluders = std::move(occluders);
    return status;
}

}  // namespace txc
