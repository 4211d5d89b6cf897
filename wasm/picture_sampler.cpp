#include "picture_sampler.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

// Footprints many times the picture's size take next to no colour, and make_footprint counts their samples in integers.
constexpr float kLongestSide = 64.0f;
constexpr int kRingSamples = 8;  // along one axis, as the reference has

/// Shortens a side to `longest`; false where it is no number.
bool cut(float& x, float& y, float longest) {
    const float length = std::max(std::fabs(x), std::fabs(y));
    if (!(length <= 3e38f)) return false;
    if (length > longest) {
        x *= longest / length;
        y *= longest / length;
    }
    return true;
}

}  // namespace

PictureSampler::PictureSampler(const ImagePyramid& image, const PictureSettings& settings)
    : image_(image),
      settings_(settings),
      width_(static_cast<float>(image.levels[0].width)),
      height_(static_cast<float>(image.levels[0].height)),
      // Left to right is x from -1/2 to 1/2; bottom to top is y, and picture rows run down (spec section 1).
      scale_x_(static_cast<double>(settings.flip_x ? -width_ : width_)),
      scale_y_(static_cast<double>(settings.flip_y ? height_ : -height_)),
      period_(static_cast<float>(settings.period * image.levels[0].width)),
      longest_(kLongestSide * std::max(width_, height_)),
      fade_(settings.repeat ? 0.0f : 0.5f) {}

Float4 PictureSampler::in_pixels(double x, double y, double origin) const {
    return Float4{static_cast<float>(x * scale_x_ + origin * static_cast<double>(width_)),
                  static_cast<float>(y * scale_y_ + origin * static_cast<double>(height_)), 0.0f, 0.0f};
}

bool PictureSampler::aim(const PictureSight& sight) {
    const Float4 place = in_pixels(sight.x, sight.y, 0.5);
    x_ = place[0];
    y_ = place[1];
    if (settings_.nearest) return x_ >= 0.0f && x_ <= width_ && y_ >= 0.0f && y_ <= height_;
    float across_x = static_cast<float>(sight.across_x * scale_x_);
    float across_y = static_cast<float>(sight.across_y * scale_y_);
    float down_x = static_cast<float>(sight.down_x * scale_x_);
    float down_y = static_cast<float>(sight.down_y * scale_y_);
    if (!cut(across_x, across_y, longest_) || !cut(down_x, down_y, longest_)) return false;
    if (period_ > 0.0f) {
        // Beside the axis a texel would see more than the whole way round.
        const float span = std::fabs(across_x) + std::fabs(down_x);
        if (span > period_) {
            across_x *= period_ / span;
            down_x *= period_ / span;
        }
    }
    margin_x_ = 0.5f * (std::fabs(across_x) + std::fabs(down_x)) + fade_;
    const float margin_y = 0.5f * (std::fabs(across_y) + std::fabs(down_y)) + fade_;
    if (!(y_ >= -margin_y && y_ <= height_ + margin_y)) return false;
    if (!meets(x_) && !(period_ > 0.0f && (meets(x_ - period_) || meets(x_ + period_)))) return false;
    if (across_x != across_x_ || across_y != across_y_ || down_x != down_x_ || down_y != down_y_) {
        has_footprint_ = false;
        across_x_ = across_x;
        across_y_ = across_y;
        down_x_ = down_x;
        down_y_ = down_y;
    }
    return true;
}

Float4 PictureSampler::sample() {
    if (settings_.nearest) return sample_nearest(image_.levels[0], x_, y_);
    if (!has_footprint_) make_footprint(image_, across_x_, across_y_, down_x_, down_y_, settings_.repeat, footprint_);
    has_footprint_ = true;
    const Footprint& f = footprint_;
    // Where the picture comes round again, what it is padded with is not what lies beside it.
    const float inset_x = period_ > 0.0f ? std::max(f.inset_x, f.reach_x + 0.51f) : f.inset_x;
    if (x_ >= inset_x && x_ <= width_ - inset_x && y_ >= f.inset_y && y_ <= height_ - f.inset_y)
        return sample_inside(image_, f, x_, y_);
    if (!(period_ > 0.0f)) return sample_edge(image_, f, x_, y_, settings_.repeat);
    if (settings_.repeat && settings_.period == 1.0) return sample_ring();
    // A footprint at the back sees the picture's end, its beginning, or both: what lies between is transparent. Where
    // the picture closes, the half pixels over which both fade lie on each other and add up to the whole.
    Float4 sum = splat(0.0f);
    for (const float x : {x_ - period_, x_, x_ + period_}) {
        if (meets(x)) sum += sample_edge(image_, f, x, y_, settings_.repeat);
    }
    return lesser(sum, splat(kFullScale));
}

/// A repeated picture is cut by its rectangle sample by sample, so two copies laid side by side could both miss a sample
/// that lies upon the line between them. Where the picture closes there is no such line.
Float4 PictureSampler::sample_ring() const {
    const PyramidLevel& level = image_.levels[footprint_.edge_level];
    Float4 sum = splat(0.0f);
    for (int j = 0; j < kRingSamples; ++j) {
        const float v = (static_cast<float>(j) + 0.5f) / kRingSamples - 0.5f;
        for (int i = 0; i < kRingSamples; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / kRingSamples - 0.5f;
            const float y = y_ + (across_y_ * u + down_y_ * v);
            if (y < 0.0f || y > height_) continue;
            const float x = x_ + (across_x_ * u + down_x_ * v);
            sum += sample_bilinear(level, x * level.scale_x, y * level.scale_y, true);
        }
    }
    return sum * splat(1.0f / (kRingSamples * kRingSamples));
}

}  // namespace txc
