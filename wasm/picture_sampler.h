// The colour that a texel takes from a decal's picture, where each texel has a footprint of its own (spec section 5):
// footprint.h's sampling, and a picture that goes round a cylinder and meets itself.
#pragma once

#include "footprint.h"
#include "projector_pose.h"
#include "texel_sight.h"

namespace txc {

/// How a decal's picture is read.
struct PictureSettings {
    bool nearest = false;
    bool repeat = false;
    bool flip_x = false;
    bool flip_y = false;
    // Decal widths after which the picture comes round again; 1 where it closes on itself, 0 where it never does.
    double period = 0.0;
};

class PictureSampler {
public:
    PictureSampler(const ImagePyramid& image, const PictureSettings& settings);

    /// Turns to a texel. False where its footprint lies beside the picture (test 1 of spec section 4, on x and y).
    bool aim(const PictureSight& sight);

    /// Mean colour over the footprint of the texel aimed at; premultiplied, on the scale of kFullScale.
    Float4 sample();

    /// A vector of decal space in pixels of the picture, from `origin` as a share of its width and height: 0, or of a point 0.5, from its
    /// left and top edges. The other lanes are 0.
    Float4 in_pixels(double x, double y, double origin) const;
    /// Whether the picture has another one beside it.
    bool comes_round() const { return period_ > 0.0f; }

private:
    bool meets(float x) const { return x >= -margin_x_ && x <= width_ + margin_x_; }
    Float4 sample_ring() const;

    const ImagePyramid& image_;
    PictureSettings settings_;
    float width_;  // pixels
    float height_;
    double scale_x_;  // from decal space
    double scale_y_;
    float period_;    // pixels
    float longest_;   // a footprint's side is cut to this, pixels
    float fade_;      // on either side of the picture's edge, pixels
    float x_ = 0.0f;  // the centre, pixels from the picture's left and top edges
    float y_ = 0.0f;
    float across_x_ = 0.0f, across_y_ = 0.0f, down_x_ = 0.0f, down_y_ = 0.0f;  // the footprint's sides, pixels
    float margin_x_ = 0.0f;
    Footprint footprint_{};  // of the newest texel sampled: neighbours often share it
    bool has_footprint_ = false;
};

}  // namespace txc
