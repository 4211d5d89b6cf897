// A slow painter in double precision, written from spec.md sections 3 to 6 and sharing no code with the core: 8 x 8
// bilinear samples over every texel's footprint, source over in sRGB. Occlusion is left out: it has claims of its own.
#pragma once

#include <cmath>
#include <vector>

#include "picture.h"
#include "reference_map.h"
#include "reference_projector.h"
#include "texelcast.h"

namespace support {

class ReferencePainter {
public:
    ReferencePainter(const ReferenceMap& map, Color base) : map_(map) {
        for (std::size_t t = 0; t < static_cast<std::size_t>(map.width) * map.height; ++t) {
            texels_.push_back({{base.red / 255.0, base.green / 255.0, base.blue / 255.0}, base.alpha / 255.0});
            sure_.push_back(true);
        }
        for (std::uint32_t y = 0; y < map.height; ++y) {
            for (std::uint32_t x = 0; x < map.width; ++x) {
                const ReferenceTexel& texel = map.at(x, y);
                // Empty texels may be gutter; shared ones hang on the top-left rule.
                sure_[y * map.width + x] = texel.triangle >= 0 && texel.sure;
            }
        }
    }

    void paint(const TxcLayerDef& def, const Picture& picture) {
        for (std::uint32_t y = 0; y < map_.height; ++y) {
            for (std::uint32_t x = 0; x < map_.width; ++x) {
                if (map_.at(x, y).triangle >= 0) paint_texel(def, picture, x, y);
            }
        }
    }

    Picture result() const {
        Picture picture(map_.width, map_.height);
        for (std::uint32_t y = 0; y < map_.height; ++y) {
            for (std::uint32_t x = 0; x < map_.width; ++x) {
                const Texel& texel = texels_[y * map_.width + x];
                picture.set(
                    x, y,
                    {to_byte(texel.color[0]), to_byte(texel.color[1]), to_byte(texel.color[2]), to_byte(texel.alpha)});
            }
        }
        return picture;
    }

    bool is_sure(std::uint32_t x, std::uint32_t y) const { return sure_[y * map_.width + x]; }

private:
    struct Texel {
        double color[3];  // straight, 0 to 1
        double alpha;
    };
    struct Sample {
        double color[3] = {0, 0, 0};  // premultiplied, 0 to 1
        double alpha = 0;
    };

    static std::uint8_t to_byte(double value) {
        return static_cast<std::uint8_t>(std::floor(std::fmin(std::fmax(value, 0.0), 1.0) * 255.0 + 0.5));
    }

    static Sample pixel(const Picture& picture, std::int64_t x, std::int64_t y, bool repeat) {
        const std::int64_t w = picture.width;
        const std::int64_t h = picture.height;
        if (repeat) {
            x = (x % w + w) % w;
            y = (y % h + h) % h;
        }
        if (x < 0 || y < 0 || x >= w || y >= h) return {};
        const Color c = picture.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        const double alpha = c.alpha / 255.0;
        return {{c.red / 255.0 * alpha, c.green / 255.0 * alpha, c.blue / 255.0 * alpha}, alpha};
    }
    static void add(Sample& sum, const Sample& sample, double weight) {
        for (int c = 0; c < 3; ++c) sum.color[c] += sample.color[c] * weight;
        sum.alpha += sample.alpha * weight;
    }
    /// x, y in pixels, 0 at the picture's left and top edges.
    static Sample bilinear(const Picture& picture, double x, double y, bool repeat) {
        const double left = std::floor(x - 0.5);
        const double top = std::floor(y - 0.5);
        const double fx = x - 0.5 - left;
        const double fy = y - 0.5 - top;
        Sample sum;
        for (int j = 0; j < 2; ++j) {
            for (int i = 0; i < 2; ++i) {
                add(sum,
                    pixel(picture, static_cast<std::int64_t>(left) + i, static_cast<std::int64_t>(top) + j, repeat),
                    (i == 0 ? 1.0 - fx : fx) * (j == 0 ? 1.0 - fy : fy));
            }
        }
        return sum;
    }

    /// The picture at a point of the decal. One that goes round a cylinder is met from both its ends; where it closes
    /// and repeats it has no end.
    static Sample decal_at(const TxcLayerDef& def, const Picture& picture, double x, double y) {
        const bool repeat = def.wrap == TXC_WRAP_REPEAT;
        const double period = period_of(def);
        const bool endless = repeat && period == 1.0;
        Sample sum;
        for (int turn = period > 0.0 && !endless ? -1 : 0; turn <= (period > 0.0 && !endless ? 1 : 0); ++turn) {
            const double at = x + turn * period;
            if (repeat && ((!endless && std::fabs(at) > 0.5) || std::fabs(y) > 0.5)) continue;
            add(sum, bilinear(picture, in_pixels_x(def, picture, at), in_pixels_y(def, picture, y), repeat), 1.0);
        }
        return sum;
    }

