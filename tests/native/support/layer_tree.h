// Trees of layers by lot on a square whose texels are pictures' pixels one to one, and what the standard's formulas make
// of them in double precision: W3C's isolated groups, groups passed through, and masks (texelcast.h, "Layers").
#pragma once

#include <memory>
#include <vector>

#include "reference_blend.h"
#include "test_session.h"

namespace support {

/// A layer, what it paints, and those in it.
struct TreeLayer {
    TxcLayerDef def{};
    Picture picture;  // of all but groups
    std::vector<TreeLayer> content;
    std::vector<TreeLayer> mask;
    TxcLayer handle = 0;
};

using Pixels = std::vector<Pixel>;

inline Pixels to_pixels(const Picture& picture) {
    Pixels pixels;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) pixels.push_back(to_pixel(picture.at(x, y)));
    }
    return pixels;
}

inline bool is_passed_through(const TxcLayerDef& def) { return def.isolated == 0 && def.blend == TXC_BLEND_NORMAL; }

inline void lay_reference(const std::vector<TreeLayer>& layers, Pixels& ground);

/// How far each texel of a layer shows.
inline std::vector<double> reference_mask(const TreeLayer& layer, std::size_t count) {
    std::vector<double> alpha(count, 1.0);
    for (const TreeLayer& part : layer.mask) {
        if (part.def.visible == 0 || part.def.lock_alpha != 0) continue;
        const std::vector<double> own = reference_mask(part, count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto x = static_cast<std::uint32_t>(i % part.picture.width);
            const auto y = static_cast<std::uint32_t>(i / part.picture.width);
            const double source =
                to_pixel(part.picture.at(x, y)).alpha * static_cast<double>(part.def.opacity) * own[i];
            alpha[i] = part.def.blend == TXC_BLEND_ERASE ? alpha[i] * (1 - source) : source + alpha[i] * (1 - source);
        }
    }
    if (layer.def.invert_mask != 0) {
        for (double& value : alpha) value = 1 - value;
    }
    return alpha;
}

/// From before to after as far as `share` says, by premultiplied colour.
inline Pixel between(const TxcLayerDef& def, const Pixel& before, const Pixel& after, double share) {
    Pixel out = before;
    const double alpha = before.alpha + (after.alpha - before.alpha) * share;
    const double weights[2] = {before.alpha * (1 - share), after.alpha * share};
    if (weights[0] + weights[1] > 0) {
        const bool linear = def.blend_space == TXC_BLEND_SPACE_LINEAR;
        for (int c = 0; c < 3; ++c) {
            const double from = linear ? decode_srgb(before.color[c]) : before.color[c];
            const double to = linear ? decode_srgb(after.color[c]) : after.color[c];
            const double mixed = (from * weights[0] + to * weights[1]) / (weights[0] + weights[1]);
            out.color[c] = linear ? encode_srgb(mixed) : mixed;
        }
    }
    out.alpha = def.lock_alpha != 0 ? before.alpha : alpha;
    return def.lock_alpha != 0 && before.alpha == 0 ? before : out;
}

inline void lay_reference(const TreeLayer& layer, Pixels& ground) {
    if (layer.def.visible == 0) return;
    const std::vector<double> shown = reference_mask(layer, ground.size());
    const bool is_group = layer.def.kind == TXC_LAYER_GROUP;
    if (is_group && is_passed_through(layer.def)) {
        const Pixels before = ground;
        lay_reference(layer.content, ground);
        for (std::size_t i = 0; i < ground.size(); ++i)
            ground[i] = between(layer.def, before[i], ground[i], shown[i] * static_cast<double>(layer.def.opacity));
        return;
    }
    Pixels sources = is_group ? Pixels(ground.size(), Pixel{{0, 0, 0}, 0}) : to_pixels(layer.picture);
    if (is_group) lay_reference(layer.content, sources);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        Pixel source = sources[i];
        source.alpha *= shown[i];
        ground[i] = composite(layer.def, ground[i], source);
    }
}

