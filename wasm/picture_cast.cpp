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
    if (projector != TXC_PROJECTOR_PLANAR) return read_curved_projector(def, curved);
    return PlanarProjector::from_def(def, settings.projector);
}

TxcStatus cast_picture(const CastScene& scene, const PictureCast& cast, const ImagePyramid& image, LayerTiles& out,
                       std::uint32_t& out_texels) {
    const OcclusionTree* tree = cast.asks_for_occluders() ? scene.tree : nullptr;
    if (cast.projector != TXC_PROJECTOR_PLANAR) {
        return project_curved_decal(scene.map, scene.mesh, cast.settings, cast.curved, image, tree, out, out_texels);
    }
    const std::vector<std::uint32_t> candidates = find_candidates(scene.map, cast.settings, image);
    if (tree == nullptr || candidates.empty())
        return project_decal(scene.map, scene.mesh, cast.settings, image, candidates, nullptr, out, out_texels);
    // Not the scene's while they are in use: where memory runs short, that is given up.
    std::unique_ptr<OccluderGrid> occluders = std::move(scene.occluders);
    if (occluders == nullptr || !occluders->is_of(cast.settings.projector)) {
        occluders.reset();
        occluders = std::make_unique<OccluderGrid>(scene.mesh, *tree, cast.settings.projector, scene.budget);
        if (const TxcStatus status = occluders->build(); status != TXC_STATUS_OK) return status;
    }
    const TxcStatus status =
        project_decal(scene.map, scene.mesh, cast.settings, image, candidates, occluders.get(), out, out_texels);
    scene.occluders = std::move(occluders);
    return status;
}

}  // namespace txc
