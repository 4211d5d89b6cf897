// The paper's second step for projectors whose map is not affine over a triangle, so that each texel has its own place
// in the picture, its own footprint and its own ray (spec sections 3 to 5); and for the flat stamp, which has none of
// the surface. projection.h has the planar projector, whose map is affine and therefore cheaper: where a tile is so small that any map
// is affine over it, its colours are painted that way here, too (a perspective decal over a mug and two tori at 2048 x 2048 takes 0.14
// to 0.2 of the time, a cylindrical one 0.43 to 0.67), and texels are looked at one by one for their angles and what hides them, if at all.
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

/// From an ABI layer's fields, whose projector is not planar; `origin` as of ProjectorPose. BAD_ARGUMENT names the field.
TxcStatus read_curved_projector(const TxcLayerDef& def, const glm::vec3& origin, CurvedProjector& out);

/// Places (in LocalSpaceMap::tiles) of the tiles that the decal may colour, ascending. `settings` without its own projector.
std::vector<std::uint32_t> find_curved_candidates(const LocalSpaceMap& map, const DecalSettings& settings,
                                                  const CurvedProjector& projector, const ImagePyramid& image);

/// Paints the decal into `out` (in place of what was there), on some of its `candidates`. `tree` and `occluders` null paint through;
/// where rays run side by side in a space there are occluders, and else the tree is asked. `out_texels`: how many texels took
/// colour. Errors: OUT_OF_BUDGET; `out` is then empty.
TxcStatus project_curved_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                               const CurvedProjector& projector, const ImagePyramid& image,
                               const std::vector<std::uint32_t>& candidates, const OcclusionTree* tree,
                               OccluderGrid* occluders, LayerTiles& out, std::uint32_t& out_texels);

}  // namespace txc
