// A target's tree of layers onto one tile after another (texelcast.h, "Layers").
#pragma once

#include <vector>

#include "target.h"
#include "tile_blend.h"

namespace txc {

/// A layer with those in it. Hidden ones stand there too: places are counted over all.
struct LayerNode {
    TxcLayer id = 0;
    const Layer* layer = nullptr;
    std::vector<LayerNode> content;  // bottom to top, as the mask's
    std::vector<LayerNode> mask;

    /// Whether anything of it may show.
    bool is_drawn() const { return layer->def.visible != 0 && layer->def.opacity > 0.0f; }
    /// Its content is laid straight onto what is below, as if there were no group.
    bool is_open() const;
    /// Its content is laid onto what is below, of which a share is then taken back.
    bool is_passed_through() const {
        return layer->def.kind == TXC_LAYER_GROUP && layer->def.isolated == 0 && layer->def.blend == TXC_BLEND_NORMAL;
    }
    bool has_mask() const;
};

/// The part of a tile that lies inside the target.
struct TileArea {
    std::uint32_t x, y, width, height;
};

/// Writes tiles of level 0, in ascending order.
class TileCompositor {
public:
    TileCompositor(Target& target, const std::vector<LayerNode>& layers);

    /// Returns whether any byte changed.
    bool composite(std::uint32_t tile, const TileArea& area);

private:
    /// A drawn node while the tiles go by.
    struct Walk {
        explicit Walk(const LayerNode& node);

        const LayerNode* node;
        TileMode mode{};
        TilePaint paint{};
        std::vector<Walk> content;
        std::vector<Walk> mask;
        std::vector<std::uint32_t>::const_iterator next;  // of the layer's tiles
        bool is_open;
        bool is_active = false;  // on the tile at hand

        bool is_group() const { return node->layer->def.kind == TXC_LAYER_GROUP; }
        bool find(std::uint32_t tile);
        bool find_mask(std::uint32_t tile);
    };
    /// Texels that layers are laid on: a tile's backdrops, or an isolated group's own.
    struct Ground {
        Float4* texels;
        bool is_isolated;
    };
    /// Backdrops on their way into the cache, or out of it.
    struct States {
        Float4* next;
        bool are_known;
    };

    static std::vector<Walk> drawn(const std::vector<LayerNode>& layers);
    bool find_path(const std::vector<Walk>& walks, TxcLayer split);
    void find_paints(std::vector<Walk>& walks, std::uint32_t tile, std::size_t level, bool from_split);
    void list_plain(std::vector<Walk>& walks);
    void lay(std::vector<Walk>& walks, const Ground& ground, std::size_t level, States* states);
    void lay_one(Walk& walk, const Ground& ground, std::size_t level, States* states);
    void lay_group(Walk& walk, const Ground& ground, std::size_t level, States* states);
    static void mask_shares(const Walk& walk, float* shares);
    static void lay_sources(const Walk& walk, const Ground& ground, Float4* sources);

    TexelRows base_rows(const TileArea& area) const;
    void blend(std::uint32_t tile, std::uint8_t* bytes);

    Target& target_;
    std::vector<Walk> walks_;
    std::vector<TilePaint> paints_;  // on the tile at hand, bottom to top, while all of them are plain
    bool is_plain_ = true;
    std::uint8_t color_row_[kTileSize * 4];

    // Places from list to list down to the layer below which backdrops are held; empty where none are.
    std::vector<std::size_t> path_;
    std::size_t state_count_ = 1;   // grounds along the path
    std::size_t paints_below_ = 0;  // the path's end, on the tile at hand
    bool is_below_ = false;         // while they are counted
};

}  // namespace txc
