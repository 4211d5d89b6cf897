// W3C Compositing and Blending Level 1 in double precision, formula by formula as the standard prints them, sharing no
// code with the core: what a layer's texel makes of the texel below.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "picture.h"
#include "texelcast.h"

namespace support {

/// Straight colour and alpha, 0 to 1.
struct Pixel {
    double color[3];
    double alpha;
};

inline Pixel to_pixel(Color c) { return {{c.red / 255.0, c.green / 255.0, c.blue / 255.0}, c.alpha / 255.0}; }

inline double decode_srgb(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
inline double encode_srgb(double value) {
    return value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

/// Section 9.1: one channel of backdrop and source.
inline double blend_channel(std::uint32_t mode, double cb, double cs) {
    switch (mode) {
        case TXC_BLEND_MULTIPLY:
            return cb * cs;
        case TXC_BLEND_SCREEN:
            return 1 - (1 - cb) * (1 - cs);
        case TXC_BLEND_OVERLAY:
            return blend_channel(TXC_BLEND_HARD_LIGHT, cs, cb);
        case TXC_BLEND_DARKEN:
            return std::min(cb, cs);
        case TXC_BLEND_LIGHTEN:
            return std::max(cb, cs);
        case TXC_BLEND_COLOR_DODGE:
            if (cb == 0) return 0;
            return cs == 1 ? 1 : std::min(1.0, cb / (1 - cs));
        case TXC_BLEND_COLOR_BURN:
            if (cb == 1) return 1;
            return cs == 0 ? 0 : 1 - std::min(1.0, (1 - cb) / cs);
        case TXC_BLEND_HARD_LIGHT:
            return cs <= 0.5 ? cb * 2 * cs : blend_channel(TXC_BLEND_SCREEN, cb, 2 * cs - 1);
        case TXC_BLEND_SOFT_LIGHT: {
            if (cs <= 0.5) return cb - (1 - 2 * cs) * cb * (1 - cb);
            const double d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : std::sqrt(cb);
            return cb + (2 * cs - 1) * (d - cb);
        }
        case TXC_BLEND_DIFFERENCE:
            return std::fabs(cb - cs);
        case TXC_BLEND_EXCLUSION:
            return cb + cs - 2 * cb * cs;
        default:
            return cs;
    }
}

// Section 9.2.
inline double lum(const double (&c)[3]) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; }
inline double sat(const double (&c)[3]) { return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}); }

inline void set_lum(double (&c)[3], double l) {
    const double d = l - lum(c);
    for (double& channel : c) channel += d;
    const double grey = lum(c);
    const double n = std::min({c[0], c[1], c[2]});
    const double x = std::max({c[0], c[1], c[2]});
    for (double& channel : c) {
        if (n < 0) channel = grey + (channel - grey) * grey / (grey - n);
        if (x > 1) channel = grey + (channel - grey) * (1 - grey) / (x - grey);
    }
}

inline void set_sat(double (&c)[3], double s) {
    int least = 0;
    int most = 0;
    for (int i = 1; i < 3; ++i) {
        if (c[i] < c[least]) least = i;
        if (c[i] >= c[most]) most = i;
    }
    if (!(c[most] > c[least])) {
        c[0] = c[1] = c[2] = 0;
        return;
    }
    const int middle = 3 - least - most;
    c[middle] = (c[middle] - c[least]) * s / (c[most] - c[least]);
    c[most] = s;
    c[least] = 0;
}

/// B(Cb, Cs) of a whole colour; straight, 0 to 1.
inline void blend_color(std::uint32_t mode, const double (&cb)[3], const double (&cs)[3], double (&out)[3]) {
    const bool from_source = mode == TXC_BLEND_HUE || mode == TXC_BLEND_COLOR;
    if (mode < TXC_BLEND_HUE || mode > TXC_BLEND_LUMINOSITY) {
        for (int c = 0; c < 3; ++c) out[c] = blend_channel(mode, cb[c], cs[c]);
        return;
    }
    std::copy(from_source ? cs : cb, (from_source ? cs : cb) + 3, out);
    if (mode == TXC_BLEND_HUE) set_sat(out, sat(cb));
    if (mode == TXC_BLEND_SATURATION) set_sat(out, sat(cs));
    set_lum(out, lum(mode == TXC_BLEND_LUMINOSITY ? cs : cb));
}

/// Sections 5 and 10: the source blended with the backdrop, then Porter and Duff's source over (with lock_alpha source
/// atop), or for erase destination out.
inline Pixel composite(const TxcLayerDef& def, const Pixel& backdrop, Pixel source) {
    source.alpha *= static_cast<double>(def.opacity);
    const double kept = 1 - source.alpha;
    Pixel out = backdrop;
    if (def.blend == TXC_BLEND_ERASE) {
        if (def.lock_alpha == 0) out.alpha = backdrop.alpha * kept;
        return out;
    }
    out.alpha = def.lock_alpha != 0 ? backdrop.alpha : source.alpha + backdrop.alpha * kept;
    if (out.alpha == 0 || source.alpha == 0) return backdrop;
    const bool linear = def.blend_space == TXC_BLEND_SPACE_LINEAR;
    double cb[3];
    double cs[3];
    double mixed[3];
    for (int c = 0; c < 3; ++c) {
        cb[c] = linear ? decode_srgb(backdrop.color[c]) : backdrop.color[c];
        cs[c] = linear ? decode_srgb(source.color[c]) : source.color[c];
    }
    blend_color(def.blend, cb, cs, mixed);
    const double source_factor = def.lock_alpha != 0 ? backdrop.alpha : 1;
    for (int c = 0; c < 3; ++c) {
        const double blended = (1 - backdrop.alpha) * cs[c] + backdrop.alpha * mixed[c];
        const double premultiplied = source.alpha * source_factor * blended + backdrop.alpha * cb[c] * kept;
        const double straight = premultiplied / out.alpha;
        out.color[c] = linear ? encode_srgb(straight) : straight;
    }
    return out;
}

}  // namespace support
