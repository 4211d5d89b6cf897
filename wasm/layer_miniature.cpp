#include "layer_miniature.h"

#include <algorithm>

#include "image_pyramid.h"
#include "texel_bytes.h"

namespace txc {
namespace {

constexpr std::uint32_t kSamples = 2;  // along a side of a pixel

/// Where a miniature looks at the target: row by row, kSamples x kSamples of a pixel apart in the list.
class Samples {
public:
    Samples(const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows, std::uint32_t side)
        : area_(area), columns_(columns), rows_(rows), across_(side * kSamples), steps_(across_) {
        for (std::uint32_t i = 0; i < across_; ++i)
            steps_[i] = static_cast<std::int32_t>((2 * std::int64_t{i} + 1) * area.side / (2 * across_));
    }

    std::size_t size() const { return std::size_t{across_} * across_; }

    /// The node's own colours, premultiplied, on 0 to 1.
    std::vector<Float4> colors_of(const LayerNode& node) const {
        std::vector<Float4> colors(size(), splat(0.0f));
        const TxcLayerDef& def = node.layer->def;
        if (def.kind == TXC_LAYER_GROUP) {
            for (const LayerNode& held : node.content) {
                if (held.is_drawn()) lay(held, colors);
            }
        } else if (node.layer->is_everywhere()) {
            const Float4 color = Float4{def.color[0], def.color[1], def.color[2], 1.0f} * splat(def.color[3]);
            const auto is_within = [](std::int32_t at, std::uint32_t tiles) {
                return at >= 0 && static_cast<std::uint32_t>(at) < tiles * kTileSize;
            };
            for (std::size_t s = 0; s < size(); ++s) {
                if (is_within(area_.x + steps_[s % across_], columns_) &&
                    is_within(area_.y + steps_[s / across_], rows_))
                    colors[s] = color;
            }
        } else {
            lay_tiles(node.layer->tiles, 1.0f, false, colors);
        }
        return colors;
    }

    /// How far the node's mask shows it.
    std::vector<float> shares_of(const LayerNode& node) const {
        std::vector<float> shares(size(), 1.0f);
        for (const LayerNode& part : node.mask) {
            if (!part.is_drawn()) continue;
            const std::vector<float> alphas = alphas_of(part);
            const bool erases = part.layer->def.blend == TXC_BLEND_ERASE;
            for (std::size_t s = 0; s < size(); ++s)
                shares[s] = erases ? shares[s] * (1.0f - alphas[s]) : shares[s] + (1.0f - shares[s]) * alphas[s];
        }
        if (node.layer->def.invert_mask != 0) {
            for (float& share : shares) share = 1.0f - share;
        }
        return shares;
    }

private:
    static void lay_one(Float4 color, bool erases, Float4& below) {
        below = below * splat(1.0f - color[3]);
        if (!erases) below += color;
    }

    /// Looks at no samples but those on the tiles: a group may hold thousands of strokes, each on a few.
    void lay_tiles(const LayerTiles& tiles, float opacity, bool erases, std::vector<Float4>& below) const {
        constexpr auto kSize = static_cast<std::int32_t>(kTileSize);
        const std::uint16_t* texels = tiles.texels.data();
        for (const std::uint32_t tile : tiles.indices) {
            const std::int32_t x0 = static_cast<std::int32_t>(tile % columns_) * kSize - area_.x;
            const std::int32_t y0 = static_cast<std::int32_t>(tile / columns_) * kSize - area_.y;
            const std::size_t first = first_at(x0);
            for (std::size_t j = first_at(y0); j < across_ && steps_[j] < y0 + kSize; ++j) {
                for (std::size_t i = first; i < across_ && steps_[i] < x0 + kSize; ++i) {
                    const std::int32_t texel = (steps_[j] - y0) * kSize + steps_[i] - x0;
                    lay_one(load_ushort4(texels + texel * 4) * splat(1.0f / kFullScale) * splat(opacity), erases,
                            below[j * across_ + i]);
                }
            }
            texels += kTileTexels * 4;
        }
    }

    /// The first step that is `least` or more.
    std::size_t first_at(std::int32_t least) const {
        std::size_t at = 0;
        while (at < across_ && steps_[at] < least) ++at;
        return at;
    }

