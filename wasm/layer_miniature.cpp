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
    Samples(const MiniatureArea& area, std::uint32_t columns, std::uint32_t rows, std::uint32_t side) {
        const std::uint32_t across = side * kSamples;
        places_.reserve(std::size_t{across} * across);
        const auto at = [&](std::uint32_t index) {
            return static_cast<std::int32_t>((2 * std::int64_t{index} + 1) * area.side / (2 * across));
        };
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::int32_t y = area.y + at(j);
            for (std::uint32_t i = 0; i < across; ++i) places_.push_back(place(area.x + at(i), y, columns, rows));
        }
    }

    std::size_t size() const { return places_.size(); }

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
            for (std::size_t s = 0; s < size(); ++s) colors[s] = places_[s].tile == kNoTile ? splat(0.0f) : color;
        } else {
            read(node.layer->tiles, colors);
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
    struct Place {
        std::uint32_t tile;  // kNoTile beyond the target
        std::uint32_t texel;
    };

    static Place place(std::int32_t x, std::int32_t y, std::uint32_t columns, std::uint32_t rows) {
        constexpr auto kSize = static_cast<std::int32_t>(kTileSize);
        if (x < 0 || y < 0) return {kNoTile, 0};
        const auto column = static_cast<std::uint32_t>(x / kSize);
        const auto row = static_cast<std::uint32_t>(y / kSize);
        if (column >= columns || row >= rows) return {kNoTile, 0};
        return {row * columns + column, static_cast<std::uint32_t>(y % kSize * kSize + x % kSize)};
    }

    void read(const LayerTiles& tiles, std::vector<Float4>& colors) const {
        std::uint32_t known = kNoTile;
        const std::uint16_t* texels = nullptr;
        for (std::size_t s = 0; s < size(); ++s) {
            if (places_[s].tile == kNoTile) continue;
            if (places_[s].tile != known) {
                known = places_[s].tile;
                texels = tiles.find(known);
            }
            if (texels != nullptr)
                colors[s] = load_ushort4(texels + std::size_t{places_[s].texel} * 4) * splat(1.0f / kFullScale);
        }
    }

    void lay(const LayerNode& node, std::vector<Float4>& below) const {
        const std::vector<Float4> colors = colors_of(node);
        const TxcLayerDef& def = node.layer->def;
        const std::vector<float> shares = node.has_mask() ? shares_of(node) : std::vector<float>{};
        for (std::size_t s = 0; s < size(); ++s) {
            const Float4 color = colors[s] * splat(shares.empty() ? def.opacity : def.opacity * shares[s]);
            below[s] = below[s] * splat(1.0f - color[3]);
            if (def.blend != TXC_BLEND_ERASE) below[s] += color;
        }
    }

    std::vector<float> alphas_of(const LayerNode& node) const {
        std::vector<float> alphas(size());
        const std::vector<Float4> own = colors_of(node);
        const std::vector<float> shares = node.has_mask() ? shares_of(node) : std::vector<float>{};
        for (std::size_t s = 0; s < size(); ++s)
            alphas[s] = own[s][3] * node.layer->def.opacity * (shares.empty() ? 1.0f : shares[s]);
        return alphas;
    }

    std::vector<Place> places_;
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
