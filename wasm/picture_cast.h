// One picture cast at the surface by one projector of any kind: what a decal is, and each dab of a stroke.
#pragma once

#include <memory>

#include "curved_projection.h"
#include "projection.h"

namespace txc {

/// How a picture is cast; from an ABI layer's fields.
struct PictureCast {
    DecalSettings settings{};  // with the projector, where it is planar
    CurvedProjector curved;    // the projector, where it is not
    std::uint32_t projector = TXC_PROJECTOR_PLANAR;
    bool occludes = false;
    glm::vec3 origin{0.0f};  // of the mesh that it is cast at, model space

    /// Reads all but the projector.
    void read_settings(const TxcLayerDef& def);
    /// Reads the projector, from `origin`. BAD_ARGUMENT names the field.
    TxcStatus read_projector(const TxcLayerDef& def);

    /// The flat stamp asks no surface what hides it.
    bool asks_for_occluders() const { return occludes && projector != TXC_PROJECTOR_UV; }
};

/// The map's tiles that the picture may colour.
std::vector<std::uint32_t> find_candidates(const LocalSpaceMap& map, const PictureCast& cast,
                                           const ImagePyramid& image);

/// What pictures are cast at.
struct CastScene {
    const LocalSpaceMap& map;
    const Mesh& mesh;
    const OcclusionTree* tree;  // of `mesh`; null where no cast asks for occluders
    MemoryBudget& budget;
    /// Of the newest planar or perspective cast that asked, null for none: a decal over several materials is cast at the map of each.
    std::unique_ptr<OccluderGrid>& occluders;
};

/// Paints the picture into `out` (in place of what was there). `out_texels`: how many texels took colour. Errors:
/// OUT_OF_BUDGET; `out` is then empty, or as it was.
TxcStatus cast_picture(const CastScene& scene, const PictureCast& cast, const ImagePyramid& image, LayerTiles& out,
                       std::uint32_t& out_texels);

}  // namespace txc
