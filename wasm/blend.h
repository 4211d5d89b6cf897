// How one layer's texel goes onto what lies below it: W3C Compositing and Blending Level 1, section 5 (spec section 6).
#pragma once

namespace txc {

/// Straight colour and alpha, all on 0 to 255, kept in float through all layers of a texel: it is rounded once, at the
/// end, so the order of edits and the number of layers leave no trace.
struct Backdrop {
    float color[3];
    float alpha;
};

/// Source over. `source`: premultiplied colour and alpha, 0 to 255, opacity applied.
inline void blend_normal(const float source[4], Backdrop& backdrop) {
    const float keep = 1.0f - source[3] * (1.0f / 255.0f);
    if (backdrop.alpha == 255.0f) {
        for (int c = 0; c < 3; ++c) backdrop.color[c] = backdrop.color[c] * keep + source[c];
        return;
    }
    const float below = backdrop.alpha * keep;
    const float alpha = source[3] + below;
    if (!(alpha > 0.0f)) return;  // colour under zero alpha is kept
    for (int c = 0; c < 3; ++c) backdrop.color[c] = (source[c] * 255.0f + backdrop.color[c] * below) / alpha;
    backdrop.alpha = alpha;
}

/// Source atop: the backdrop's alpha stays as it was.
inline void blend_locked(const float source[4], Backdrop& backdrop) {
    if (!(backdrop.alpha > 0.0f)) return;
    const float keep = 1.0f - source[3] * (1.0f / 255.0f);
    for (int c = 0; c < 3; ++c) backdrop.color[c] = backdrop.color[c] * keep + source[c];
}

}  // namespace txc
