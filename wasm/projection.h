// The paper's second step: every texel near the decal looks outward and decides alone whether the decal colours it
// (spec sections 4 and 5).
#pragma once

#include "image_pyramid.h"
#include "layer_tiles.h"
#include "local_space_map.h"
#include "occluder_grid.h"
#include "projector.h"

namespace txc {

/// A decal layer's own part of the work; opacity and blending are the compositor's.
struct DecalSettings {
    PlanarProjector projector;
    bool nearest = false;
    bool repeat = false;
    bool flip_x = false;
    bool flip_y = false;
    bool backfaces = false;
    float fade_start_cosine = 0.0f;  // weight 1 from here up
    float fade_end_cosine = 0.0f;    // weight 0 from here down

    /// Whether the angle decides otherwise than between front and back.
    bool fades() const { return fade_start_cosine > 0.0f; }

    /// Test 3: the weight of a texel whose normal and ray meet at this cosine.
    float fade_weight(float cosine) const {
        if (cosine >= fade_start_cosine) return 1.0f;
        if (cosine <= fade_end_cosine) return 0.0f;
        return (cosine - fade_end_cosine) / (fade_start_cosine - fade_end_cosine);
    }
    /// The same of four.
    Float4 fade_weights(Float4 cosines) const {
        const Float4 start = splat(fade_start_cosine);
        const Float4 end = splat(fade_end_cosine);
        const Float4 between = select(cosines <= end, splat(0.0f), (cosines - end) / (start - end));
        return select(cosines >= start, splat(1.0f), between);
    }
};

/// The map's tiles that the decal may colour.
std::vector<std::uint32_t> find_candidates(const LocalSpaceMap& map, const DecalSettings& settings,
                                           const ImagePyramid& image);

/// Paints the decal into `out` (in place of what was there), on some of its `candidates`. `occluders` null paints through.
/// `out_texels`: how many texels took colour. Errors: OUT_OF_BUDGET; `out` is then empty.
TxcStatus project_decal(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings,
                        const ImagePyramid& image, const std::vector<std::uint32_t>& candidates,
                        OccluderGrid* occluders, LayerTiles& out, std::uint32_t& out_texels);

}  // namespace txc