    void paint_texel(const TxcLayerDef& def, const Picture& picture, std::uint32_t x, std::uint32_t y) {
        const ReferenceTexel& owner = map_.at(x, y);
        const auto look_from = [&](double right, double down) {
            const double du = right / map_.width;
            const double dv = down / map_.height;
            return look(def, map_.position(owner.triangle, owner.u + du, owner.v + dv), (x + 0.5 + right) / map_.width,
                        (y + 0.5 + down) / map_.height);
        };
        const ReferenceSight centre = look_from(0, 0);
        std::vector<bool>::reference sure = sure_[y * map_.width + x];
        if (std::fabs(centre.depth_slack) < 1e-5) sure = false;
        if (centre.depth_slack < 0.0) return;

        double weight = 1.0;
        if (def.projector != TXC_PROJECTOR_UV) {
            const double f_signed = dot(map_.normal(owner.triangle, owner.u, owner.v), centre.towards);
            const double f = def.backfaces != 0 ? std::fabs(f_signed) : f_signed;
            const double cos_start = std::cos(def.angle_fade_start * kPi / 180.0);
            const double cos_end = std::cos(def.angle_fade_end * kPi / 180.0);
            // Where the weight jumps, rounding decides.
            if (std::fabs(f) < 1e-5 || (cos_start - cos_end < 1e-5 && std::fabs(f - cos_start) < 1e-5)) sure = false;
            if (!(f > 0.0)) return;
            weight = f >= cos_start ? 1.0 : f <= cos_end ? 0.0 : (f - cos_end) / (cos_start - cos_end);
        }
        if (weight == 0.0) return;

        Sample mean;
        if (def.filter == TXC_FILTER_NEAREST) {
            const double px = in_pixels_x(def, picture, centre.x);
            const double py = in_pixels_y(def, picture, centre.y);
            if (std::fabs(px - std::floor(px + 0.5)) < 1e-3 || std::fabs(py - std::floor(py + 0.5)) < 1e-3)
                sure = false;
            if (std::fabs(centre.x) > 0.5 || std::fabs(centre.y) > 0.5) return;
            mean = pixel(picture, static_cast<std::int64_t>(px), static_cast<std::int64_t>(py), false);
        } else {
            for (int j = 0; j < 8; ++j) {
                for (int i = 0; i < 8; ++i) {
                    const ReferenceSight at = look_from((i + 0.5) / 8 - 0.5, (j + 0.5) / 8 - 0.5);
                    add(mean, decal_at(def, picture, at.x, at.y), 1.0 / 64);
                }
            }
        }
        blend(def, mean, weight * def.opacity, texels_[y * map_.width + x]);
    }

    static double in_pixels_x(const TxcLayerDef& def, const Picture& picture, double x) {
        return ((def.flip_x != 0 ? -x : x) + 0.5) * picture.width;
    }
    static double in_pixels_y(const TxcLayerDef& def, const Picture& picture, double y) {
        return (0.5 - (def.flip_y != 0 ? -y : y)) * picture.height;
    }

    /// W3C source over; with lock_alpha source atop.
    static void blend(const TxcLayerDef& def, const Sample& mean, double scale, Texel& below) {
        const double alpha = mean.alpha * scale;
        if (def.lock_alpha != 0) {
            if (below.alpha > 0.0) {
                for (int c = 0; c < 3; ++c) below.color[c] = mean.color[c] * scale + below.color[c] * (1.0 - alpha);
            }
            return;
        }
        const double total = alpha + below.alpha * (1.0 - alpha);
        if (total <= 0.0) return;
        for (int c = 0; c < 3; ++c) {
            below.color[c] = (mean.color[c] * scale + below.color[c] * below.alpha * (1.0 - alpha)) / total;
        }
        below.alpha = total;
    }

    const ReferenceMap& map_;
    std::vector<Texel> texels_;
    std::vector<bool> sure_;
};

struct Closeness {
    double decibel = 0;  // over red, green and blue of the compared texels; 200 where they are equal
    std::uint32_t compared = 0;
    int worst = 0;  // the largest difference of one channel
};

/// Over the sure texels that either picture paints on the base, as the reference pictures are compared.
inline Closeness compare(const ReferencePainter& reference, const Picture& actual, Color base) {
    const Picture expected = reference.result();
    Closeness closeness;
    double squares = 0;
    for (std::uint32_t y = 0; y < expected.height; ++y) {
        for (std::uint32_t x = 0; x < expected.width; ++x) {
            if (!reference.is_sure(x, y)) continue;
            const Color a = expected.at(x, y);
            const Color b = actual.at(x, y);
            if (a == base && b == base) continue;
            ++closeness.compared;
            for (const int difference : {a.red - b.red, a.green - b.green, a.blue - b.blue}) {
                squares += difference * difference;
                closeness.worst = std::max(closeness.worst, std::abs(difference));
            }
        }
    }
    const double mean = squares / std::max(1.0, 3.0 * closeness.compared);
    closeness.decibel = mean == 0.0 ? 200.0 : 10.0 * std::log10(255.0 * 255.0 / mean);
    return closeness;
}

}  // namespace support
