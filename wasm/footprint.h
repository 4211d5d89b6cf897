// A texel's footprint in the decal's picture, and its mean colour (spec section 5). The footprint is the texel's square
// under the frame's affine map: a parallelogram, the same for every texel of a frame.
#pragma once

#include "image_pyramid.h"

namespace txc {

/// How a frame's texels sample a picture. Lengths in pixels of the picture.
struct Footprint {
    float across_x, across_y;  // along the texel's row
    float down_x, down_y;      // along the texel's column
    float reach_x, reach_y;    // half of its bounding box
    std::uint32_t level;       // of the pyramid, for footprints inside the picture
    int across_samples;
    int down_samples;
    std::uint32_t edge_level;  // for footprints that the picture's edge cuts: kEdgeSamples each way
};

Footprint make_footprint(const ImagePyramid& image, float across_x, float across_y, float down_x, float down_y);

/// Mean colour over the footprint centred on (x, y), where all of it lies inside the picture.
PyramidColor sample_inside(const ImagePyramid& image, const Footprint& footprint, float x, float y, bool repeat);

/// The same where the footprint reaches the picture's edge, over which the picture fades into transparency. With
/// `repeat` the picture goes on and its rectangle cuts it: samples outside count as transparent.
PyramidColor sample_edge(const ImagePyramid& image, const Footprint& footprint, float x, float y, bool repeat);

}  // namespace txc
