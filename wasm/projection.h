// The paper's second step: every texel near the decal looks outward and decides alone whether the decal colours it
// (spec sections 4 and 5).
#pragma once

#include <memory>

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

    /// How far beyond its rectangle the picture still paints.
    PictureMargin margin(const ImagePyramid& image) const {
        if (nearest || repeat) return {};
        return {0.5 / image.levels[0].width, 0.5 / image.levels[0].height};
    }

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

/// Whether a texture has so few texels that each of its tiles is large on the model. All of the texture is asked, of which the map may
/// be a window: that has its very texels.
inline bool has_large_tiles(const LocalSpaceMap& map) {
    return map.covered_texels + map.covered_beyond <= 2048u * kTileTexels;
}

/// What came of a tile that was tried as a whole. Not done is one that must be looked at texel by texel, unweighed one whose texels
/// have their colours, and are still to be asked for their angles and depths.
enum class TileFate { kNot, kMissed, kUnweighed, kPainted };

/// A decal of any projector as one tile sees it, where its map is as good as affine.
struct TileView {
    // What a metre along each axis of model space changes: x and y in pixels of the picture, nothing, n . ray.
    Float4 columns[3] = {};
    Float4 centre{};           // where this holds, model space
    Float4 at{};               // x and y there, from the picture's left and top edges
    float ray_spread = 0.0f;   // how far rays over the tile may be from the one at the centre
    bool comes_round = false;  // the picture has another one beside it, and not what it is padded with

    /// Vectors of model space into the picture.
    Float4 turn(Float4 v) const {
        return columns[0] * splat(v[0]) + columns[1] * splat(v[1]) + columns[2] * splat(v[2]);
    }
};

/// Paints a decal's tiles: a planar one's, and whole ones of any other.
class TilePainter final : public LayerPainter {
public:
    TilePainter(const LocalSpaceMap& map, const Mesh& mesh, const DecalSettings& settings, const ImagePyramid& image,
                OccluderGrid* occluders);
    ~TilePainter();
    /// The planar decal. False where it has nothing to paint.
    bool paint_tile(const MapTile& tile, std::uint16_t* texels) override;
    /// Asks for no depth, and for nothing that hides texels.
    TileFate paint(const MapTile& tile, const TileView& view, std::uint16_t* texels);
    /// Whether nothing hides any texel of a tile. With occluders, and of whichever decal they are.
    bool is_clear(const MapTile& tile);
    /// Test 4, likewise.
    bool is_hidden(const TexelRun& run, std::int32_t x, std::int32_t y);

private:
    struct Painter;
    std::unique_ptr<Painter> painter_;
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
