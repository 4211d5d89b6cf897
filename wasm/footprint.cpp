#include "footprint.h"

#include <algorithm>
#include <cmath>

#include "bilinear.h"

namespace txc {
namespace {

constexpr int kEdgeSamples = 8;  // along one axis, as the reference has: edges are few, so they may cost
constexpr int kMaxSamples = 32;  // along one axis: grazing triangles stretch the footprint without end
// The shorter axis on the chosen level stays below this. Spec section 5 asks for 40 dB up to 8 x minification, and there a
// coarser level blurs too much for hard edges: a checker of 5 pixels at 6 x came to 34 dB where 5 was the limit. Up to it
// the samples are never denser than the reference's 8.
constexpr float kFinestPixels = 8.5f;

// How far one sample may be from the mean where a smooth stretch spares the others, in 8-bit steps. (With half a step a
// drag took an eighth longer, as the rounding of a smooth gradient to bytes comes to one and a half; with two or three it
// was no faster.)
constexpr float kSmoothError = 1.0f;

float length(float x, float y) { return std::sqrt(x * x + y * y); }

/// At least the mean distance of a parallelogram's points from its centre along one axis, on which its sides have these
/// lengths (exact where they are equal).
float mean_distance(float side, float other_side) {
    const float longer = std::max(std::fabs(side), std::fabs(other_side));
    const float shorter = std::min(std::fabs(side), std::fabs(other_side));
    return 0.25f * longer + shorter * (1.0f / 12.0f);
}

/// The same, where what lies beyond one pixel counts up to three times: so far away a second row of kinks comes in.
float mean_bend(float side, float other_side) {
    const float reach = 0.5f * (std::fabs(side) + std::fabs(other_side));
    const float distance = mean_distance(side, other_side);
    return reach > 1.0f ? distance * (1.0f + 2.0f * (reach - 1.0f) / reach) : distance;
}

/// The most that the mean over a footprint may be from the value at its centre, where no second difference of the level
/// exceeds 1. Sides in pixels of the level.
///
/// A bilinear picture bends only where it crosses pixel centres, along either axis, and is twisted in between. In the worst
/// alignment the footprint's centre lies on such a kink, and a point at the distance d from it is off by d / 2. The twist
/// adds the product of the distances along both axes, whose mean the second moments bound. (Linear programming over all
/// pictures, for 7500 footprints, found errors up to 0.999 of the tightest bound of this kind; this one spares roots and
/// divisions and is never below it.)
float largest_smooth_error(float across_x, float across_y, float down_x, float down_y) {
    const float squares_x = across_x * across_x + down_x * down_x;
    const float squares_y = across_y * across_y + down_y * down_y;
    return 0.5f * (mean_bend(across_x, down_x) + mean_bend(across_y, down_y)) +
           (squares_x + squares_y) * (1.0f / 24.0f);
}

// The same by the twist alone, where the footprint meets no kink.
//
// Bounds of 2 (smooth), 5 (by its very place), 2 (chord) and 4 (tile) steps keep 50 dB and more of what these give, on checkers of
// 3 and 5 pixels too, and a drag takes 0.92 to 0.97 of the time. But then a decal's quarters, each a picture of its own, no longer
// paint what the whole one paints, and a round tip differs by 2 steps from itself turned.
constexpr float kTwistError = 0.75f;

// How far a colour interpolated between two samples may be from its own, in 8-bit steps. Rows begin anywhere, so twice this
// is what two texels may differ by that should be alike.
constexpr float kChordError = 0.75f;

// The same along a tile's rows, whose chords begin at the same columns for every triangle. A bound for the worst of all
// pictures: one that bends by a step a pixel all along comes to a third of it. (With 4 a round tip differed by 2 steps from
// itself turned by a right angle.)
constexpr float kTileChordError = 2.0f;

/// The most that a straight line between two samples this far apart may be from the picture, where no second difference of
/// the level exceeds 1: along an axis the picture bends once a pixel, at the worst once half way.
float largest_chord_error(float x, float y) {
    const auto bend = [](float distance) { return 0.25f * distance * std::max(1.0f, 0.5f * distance + 0.25f); };
    const float along_x = std::fabs(x);
    const float along_y = std::fabs(y);
    return bend(along_x) + bend(along_y) + 0.25f * along_x * along_y;
}

// Where no bend exceeds 1 the picture curves by a quarter of a step a pixel at the most, all along: so much it is away from the
// mean over a square, and from a straight line, for each square pixel of the side.
constexpr float kBendMean = 0.25f / 24.0f;
constexpr float kBendChord = 0.25f / 8.0f;
// What interpolated colours may be away by it, in 8-bit steps. Of pictures that pass none comes near: rounding alone makes bends of
// 1, so one that truly curves so much all along has larger ones beside them, and fails. (Over blobs 12 to 60 pixels wide the
// worst of all texels was 3 steps from the mean.)
constexpr float kBendError = 4.0f;

float square(float x, float y) { return x * x + y * y; }

/// The largest bend at which `error_a_bend` times it stays within `error`.
std::int32_t bends_within(float error, float error_a_bend) {
    return static_cast<std::int32_t>(std::min(static_cast<float>(kMostBend), error / std::max(error_a_bend, 1e-6f)));
}

/// A footprint's sides in pixels of the level.
struct LevelSides {
    float across_x, across_y, down_x, down_y;
};
LevelSides sides_on(const PyramidLevel& on, const Footprint& f) {
    return {f.across_x * on.scale_x, f.across_y * on.scale_y, f.down_x * on.scale_x, f.down_y * on.scale_y};
}

/// The largest roughness at which `error_a_step` times it stays within `error`.
std::int32_t steps_within(float error, float error_a_step) {
    return static_cast<std::int32_t>(std::min(255.0f, error / std::max(error_a_step, 1e-6f)));
}

// How dense the samples stand along an axis: so many a pixel, and half a one more. Over random and aligned decals on
// checkers of 2 to 8 pixels, magnified and minified up to 8 times, the worst is 41.5 dB against 8 x 8 samples; with 1.6
// and nothing more it was 38.2, at one and at two pixels a texel.
constexpr float kSamplesPerPixel = 1.8f;

// One sample where the footprint is so small that the bilinear filter blurs far more than the footprint would: at the
// limit a 5-pixel checker keeps 41 dB in the worst alignment, at 0.4 pixels it had 37.
int sample_count(float pixels) {
    if (pixels <= 0.25f) return 1;
    // Bounded before it becomes a whole number: a footprint may be larger than any.
    const float wanted = std::ceil(std::min(pixels, 1e4f) * kSamplesPerPixel + 0.5f);
    const int dense = std::max(2, static_cast<int>(wanted));
    return std::min(dense, pixels <= kFinestPixels ? kEdgeSamples : kMaxSamples);
}

// A footprint whose longer side is above this, and not above kFinestPixels, takes the reference's own 8 x 8 samples. The reference
// aliases on stripes of one pixel, and what is closer to the true mean than it is by so much away from it: parts of 5.6 x 1.4 pixels
// came to 31.6 dB against 8 x 8 samples (57 dB against 64 x 64), of 3.2 x 1.5 pixels to 37.8. With this bound the worst of 8000
// footprints up to 8 x 8 on stripes, checkers and noise of 1 to 3 pixels is 41. (As many samples as sample_count says, along either side:
// 35.7. Shorter ones that lean too far for parts came to 38.1 with those, and take 8 x 8 too.)
constexpr float kLongestParts = 3.0f;

// How far the samples of an axis stand apart, as a share of the footprint. Two stand a little further apart than in its
// quarters: half way to Gauss's points, which serves the ramps of a bilinear picture best (at one pixel a texel 39 dB
// instead of 34 in the worst alignment of a 5-pixel checker).
float spacing(std::int32_t samples) { return samples == 2 ? 0.55f : 1.0f / static_cast<float>(samples); }

/// How four samples at a time go over the lattice: of short rows, several at once.
struct LatticeGroup {
    std::int32_t columns;
    std::int32_t rows;
    Float4 column;  // of each of the four
    Float4 row;
};
const LatticeGroup kLatticeGroups[3] = {
    {1, 4, {0, 0, 0, 0}, {0, 1, 2, 3}}, {2, 2, {0, 1, 0, 1}, {0, 0, 1, 1}}, {4, 1, {0, 1, 2, 3}, {0, 0, 0, 0}}};

const LatticeGroup& lattice_group(std::int32_t across_samples) {
    return kLatticeGroups[across_samples < 3 ? across_samples - 1 : 2];
}

// The longer side of a part that its kernel serves, by the shorter one: so the worst of the pictures in footprint_kernel.h
// stays above 39 dB, and where the two are alike above 41. (Kernels by a parallelogram's very shadows on the axes, each a box * box,
// serve no longer ones on noise; and where a picture is calmer, one such kernel over two parts or three made a drag no quicker: there
// are so many of them that their tables leave the cache.)
bool kernel_serves(float longer, float shorter) { return longer <= 0.85f + 0.42f * shorter; }

// How far a part may lean, as the covariance of its x and y, how far it may be turned (a square with sides of a pixel, at 45
// degrees: 1), and how wide its box may be along an axis: what a kernel makes of larger ones fails on the finest pictures first. Of
// 28,000 footprints up to three pixels, of any shape and at any angle, the worst keeps 40 dB on stripes and checkers of one pixel.
// Where they may be turned at will that is 35.9; with 0.9 it is 39.8, and with leans up to 0.015 it is 39.1. With boxes up to 1.5 it
// is 35.5, and with none of the bounds 24.
constexpr float kMostLean = 0.011f;
constexpr float kMostTurned = 0.82f;
constexpr float kWidestBox = 1.2f;

/// Cuts a footprint on the finest level, whose sides have these lengths, into parts that a kernel serves. False where they
/// are too many.
bool cut_into_parts(float across, float down, Footprint& f) {
    std::int32_t columns = 1;
    std::int32_t rows = 1;
    float u = 1.0f;
    float v = 1.0f;
    for (;;) {
        const float right = f.across_x * u;
        const float below = f.across_y * u;
        const float down_right = f.down_x * v;
        const float down_below = f.down_y * v;
        const float part_across = across * u;
        const float part_down = down * v;
        const bool leans = std::fabs(covariance_of(right, below, down_right, down_below)) > kMostLean;
        const float turned = std::fabs(right * down_right) + std::fabs(below * down_below);
        const float widest = std::max(square(right, down_right), square(below, down_below));
        if (kernel_serves(std::max(part_across, part_down), std::min(part_across, part_down)) && !leans &&
            turned <= kMostTurned && widest <= kWidestBox * kWidestBox) {
            f.kernel = make_footprint_kernel(right, below, down_right, down_below);
            break;
        }
        if (part_across >= part_down) {
            u = 1.0f / static_cast<float>(++columns);
        } else {
            v = 1.0f / static_cast<float>(++rows);
        }
        if (columns * rows > kMostParts) return false;
    }
    f.parts = columns * rows;
    for (std::int32_t i = 0; i < f.parts; ++i) {
        const float right = (static_cast<float>(i % columns) + 0.5f) * u - 0.5f;
        const float below = (static_cast<float>(i / columns) + 0.5f) * v - 0.5f;
        f.part_x[i] = to_fixed(f.across_x * right + f.down_x * below);
        f.part_y[i] = to_fixed(f.across_y * right + f.down_y * below);
    }
    return true;
}

/// Windows of a list that cover rectangles of which footprints span the rim.
void cover(const PyramidLevel& on, const std::vector<std::uint8_t>& list, std::int32_t window, float reach_x,
           float reach_y, SmoothTest& test) {
    const std::int32_t half = window / 2 * kWeightOne;
    const std::int32_t x = half - to_fixed(reach_x);
    const std::int32_t y = half - to_fixed(reach_y);
    const std::int32_t last_x = static_cast<std::int32_t>(on.width) + kPad - 1;
    const std::int32_t last_y = static_cast<std::int32_t>(on.height) + kPad - 1;
    test.list = on.first_of(list);
    test.window = window;
    test.to_windows = PlaceBounds{x, y, -x, -y};
    test.last_window = Int4{last_x, last_y, last_x, last_y};
}

/// `reach`: of the footprint on the level, along the axis along which it reaches further. (A second look at texels that fail, with
/// four windows that fit their footprints exactly, took 0.98 of the time at four pixels a texel and gained nothing below.)
void find_smoothness(const PyramidLevel& on, float reach, Footprint& f) {
    const auto [across_x, across_y, down_x, down_y] = sides_on(on, f);
    f.smooth_list = on.first_of(on.bends[2]);
    f.smooth_limit = -1;
    if (reach <= 2.0f) {
        f.smooth_list = on.first_of(on.peaks[reach <= 1.0f ? 0 : 1]);
        f.smooth_limit = steps_within(kSmoothError, largest_smooth_error(across_x, across_y, down_x, down_y));
    }
    f.smooth_by_bends = f.smooth_limit < 1 && reach <= 8.0f;
    if (!f.smooth_by_bends) return;
    f.smooth_list = on.first_of(on.bends[reach <= 2.0f ? 0 : reach <= 4.0f ? 1 : 2]);
    f.smooth_limit = bends_within(kSmoothError, (square(across_x, across_y) + square(down_x, down_y)) * kBendMean);
}

/// Where the footprint meets no kink. Its reach is bounded before it becomes a whole number.
void find_room(const PyramidLevel& on, Footprint& f) {
    const auto [across_x, across_y, down_x, down_y] = sides_on(on, f);
    const auto room = [](float reach) { return kWeightOne - to_fixed(2.0f * std::min(reach, 1.0f)); };
    f.room_x = room(f.reach_x * on.scale_x);
    f.room_y = room(f.reach_y * on.scale_y);
    f.twist_limit = steps_within(kTwistError, std::fabs(covariance_of(across_x, across_y, down_x, down_y)));
}

// Sides are bounded before they become whole numbers: longer ones lie inside of no picture.
constexpr float kLongestSide = 3e4f;

/// So many samples along each side.
void make_lattice(const PyramidLevel& on, const Footprint& f, std::int32_t across_samples, std::int32_t down_samples,
                  SampleLattice& out) {
    out.across_samples = across_samples;
    out.down_samples = down_samples;
    const LevelSides sides = sides_on(on, f);
    const float across_spacing = spacing(across_samples);
    const float down_spacing = spacing(down_samples);
    const LatticeGroup& group = lattice_group(across_samples);
    const Float4 i = group.column - splat(0.5f * static_cast<float>(across_samples - 1));
    const Float4 j = group.row - splat(0.5f * static_cast<float>(down_samples - 1));
    const auto bounded = [](float side) { return std::max(-kLongestSide, std::min(side, kLongestSide)); };
    const auto place = [&](float across, float down, Int4& first, std::int32_t& across_step, std::int32_t& down_step) {
        across = bounded(across * across_spacing);
        down = bounded(down * down_spacing);
        first = round_to_int((i * splat(across) + j * splat(down)) * splat(static_cast<float>(kWeightOne)));
        across_step = to_fixed(across);
        down_step = to_fixed(down);
    };
    place(sides.across_x, sides.down_x, out.x, out.across_step_x, out.down_step_x);
    place(sides.across_y, sides.down_y, out.y, out.across_step_y, out.down_step_y);
}

// Where the picture is calm, samples may stand so many pixels apart in footprints from this size on.
//
// Calm is a picture up to this bend, half of the largest second difference in the 16 pixels around: there the worst of checkers of 2
// to 11 pixels, stripes and noise of that roughness all over keeps 40 dB, in any direction, and with 32 for 24 keeps 38.8. In three
// photographs of 2048 x 2048, 72 to 98 % of the places are so. A drag of such a photograph at seven pixels a texel takes 0.74 to 0.83
// of the time. (The next coarser level keeps as much up to 8, 11 or 21 by the footprint's size, and reads three pixels more around it.)
constexpr float kCalmSpacing = 1.5f;
constexpr float kLeastCalm = 3.0f;
constexpr std::int32_t kCalmSteps = 24;
// How far the widest of the lists of bends knows the picture around a place, without the pixel that a sample reads beyond its own.
constexpr float kCalmReach = 7.0f;

/// `across`, `down`: lengths on the level, in its pixels; `reach` as of find_smoothness.
void find_calm(const PyramidLevel& on, float across, float down, float reach, Footprint& f) {
    f.calm_limit = -1;
    // Written so that what is no number is not as one.
    if (!(std::min(across, down) >= kLeastCalm && reach <= kCalmReach)) return;
    const auto count = [](float pixels) { return static_cast<std::int32_t>(std::ceil(pixels / kCalmSpacing)); };
    make_lattice(on, f, count(across), count(down), f.calm_lattice);
    f.calm_limit = kCalmSteps;
    f.calm_list = on.first_of(on.bends[2]);
}

}  // namespace

// Not cleared first: most of a footprint is lists, of which few entries are used.
void make_footprint(const ImagePyramid& image, float across_x, float across_y, float down_x, float down_y, bool repeat,
                    Footprint& f) {
    f.parts = 0;
    f.across_x = across_x;
    f.across_y = across_y;
    f.down_x = down_x;
    f.down_y = down_y;
    f.reach_x = 0.5f * (std::fabs(across_x) + std::fabs(down_x));
    f.reach_y = 0.5f * (std::fabs(across_y) + std::fabs(down_y));
    const float across = length(across_x, across_y);
    const float down = length(down_x, down_y);
    const float longer = std::max(across, down);
    float shorter = std::min(across, down);
    float finest = kFinestPixels;
    std::uint32_t level = 0;
    float pixel = 1.0f;  // of the level, in pixels of the picture
    while (level + 1 < image.levels.size() &&
           (shorter >= finest * pixel || longer * kSamplesPerPixel > static_cast<float>(kMaxSamples) * pixel)) {
        ++level;
        pixel *= 2.0f;
    }
    f.level = level;
    const PyramidLevel& on = image.levels[level];
    // All four pixels of a sample must exist, half a pixel of the level around it, and a little for rounding.
    float rim = 0.51f;
    const bool as_reference = longer <= kFinestPixels;
    const bool may_cut = level == 0 && !(as_reference && longer > kLongestParts);
    if (may_cut && cut_into_parts(across, down, f)) {
        rim = 1.51f;  // of a kernel, one more
    } else {
        const auto samples = [&](float side) { return as_reference ? kEdgeSamples : sample_count(side / pixel); };
        make_lattice(on, f, samples(across), samples(down), f.lattice);
    }
    // On the picture itself what it is padded with serves as well. Not where it repeats and is cut hard.
    if (level == 0 && !repeat) rim -= static_cast<float>(kPad);
    f.inset_x = f.reach_x + rim / on.scale_x;
    f.inset_y = f.reach_y + rim / on.scale_y;
    const float reach = std::max(f.reach_x * on.scale_x, f.reach_y * on.scale_y);
    find_smoothness(on, reach, f);
    find_room(on, f);
    find_calm(on, across / pixel, down / pixel, reach, f);
    // At the edge a coarse level would fade over too wide a rim, and a repeated picture is cut hard: there the samples
    // are as many as the reference has. A level whose pixels are no larger than their distance is still fine enough.
    const bool dense = repeat || level > 0;
    f.edge_across_samples = dense ? kEdgeSamples : sample_count(across);
    f.edge_down_samples = dense ? kEdgeSamples : sample_count(down);
    f.edge_level = 0;
    while (f.edge_level + 1 < image.levels.size() && longer >= static_cast<float>((2 * kEdgeSamples) << f.edge_level))
        ++f.edge_level;
}

namespace {

std::int32_t chord_limit_within(const ImagePyramid& image, const Footprint& f, float texels, float error) {
    const PyramidLevel& on = image.levels[f.level];
    const float x = f.across_x * on.scale_x * texels;
    const float y = f.across_y * on.scale_y * texels;
    if (f.smooth_by_bends) return std::min(f.smooth_limit, bends_within(error, square(x, y) * kBendChord));
    return std::min(f.smooth_limit, steps_within(error, largest_chord_error(x, y)));
}

/// For squares of `side` texels anywhere among `span` x `span` texels.
SmoothTest square_test(const ImagePyramid& image, const Footprint& f, float side, float span) {
    const PyramidLevel& on = image.levels[f.level];
    const auto [across_x, across_y, down_x, down_y] = sides_on(on, f);
    const float reach_x = f.reach_x * on.scale_x;
    const float reach_y = f.reach_y * on.scale_y;
    SmoothTest test;
    // Pixels whose centres lie in the rectangle: only there a bilinear picture bends.
    const float most = std::max(reach_x, reach_y) * 2.0f * (span + 1.0f);
    if (f.smooth_limit < 0 || !(most < 32.0f)) return test;
    const std::int32_t longer = static_cast<std::int32_t>(most) + 1;
    if (!f.smooth_by_bends && longer <= 8) {
        test.limit = std::min(f.smooth_limit,
                              steps_within(kTileChordError, largest_chord_error(across_x * side, across_y * side) +
                                                                largest_chord_error(down_x * side, down_y * side)));
        const int list = longer <= 4 ? 0 : 1;
        cover(on, on.peaks[list], 2 << list, reach_x, reach_y, test);
    }
    if (test.limit < 1) {
        const float squares = square(across_x, across_y) + square(down_x, down_y);
        test.limit = std::min(f.smooth_by_bends ? f.smooth_limit : f.smooth_limit / 2,
                              bends_within(kBendError, squares * side * side * kBendChord));
        const int list = longer <= 8 ? 0 : longer <= 16 ? 1 : 2;
        cover(on, on.bends[list], 4 << list, reach_x, reach_y, test);
    }
    return test;
}

}  // namespace

std::int32_t chord_limit(const ImagePyramid& image, const Footprint& f, float texels) {
    return chord_limit_within(image, f, texels, kChordError);
}

ChordLimits tile_chord_limits(const ImagePyramid& image, const Footprint& f) {
    return {chord_limit_within(image, f, 3.0f, kTileChordError), square_test(image, f, 3.0f, 3.0f),
            square_test(image, f, 5.0f, 15.0f)};
}

namespace {

/// Mean colour by a lattice of samples, to the nearest. `x`, `y` as in RoughTexel.
__attribute__((noinline)) Int4 sample_lattice(const PyramidLevel& level, const SampleLattice& lattice, std::int32_t x,
                                              std::int32_t y) {
    const LatticeGroup& group = lattice_group(lattice.across_samples);
    const std::int32_t stride = level.stride();
    Int4 sum{};
    for (std::int32_t j = 0; j < lattice.down_samples; j += group.rows) {
        for (std::int32_t i = 0; i < lattice.across_samples; i += group.columns) {
            const Int4 at_x = splat(x + i * lattice.across_step_x + j * lattice.down_step_x) + lattice.x;
            const Int4 at_y = splat(y + i * lattice.across_step_y + j * lattice.down_step_y) + lattice.y;
            const std::int32_t count =
                std::min(group.columns, lattice.across_samples - i) * std::min(group.rows, lattice.down_samples - j);
            sum += sum_samples(level, place_samples(at_x, at_y, stride), count);
        }
    }
    const auto count = static_cast<float>(lattice.across_samples * lattice.down_samples);
    return __builtin_convertvector(
        __builtin_convertvector(sum, Float4) * splat(1.0f / count) + splat(static_cast<float>(kChannelBias) + 0.5f),
        Int4);
}

/// Kernels that lean may go a little beyond black, white and the colour that an alpha allows.
Int4 within_alpha(Int4 color) {
    constexpr auto kFull = static_cast<std::int32_t>(kFullScale);
    return lesser(greater(color, splat(0)), splat(std::min(std::max(color[3], 0), kFull)));
}

/// Mean colour by the kernels of the footprint's parts. `x`, `y` as in RoughTexel.
__attribute__((always_inline)) inline Int4 sample_parts(const PyramidLevel& level, const Footprint& f, std::int32_t x,
                                                        std::int32_t y) {
    const std::int16_t* pixels = level.first_pixel();
    const std::int32_t stride = level.stride();
    Int4 sum = sample_kernel(pixels, stride, f.kernel, x + f.part_x[0], y + f.part_y[0]);
    for (std::int32_t i = 1; i < f.parts; ++i)
        sum += sample_kernel(pixels, stride, f.kernel, x + f.part_x[i], y + f.part_y[i]);
    // To the nearest: of n times a number, an n-th is that number.
    if (f.parts > 1)
        sum = round_to_int(__builtin_convertvector(sum, Float4) * splat(1.0f / static_cast<float>(f.parts)));
    return within_alpha(sum + kBias);
}

/// The lattice that a footprint's mean takes at a place (as of RoughTexel), or null where its parts do.
const SampleLattice* lattice_at(const PyramidLevel& level, const Footprint& f, std::int32_t x, std::int32_t y) {
    if (f.calm_limit >= 0 && f.calm_list[(y >> kWeightBits) * level.stride() + (x >> kWeightBits)] <= f.calm_limit)
        return &f.calm_lattice;
    return f.parts > 0 ? nullptr : &f.lattice;
}

__attribute__((always_inline)) inline Int4 sample_rough(const PyramidLevel& level, const Footprint& f, std::int32_t x,
                                                        std::int32_t y) {
    const SampleLattice* lattice = lattice_at(level, f, x, y);
    return lattice == nullptr ? sample_parts(level, f, x, y) : sample_lattice(level, *lattice, x, y);
}

}  // namespace

void paint_rough(const RoughTexel* texels, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const RoughTexel& texel = texels[i];
        store_ushort4(texel.out, sample_rough(*texel.level, *texel.footprint, texel.x, texel.y));
    }
}

