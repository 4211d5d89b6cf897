// The target texture and its coarser levels. The core makes the levels, not the GPU: a drag then refreshes only what
// changed (a full rebuild of a 2048 x 2048 texture's levels costs 200 ms in software GL), and they are the same everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "coverage_bits.h"

namespace txc {

struct MipLevel {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;  // sRGB, straight alpha
};

struct MipChain {
    std::vector<MipLevel> levels;
    /// Of each level but the last: the texels that hold some of a chart or its gutter. Empty where none was noted.
    std::vector<CoverageBits> covered;

    /// Levels of a whole chain down to 1 x 1.
    static std::uint32_t full_count(std::uint32_t width, std::uint32_t height);
    static std::uint64_t byte_count(std::uint32_t width, std::uint32_t height, std::uint32_t level_count);

    void allocate(std::uint32_t width, std::uint32_t height, std::uint32_t level_count);

    /// Bytes of `covered`.
    static std::uint64_t coverage_byte_count(std::uint32_t width, std::uint32_t height, std::uint32_t level_count);

    /// Takes the charts of level 0 and finds those of the others. What lies between charts lends coarser levels no colour
    /// beside one: the gutter alone keeps the ground out of no more than the finest levels.
    void note_charts(CoverageBits charts);

    /// Makes the texels [x0, x1) x [y0, y1) of a level above 0 from the one below: means of 2 x 2 in linear light,
    /// weighted by alpha, of those that hold some of a chart (of all four where none does). An odd last column or row
    /// drops out, as in GPUs' own simple filter.
    void reduce(std::uint32_t level, std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1);
};

}  // namespace txc
