// The blend functions B(Cb, Cs) of W3C Compositing and Blending Level 1, sections 9.1 and 9.2.
//
// Backdrop and source are straight colours from 0 to 1; the fourth lane means nothing, in or out.
#pragma once

#include <algorithm>

#include "float4.h"

namespace txc {

// ---- Separable modes --------------------------------------------------------------------------------------------------

struct NormalMode {
    static Float4 mix(Float4, Float4 source) { return source; }
};

struct MultiplyMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return backdrop * source; }
};

struct ScreenMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return backdrop + source - backdrop * source; }
};

struct HardLightMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        const Float4 twice = source + source;
        return select(source <= splat(0.5f), MultiplyMode::mix(backdrop, twice),
                      ScreenMode::mix(backdrop, twice - splat(1.0f)));
    }
};

struct OverlayMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return HardLightMode::mix(source, backdrop); }
};

struct DarkenMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return lesser(backdrop, source); }
};

struct LightenMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return greater(backdrop, source); }
};

/// Dodge jumps from 0 to 1 where a black backdrop meets a white source, burn where a white one meets black. A backdrop
/// nearer to its end than this is at it: other layers' rounding may not decide.
inline constexpr float kCliff = 1.0f / 65536;

struct ColorDodgeMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        const Float4 rest = greater(splat(1.0f) - source, splat(kCliff * kCliff));
        return select(backdrop <= splat(kCliff), splat(0.0f), lesser(backdrop / rest, splat(1.0f)));
    }
};

struct ColorBurnMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        const Float4 missing = splat(1.0f) - backdrop;
        const Float4 burnt = lesser(missing / greater(source, splat(kCliff * kCliff)), splat(1.0f));
        return select(missing <= splat(kCliff), splat(1.0f), splat(1.0f) - burnt);
    }
};

struct SoftLightMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        const Float4 dark = ((splat(16.0f) * backdrop - splat(12.0f)) * backdrop + splat(4.0f)) * backdrop;
        const Float4 lit = select(backdrop <= splat(0.25f), dark, square_root(backdrop));
        const Float4 reach = select(source <= splat(0.5f), backdrop - backdrop * backdrop, lit - backdrop);
        return backdrop + (source + source - splat(1.0f)) * reach;
    }
};

struct DifferenceMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return absolute(backdrop - source); }
};

struct ExclusionMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        const Float4 product = backdrop * source;
        return backdrop + source - (product + product);
    }
};

// ---- Non-separable modes ----------------------------------------------------------------------------------------------

inline float luminosity_of(Float4 c) { return 0.3f * c[0] + 0.59f * c[1] + 0.11f * c[2]; }
inline float least_of(Float4 c) { return std::min(c[0], std::min(c[1], c[2])); }
inline float most_of(Float4 c) { return std::max(c[0], std::max(c[1], c[2])); }
inline float saturation_of(Float4 c) { return most_of(c) - least_of(c); }

/// W3C's SetLum with its ClipColor: the colour moved to a luminosity, then drawn towards grey until it is a colour.
inline Float4 with_luminosity(Float4 c, float luminosity) {
    c = c + splat(luminosity - luminosity_of(c));
    const float grey = luminosity_of(c);
    const float least = least_of(c);
    const float most = most_of(c);
    // The second comparisons keep a colour that is grey but for rounding from 0 / 0.
    if (least < 0.0f && least < grey) c = splat(grey) + (c - splat(grey)) * splat(grey / (grey - least));
    if (most > 1.0f && most > grey) c = splat(grey) + (c - splat(grey)) * splat((1.0f - grey) / (most - grey));
    return c;
}

/// W3C's SetSat: least to 0, most to the saturation, the middle in proportion.
inline Float4 with_saturation(Float4 c, float saturation) {
    const float range = saturation_of(c);
    if (!(range > 0.0f)) return splat(0.0f);
    return (c - splat(least_of(c))) * splat(saturation / range);
}

struct HueMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        return with_luminosity(with_saturation(source, saturation_of(backdrop)), luminosity_of(backdrop));
    }
};

struct SaturationMode {
    static Float4 mix(Float4 backdrop, Float4 source) {
        return with_luminosity(with_saturation(backdrop, saturation_of(source)), luminosity_of(backdrop));
    }
};

struct ColorMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return with_luminosity(source, luminosity_of(backdrop)); }
};

struct LuminosityMode {
    static Float4 mix(Float4 backdrop, Float4 source) { return with_luminosity(backdrop, luminosity_of(source)); }
};

}  // namespace txc
