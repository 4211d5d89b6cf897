// How one layer's texel goes onto what lies below it: W3C Compositing and Blending Level 1, section 5 (spec section 6).
//
// A backdrop is straight colour and alpha, all on 0 to 255, kept in float through all layers of a texel: it is rounded
// once, at the end, so the order of edits and the number of layers leave no trace. A source is premultiplied, on the same
// scale, opacity applied.
#pragma once

#include "float4.h"

namespace txc {

/// Source over.
inline void blend_normal(Float4 source, Float4& backdrop) {
    const float keep = 1.0f - source[3] * (1.0f / 255.0f);
    if (backdrop[3] == 255.0f) {
        backdrop = backdrop * splat(keep) + source;
        backdrop[3] = 255.0f;
        return;
    }
    const float below = backdrop[3] * keep;
    const float alpha = source[3] + below;
    if (!(alpha > 0.0f)) return;  // colour under zero alpha is kept
    backdrop = (source * splat(255.0f) + backdrop * splat(below)) / splat(alpha);
    backdrop[3] = alpha;
}

/// Source atop: the backdrop's alpha stays as it was.
inline void blend_locked(Float4 source, Float4& backdrop) {
    if (!(backdrop[3] > 0.0f)) return;
    const float alpha = backdrop[3];
    backdrop = backdrop * splat(1.0f - source[3] * (1.0f / 255.0f)) + source;
    backdrop[3] = alpha;
}

}  // namespace txc
