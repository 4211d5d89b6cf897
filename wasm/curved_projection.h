// The paper's second step for projectors whose map is not affine over a triangle, so that each texel has its own place
// in the picture, its own footprint and its own ray (spec sections 3 to 5); and for the flat stamp, which has none of
// the surface. projection.h has the planar projector, whose map is affine and therefore cheaper.
#pragma once

#include <variant>

#include "cylindrical_projector.h"
#include "layer_tiles.h"
#include "occlusion.h"
#include "perspective_projector.h"
#include "projection.h"
#include "uv_projector.h"

namespace txc {

using CurvedProjector = std::variant<PerspectiveProjector, CylindricalProjector, UvProjector>;

/// From an ABI layer's fields, whose projector is not planar. BAD_ARGUMENT names the field.
TxcStatus read_curved_projector(const TxcLayerDef& def, CurvedProjector& out);

/// Places (in LocalSpaceMap::tiles) of the tiles that may take paint, ascending.
void find_curved_candidates(const LocalSpaceMap& map, const CurvedProjector& projector, const PictureMargin& margin,
                            std::vector<std::uint32_t>& out);

/// Paints the decal into `out` (in place of what was there). `settings` without its own projector; `tree` null paints
/// through. `out_texels`: how many texels took colour. Errors: OUT_OF_BUDGET; `out` is then empty.
TxcStatus project_curved_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image, const OcclusionTree* tree,
                               LayerTiles& out, std::uint32_t& out_texels);

/// The same over the given tiles alone, ascending.
TxcStatus project_curved_tiles(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image, const OcclusionTree* tree,
                               const std::vector<std::uint32_t>& candidates, LayerTiles& out,
                               std::uint32_t& out_texels);

}  // namespace txc
