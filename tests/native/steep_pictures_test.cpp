// Ramps so steep that a channel goes through more than half of its range between texels that colours may be interpolated
// from: the two texels' difference does not fit the 16 bits that such a square is reckoned in (short8.h).
#include <doctest/doctest.h>

#include "support/comparison.h"

using namespace support;

namespace {

/// One channel goes up and down by whole steps, so that each stretch is straight to the last bit; the others are even.
Picture make_zigzag(std::uint32_t side, std::uint32_t step, std::size_t channel) {
    const std::uint32_t ramp = 255 / step;
    Picture picture(side, side, channel == 3 ? Color{0, 0, 0, 0} : kWhite);
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint32_t way = i % side % (2 * ramp);
        picture.rgba[std::size_t{i} * 4 + channel] =
            static_cast<std::uint8_t>((way < ramp ? way : 2 * ramp - way) * step);
    }
    return picture;
}

}  // namespace

TEST_CASE("Ramps that go through more than half a channel within a square keep their colours, whichever way they go") {
    Comparison plane(make_plane(), 64, 64);
    const struct {
        double pixels_a_texel;
        std::uint32_t step;
    } steepness[] = {{2, 22}, {3, 15}, {4, 11}, {6, 8}};
    for (const auto& ramp : steepness) {
        for (const double degrees : {0.0, 90.0}) {
            CAPTURE(ramp.pixels_a_texel);
            CAPTURE(degrees);
            TxcLayerDef def = decal_def(0);
            resize(def, 0.75, 0.75, 0.5);
            turn(def, 0, 0, 1, degrees);
            const auto side = static_cast<std::uint32_t>(48 * ramp.pixels_a_texel);
            for (const std::size_t channel : {0u, 1u, 2u, 3u}) {
                CAPTURE(channel);
                check(plane.paint(def, make_zigzag(side, ramp.step, channel)));
            }
        }
    }
}
