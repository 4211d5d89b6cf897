// How one layer's texel goes onto what lies below it: W3C Compositing and Blending Level 1, sections 5 and 10 (spec
// section 6).
//
// A backdrop is straight colour and alpha, all on 0 to 255, kept in float through all layers of a texel: it is rounded
// once, at the end, so the order of edits and the number of layers leave no trace. A source has its opacity applied; its
// colour is premultiplied, on 0 to 255, its alpha on 0 to 1 and above 0. Full alpha is 1 to the last bit, so what a
// solid source covers leaves no trace either.
#pragma once

#include "float4.h"
#include "srgb_curve.h"

namespace txc {

/// Source over.
inline void blend_normal(Float4 source, bool lock_alpha, Float4& backdrop) {
    const Float4 keep = splat(1.0f - source[3]);
    const float alpha = backdrop[3];
    if (lock_alpha || alpha == 255.0f) {  // source atop, which is the same over what is opaque
        if (!(alpha > 0.0f)) return;
        backdrop = backdrop * keep + source;
        backdrop[3] = alpha;
        return;
    }
    const float below = alpha * keep[3];
    const float total = source[3] * 255.0f + below;
    backdrop = (source * splat(255.0f) + backdrop * splat(below)) / splat(total);
    backdrop[3] = total;
}

/// Destination out: alpha goes, colour stays.
inline void blend_erase(Float4 source, bool lock_alpha, Float4& backdrop) {
    if (!lock_alpha) backdrop[3] *= 1.0f - source[3];
}

/// Source over with one of blend_modes.h, in sRGB or in linear light. As the standard has it, the source is mixed with
/// the backdrop only as far as there is one: (1 - backdrop alpha) * source + backdrop alpha * B(backdrop, source).
template <typename Mode, bool kLinear>
inline void blend_mixed(Float4 source, bool lock_alpha, Float4& backdrop) {
    const float alpha = backdrop[3];
    if (lock_alpha && !(alpha > 0.0f)) return;
    const float source_alpha = source[3];
    // Other layers' rounding may have left a little more than white, or less than black.
    Float4 below = greater(lesser(backdrop * splat(1.0f / 255.0f), splat(1.0f)), splat(0.0f));
    Float4 above = lesser(source * splat(1.0f / (source_alpha * 255.0f)), splat(1.0f));
    if constexpr (kLinear) {
        below = srgb_to_linear(below);
        above = srgb_to_linear(above);
    }
    const Float4 mixed = Mode::mix(below, above);
    float total = alpha;
    if (alpha == 255.0f) {
        below = below + (mixed - below) * splat(source_alpha);
    } else {
        const float unit_alpha = alpha * (1.0f / 255.0f);
        const Float4 blended = above + (mixed - above) * splat(unit_alpha);
        float share = source_alpha;  // of the source in what comes out: all of it, or its part of the alpha
        if (!lock_alpha) {
            const float unit_total = source_alpha + unit_alpha * (1.0f - source_alpha);
            share = source_alpha / unit_total;
            total = unit_total * 255.0f;
        }
        below = below + (blended - below) * splat(share);
    }
    if constexpr (kLinear) below = linear_to_srgb(below);
    backdrop = below * splat(255.0f);
    backdrop[3] = total;
}

}  // namespace txc