Float4 sample_inside(const ImagePyramid& image, const Footprint& f, float x, float y) {
    const PyramidLevel& level = image.levels[f.level];
    const float level_x = x * level.scale_x - 0.5f;
    const float level_y = y * level.scale_y - 0.5f;
    const SamplePlaces place = place_samples(splat(level_x), splat(level_y), level.stride());
    const std::int32_t steps = f.smooth_list[place.offset[0]];
    const std::int32_t fixed_x = to_fixed(level_x);
    const std::int32_t fixed_y = to_fixed(level_y);
    if (are_rough(f, splat(steps), splat(fixed_x), splat(fixed_y))[0] != 0)
        return __builtin_convertvector(sample_rough(level, f, fixed_x, fixed_y), Float4);
    return __builtin_convertvector(sum_samples(level, place, 1), Float4) + splat(static_cast<float>(kChannelBias));
}

Float4 sample_edge(const ImagePyramid& image, const Footprint& f, float x, float y, bool repeat) {
    const PyramidLevel& level = image.levels[f.edge_level];
    const auto width = static_cast<float>(image.levels[0].width);
    const auto height = static_cast<float>(image.levels[0].height);
    const float across_step = spacing(f.edge_across_samples);
    const float down_step = spacing(f.edge_down_samples);
    const float first_u = -0.5f * across_step * static_cast<float>(f.edge_across_samples - 1);
    const float first_v = -0.5f * down_step * static_cast<float>(f.edge_down_samples - 1);
    Float4 sum = splat(0.0f);
    for (std::int32_t j = 0; j < f.edge_down_samples; ++j) {
        const float v = first_v + static_cast<float>(j) * down_step;
        for (std::int32_t i = 0; i < f.edge_across_samples; ++i) {
            const float u = first_u + static_cast<float>(i) * across_step;
            const float sample_x = x + (f.across_x * u + f.down_x * v);
            const float sample_y = y + (f.across_y * u + f.down_y * v);
            if (repeat && (sample_x < 0.0f || sample_x > width || sample_y < 0.0f || sample_y > height)) continue;
            sum += sample_bilinear(level, sample_x * level.scale_x, sample_y * level.scale_y, repeat);
        }
    }
    return sum * splat(1.0f / static_cast<float>(f.edge_across_samples * f.edge_down_samples));
}

}  // namespace txc
