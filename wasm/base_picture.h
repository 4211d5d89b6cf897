// What a target's layers lie on: one colour, or a picture at the target's size.
#pragma once

#include <cstdint>
#include <vector>

namespace txc {

struct BasePicture {
    std::uint8_t color[4] = {255, 255, 255, 255};
    std::vector<std::uint8_t> rgba;  // width * height * 4 of the target, or empty: the colour holds everywhere
};

/// The part of a resampled picture that is wanted.
struct ResampledWindow {
    std::uint32_t whole_width;
    std::uint32_t whole_height;
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t width;
    std::uint32_t height;
};

/// Resamples RGBA with straight alpha. Enlarging interpolates (or, `nearest`, repeats) pixels, shrinking averages areas
/// weighted by alpha, so that colour under transparent pixels does not bleed into the rest; where all of it is
/// transparent the plain mean keeps that colour. Axes are independent. `out`: the window's width * height * 4 bytes.
void resample_rgba(const std::uint8_t* rgba, std::uint32_t width, std::uint32_t height, bool nearest,
                   const ResampledWindow& window, std::uint8_t* out);

}  // namespace txc
