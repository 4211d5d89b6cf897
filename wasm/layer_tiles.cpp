#include "layer_tiles.h"

#include "texel_bytes.h"

namespace txc {
namespace {

/// How many texels of a tile have taken colour.
std::uint32_t count_painted(const std::uint16_t* texels) {
    UShort8 clear{};  // minus one for each that has not
    for (std::uint32_t i = 0; i < kTileTexels * 4; i += 8) {
        UShort8 two;
        std::memcpy(&two, texels + i, sizeof two);
        clear += reinterpret_cast<UShort8>(two == 0);
    }
    return kTileTexels - (static_cast<std::uint16_t>(-clear[3]) + std::uint32_t{static_cast<std::uint16_t>(-clear[7])});
}

}  // namespace

TxcStatus paint_tiles(const LocalSpaceMap& map, const std::vector<std::uint32_t>& candidates, LayerPainter& painter,
                      LayerTiles& out, std::uint32_t& out_texels) {
    out.indices.clear();
    out_texels = 0;
    constexpr std::size_t kTileBytes = kTileTexels * 4 * sizeof(std::uint16_t) + sizeof(std::uint32_t);
    // Dragged layers keep their arrays from step to step; one that shrank a lot gives them back.
    if (out.texels.capacity() > candidates.size() * kTileTexels * 4 * 4) {
        out.texels.clear();
        out.texels.shrink_to_fit();
    }
    const std::size_t tiles = std::max(candidates.size(), out.texels.capacity() / (kTileTexels * 4));
    if (const TxcStatus status = out.share.resize(tiles * kTileBytes, "projecting a layer"); status != TXC_STATUS_OK) {
        out.texels.clear();
        return status;
    }
    // What an earlier step left is not cleared: every tile is written anew.
    out.texels.resize(candidates.size() * kTileTexels * 4);
    std::uint16_t* texels = out.texels.data();
    for (const std::uint32_t place : candidates) {
        const std::uint32_t painted = painter.paint_tile(map.tiles[place], texels) ? count_painted(texels) : 0;
        if (painted == 0) continue;
        texels += kTileTexels * 4;
        out.indices.push_back(map.tiles[place].index);
        out_texels += painted;
    }
    out.texels.resize(out.indices.size() * kTileTexels * 4);
    return TXC_STATUS_OK;
}

}  // namespace txc