inline void lay_reference(const std::vector<TreeLayer>& layers, Pixels& ground) {
    for (const TreeLayer& layer : layers) lay_reference(layer, ground);
}

/// A picture that leaves some of its tiles alone, so that layers are there on some tiles and not on others.
inline Picture patchy_noise(std::uint32_t size, Random& random) {
    Picture picture = make_noise(size, size, random.next(), true);
    for (std::uint32_t ty = 0; ty < size; ty += 16) {
        for (std::uint32_t tx = 0; tx < size; tx += 16) {
            const std::uint32_t lot = random.below(4);
            for (std::uint32_t y = ty; y < std::min(size, ty + 16); ++y) {
                for (std::uint32_t x = tx; x < std::min(size, tx + 16); ++x) {
                    Color color = picture.at(x, y);
                    if (lot == 0) color.alpha = 0;
                    if (lot == 1) color.alpha = 255;
                    picture.set(x, y, color);
                }
            }
        }
    }
    return picture;
}

/// Modes whose formulas have no cliff, where the last digit of one layer would decide all of the next.
inline std::uint32_t draw_smooth_mode(Random& random) {
    constexpr std::uint32_t kSmooth[] = {TXC_BLEND_NORMAL,     TXC_BLEND_NORMAL, TXC_BLEND_NORMAL,
                                         TXC_BLEND_MULTIPLY,   TXC_BLEND_SCREEN, TXC_BLEND_DARKEN,
                                         TXC_BLEND_DIFFERENCE, TXC_BLEND_ERASE,  TXC_BLEND_EXCLUSION};
    return kSmooth[random.below(std::size(kSmooth))];
}

/// A layer by lot; `levels` of others may lie in it.
inline TreeLayer draw_layer(std::uint32_t size, int levels, bool in_mask, Random& random) {
    TreeLayer layer;
    layer.def = decal_def(0);
    layer.def.filter = TXC_FILTER_NEAREST;
    const bool is_group = levels > 0 && !in_mask && random.below(2) == 0;
    if (is_group) {
        layer.def.kind = TXC_LAYER_GROUP;
        layer.def.isolated = random.below(2);
        for (std::uint32_t i = random.below(4); i > 0; --i)
            layer.content.push_back(draw_layer(size, levels - 1, false, random));
    } else {
        layer.picture = patchy_noise(size, random);
    }
    layer.def.blend = random.coin() ? std::uint32_t{TXC_BLEND_NORMAL} : draw_smooth_mode(random);
    layer.def.blend_space = random.below(2);
    layer.def.opacity = random.coin() ? 1.0f : static_cast<float>(random.between(0.2, 1));
    layer.def.visible = random.below(8) == 0 ? 0 : 1;
    layer.def.lock_alpha = random.below(6) == 0 ? 1 : 0;
    if (levels > 0 && random.below(3) == 0) {
        layer.def.invert_mask = random.below(2);
        for (std::uint32_t i = random.below(3); i > 0; --i)
            layer.mask.push_back(draw_layer(size, levels - 1, true, random));
        for (TreeLayer& part : layer.mask) {
            if (random.coin()) part.def.blend = TXC_BLEND_ERASE;
        }
    }
    return layer;
}

/// Makes the layers, and notes their handles.
inline void make_layers(TestSession& session, TxcTarget target, std::vector<TreeLayer>& layers, TxcLayer parent = 0,
                        std::uint32_t role = TXC_ROLE_CONTENT) {
    for (TreeLayer& layer : layers) {
        layer.def.parent = parent;
        layer.def.role = role;
        if (layer.def.kind == TXC_LAYER_DECAL && layer.def.image == 0) layer.def.image = session.image(layer.picture);
        layer.handle = session.layer(target, layer.def);
        make_layers(session, target, layer.mask, layer.handle, TXC_ROLE_MASK);
        make_layers(session, target, layer.content, layer.handle);
    }
}

}  // namespace support
