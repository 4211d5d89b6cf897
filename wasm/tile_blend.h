// One layer's paint onto one tile: the mode is chosen once here, not at every texel.
#pragma once

#include <cstddef>
#include <cstdint>

#include "float4.h"
#include "layer_tiles.h"
#include "texelcast.h"

namespace txc {

/// What a layer lays on one tile.
struct TilePaint {
    const std::uint16_t* texels;  // of LayerTiles, or null: `color` everywhere
    Float4 scale;                 // decal: what makes sources (blend.h) of `texels`
    Float4 color;                 // fill: the source
    std::uint32_t blend;          // TxcBlend
    std::uint32_t blend_space;    // TxcBlendSpace
    bool lock_alpha;
    bool is_unfaded;  // decal: opacity 1

    /// Normal in sRGB: all that the way over opaque tiles knows.
    bool is_plain() const { return blend == TXC_BLEND_NORMAL && blend_space == TXC_BLEND_SPACE_SRGB; }
};

/// Onto a tile's backdrops (blend.h; kTileTexels of them), in any mode.
void blend_tile(const TilePaint& paint, Float4* backdrops);

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
