// A texel's footprint in the decal's picture, and its mean colour (spec section 5). The footprint is the texel's square
// under the frame's affine map: a parallelogram, the same for every texel of a frame.
#pragma once

#include "bilinear.h"
#include "footprint_kernel.h"
#include "image_pyramid.h"

namespace txc {

/// More parts than these cost more than a lattice does.
inline constexpr std::int32_t kMostParts = 16;

/// The least and the greatest of some texels' places, in fixed point on a level: x and y of the one, then of the other.
using PlaceBounds = Int4;

/// Where colours may be interpolated between the corners of squares of texels: where the level is no rougher than `limit` (-1:
/// nowhere) over the rectangle that their footprints span. Four windows that meet or overlap make up the rectangle.
struct SmoothTest {
    const std::uint8_t* list = nullptr;  // as of the level's first pixel
    std::int32_t limit = -1;
    std::int32_t window = 0;
    PlaceBounds to_windows{};  // to the outermost windows' places, in fixed point
    Int4 last_window{};        // the last there are, pixels

    /// `bounds`: of the centres of the squares' corners.
    bool is_smooth(PlaceBounds bounds, std::int32_t stride) const {
        const Int4 at = lesser((bounds + to_windows) >> kWeightBits, last_window);
        const std::int32_t left = at[0];
        const std::int32_t top = at[1];
        const std::int32_t right = std::max(at[2] - left, 0);
        const std::int32_t down = std::max(at[3] - top, 0);
        if (right > window || down > window) return false;
        const std::uint8_t* upper = list + (top * stride + left);
        const std::uint8_t* lower = upper + down * stride;
        return std::max(std::max(upper[0], upper[right]), std::max(lower[0], lower[right])) <= limit;
    }
};

/// Samples that stand evenly over a footprint. Lengths in fixed point on its level.
struct SampleLattice {
    std::int32_t across_samples;
    std::int32_t down_samples;
    Int4 x, y;  // from the centre to four neighbouring samples: as many of a row as it has, then down
    std::int32_t across_step_x, across_step_y;
    std::int32_t down_step_x, down_step_y;
};

/// How a frame's texels sample a picture. Lengths in pixels of the picture unless said.
struct Footprint {
    float across_x, across_y;  // along the texel's row
    float down_x, down_y;      // along the texel's column
    float reach_x, reach_y;    // half of its bounding box

    // Footprints well inside the picture. Where the level is no rougher than smooth_limit (-1: never) by smooth_list, one sample
    // is the mean.
    std::uint32_t level;
    bool smooth_by_bends;             // which of the level's lists it is
    const std::uint8_t* smooth_list;  // as of the level's first pixel
    std::int32_t smooth_limit;
    // Twice the distance, in fixed point, that a centre may be from the middle between two pixels' so that the footprint lies
    // between them (negative: it is too wide). There the picture does not bend, and up to twist_limit one sample is the mean.
    std::int32_t room_x, room_y;
    std::int32_t twist_limit;
    float inset_x, inset_y;  // a centre this far from the picture's edges is well inside
    // Else, of small ones: up to kMostParts parts (0: there are none), each with its mean by the kernel, and where they
    // lie from the centre, in fixed point on the level.
    std::int32_t parts;
    std::int32_t part_x[kMostParts], part_y[kMostParts];
    FootprintKernel kernel;
    SampleLattice lattice;  // of the others
    // Large ones are done with fewer samples where the level is no rougher than calm_limit (-1: nowhere) by calm_list.
    std::int32_t calm_limit;
    const std::uint8_t* calm_list;  // as of the level's first pixel
    SampleLattice calm_lattice;

    // Footprints that the picture's edge cuts.
    std::uint32_t edge_level;
    std::int32_t edge_across_samples;
    std::int32_t edge_down_samples;
};

/// Written where it is to stay: copies of it are 2 to 4 % of a drag on a fine mesh.
void make_footprint(const ImagePyramid& image, float across_x, float across_y, float down_x, float down_y, bool repeat,
                    Footprint& out);
inline Footprint make_footprint(const ImagePyramid& image, float across_x, float across_y, float down_x, float down_y,
                                bool repeat) {
    Footprint made;
    make_footprint(image, across_x, across_y, down_x, down_y, repeat, made);
    return made;
}

/// Where the footprint's level is no rougher than this by its list, the colours between samples of every `texels`-th texel of a
/// row are as good as interpolated. Never above smooth_limit.
std::int32_t chord_limit(const ImagePyramid& image, const Footprint& footprint, float texels);

/// Where colours of a tile's texels may be interpolated.
struct ChordLimits {
    std::int32_t three = -1;  // along its rows over three texels: the largest roughness at all four
    SmoothTest block;         // over three by three
    SmoothTest tile;          // over five by five, throughout the tile
};
ChordLimits tile_chord_limits(const ImagePyramid& image, const Footprint& footprint);

/// A texel whose footprint one sample does not stand for.
struct RoughTexel {
    const PyramidLevel* level;  // the footprint's
    const Footprint* footprint;
    std::int32_t x, y;  // the footprint's centre, in pixels of the level, less 1/2, times kWeightOne
    std::uint16_t* out;
};

/// Paints texels by their kernels or lattices, many in one call.
void paint_rough(const RoughTexel* texels, std::uint32_t count);

/// At which of four centres (as of RoughTexel), whose roughness is `steps`, one sample is further than allowed from the mean:
/// -1, else 0.
///
/// (Each pixel's largest second differences along x and y, kept apart, with the place between the kinks told more closely. It
/// spared more texels their kernels, but to ask cost as much as the kernels spared: a drag without it takes 0.93 to 1.0 of the
/// time from half a pixel a texel on, and pictures take two bytes a pixel less.)
inline Int4 are_rough(const Footprint& f, Int4 steps, Int4 x, Int4 y) {
    const auto crosses = [](Int4 place, std::int32_t room) {
        const Int4 twice = ((place & (kWeightOne - 1)) << 1) - kWeightOne;
        return greater(twice, -twice) > splat(room);
    };
    return (steps > splat(f.smooth_limit)) &
           (crosses(x, f.room_x) | crosses(y, f.room_y) | (steps > splat(f.twist_limit)));
}

/// Mean colour over the footprint centred on (x, y), which lies well inside the picture (inset_x, inset_y).
Float4 sample_inside(const ImagePyramid& image, const Footprint& footprint, float x, float y);

/// The same where the footprint reaches the picture's edge, over which the picture fades into transparency. With
/// `repeat` the picture goes on and its rectangle cuts it: samples outside count as transparent.
Float4 sample_edge(const ImagePyramid& image, const Footprint& footprint, float x, float y, bool repeat);

}  // namespace txc