    void lay(const LayerNode& node, std::vector<Float4>& below) const {
        const TxcLayerDef& def = node.layer->def;
        const bool erases = def.blend == TXC_BLEND_ERASE;
        if (def.kind != TXC_LAYER_GROUP && !node.layer->is_everywhere() && !node.has_mask()) {
            lay_tiles(node.layer->tiles, def.opacity, erases, below);
            return;
        }
        const std::vector<Float4> colors = colors_of(node);
        const std::vector<float> shares = node.has_mask() ? shares_of(node) : std::vector<float>{};
        for (std::size_t s = 0; s < size(); ++s)
            lay_one(colors[s] * splat(shares.empty() ? def.opacity : def.opacity * shares[s]), erases, below[s]);
    }

    std::vector<float> alphas_of(const LayerNode& node) const {
        std::vector<float> alphas(size());
        const std::vector<Float4> own = colors_of(node);
        const std::vector<float> shares = node.has_mask() ? shares_of(node) : std::vector<float>{};
        for (std::size_t s = 0; s < size(); ++s)
            alphas[s] = own[s][3] * node.layer->def.opacity * (shares.empty() ? 1.0f : shares[s]);
        return alphas;
    }

    MiniatureArea area_;
    std::uint32_t columns_;  // of the target, tiles
    std::uint32_t rows_;
    std::uint32_t across_;
    std::vector<std::int32_t> steps_;  // from the area's edge to a sample, texels
};

/// Calls `visit(pixel, sample)` for each sample of each pixel.
template <typename Visit>
void for_each_sample(std::uint32_t side, Visit&& visit) {
    for (std::uint32_t y = 0; y < side * kSamples; ++y) {
        for (std::uint32_t x = 0; x < side * kSamples; ++x) {
            const std::size_t pixel = std::size_t{y / kSamples} * side + x / kSamples;
            visit(pixel, std::size_t{y} * side * kSamples + x);
        }
    }
}

}  // namespace

MiniatureArea miniature_area(const std::vector<std::uint8_t>& tiles, std::uint32_t columns) {
    const auto rows = static_cast<std::uint32_t>(tiles.size()) / columns;
    std::uint32_t x0 = columns, y0 = rows, x1 = 0, y1 = 0;
    for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
        if (tiles[tile] == 0) continue;
        x0 = std::min(x0, tile % columns);
        x1 = std::max(x1, tile % columns + 1);
        y0 = std::min(y0, tile / columns);
        y1 = std::max(y1, tile / columns + 1);
    }
    if (x0 >= x1) {
        x0 = y0 = 0;
        x1 = columns;
        y1 = rows;
    }
    constexpr auto kSize = static_cast<std::int32_t>(kTileSize);
    const auto width = static_cast<std::int32_t>(x1 - x0) * kSize;
    const auto height = static_cast<std::int32_t>(y1 - y0) * kSize;
    const std::int32_t side = std::max(width, height);
    return {static_cast<std::int32_t>(x0) * kSize - (side - width) / 2,
            static_cast<std::int32_t>(y0) * kSize - (side - height) / 2, side};
}

void draw_miniature(const LayerNode& node, const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows,
                    std::uint32_t side, std::uint8_t* out_rgba) {
    const Samples samples(area, columns, rows, side);
    const std::vector<Float4> colors = samples.colors_of(node);
    std::vector<Float4> sums(std::size_t{side} * side, splat(0.0f));
    for_each_sample(side, [&](std::size_t pixel, std::size_t sample) { sums[pixel] += colors[sample]; });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const float alpha = sums[i][3] * (1.0f / (kSamples * kSamples));
        Float4 straight = sums[i] * splat(alpha > 0.0f ? 255.0f / sums[i][3] : 0.0f);
        straight[3] = alpha * 255.0f;
        store_rounded_bytes4(out_rgba + i * 4, greater(straight, splat(0.0f)));
    }
}

void draw_mask_miniature(const LayerNode& node, const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows,
                         std::uint32_t side, std::uint8_t* out_rgba) {
    const Samples samples(area, columns, rows, side);
    const std::vector<float> shares = samples.shares_of(node);
    std::vector<float> sums(std::size_t{side} * side, 0.0f);
    for_each_sample(side, [&](std::size_t pixel, std::size_t sample) { sums[pixel] += shares[sample]; });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const float light = std::max(sums[i] * (255.0f / (kSamples * kSamples)), 0.0f);
        store_rounded_bytes4(out_rgba + i * 4, Float4{light, light, light, 255.0f});
    }
}

}  // namespace txc
