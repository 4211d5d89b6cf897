// One layer's paint onto one tile: the mode is chosen once here, not at every texel.
#pragma once

#include <cstddef>
#include <cstdint>

#include "float4.h"
#include "layer_tiles.h"
#include "texelcast.h"

namespace txc {

/// How sources go onto what is below them.
struct TileMode {
    std::uint32_t blend;        // TxcBlend
    std::uint32_t blend_space;  // TxcBlendSpace
    bool lock_alpha;

    /// Normal in sRGB: all that the way over opaque tiles knows.
    bool is_plain() const { return blend == TXC_BLEND_NORMAL && blend_space == TXC_BLEND_SPACE_SRGB; }
};

/// What a layer lays on one tile.
struct TilePaint {
    const std::uint16_t* texels;  // of LayerTiles, or null: `color` everywhere
    Float4 scale;                 // decal: what makes sources (blend.h) of `texels`
    Float4 color;                 // fill: the source
    bool is_unfaded;              // opacity 1, and not `color`
};

/// A paint as sources (blend.h), one a texel; those with alpha 0 leave the backdrop alone.
void load_sources(const TilePaint& paint, Float4* sources);
/// Sources as far as a mask shows them: `shares` 0 to 1, one a texel.
void mask_sources(const float* shares, Float4* sources);

/// Sources onto a tile's backdrops (blend.h; kTileTexels of them), in any mode.
void blend_tile(const TileMode& mode, const Float4* sources, Float4* backdrops);

/// Onto an isolated group's texels, which begin as zeros and are sources themselves: the first thing that is laid on one
/// stays what it is to the last bit.
void blend_isolated(const TileMode& mode, const Float4* sources, Float4* texels);

/// What a group that is not isolated leaves: from `before` (blend.h) as far as `shares` say to `after`, in place of it.
/// `isolated`: both are texels of an isolated group around it, else backdrops.
void interpolate_tile(const TileMode& mode, bool isolated, const Float4* before, const float* shares, Float4* after);

/// Rows of texels in a picture, RGBA.
struct TexelRows {
    const std::uint8_t* first;
    std::size_t stride;  // bytes from row to row; 0 where one row serves all
};

/// Plain paints (at least one), bottom to top, onto an opaque whole tile, straight from base bytes to output bytes: the
/// same bytes as through blend_tile. Rows of `out` lie `out_stride` bytes apart. Returns whether any of them changed.
bool paint_opaque_tile(const TexelRows& base, const TilePaint* paints, std::size_t count, std::uint8_t* out,
                       std::size_t out_stride);

}  // namespace txc
