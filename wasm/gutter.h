// The texels around a chart that carry its nearest triangle onward (spec section 2): found here, stored by the bake.
#pragma once

#include <cstdint>
#include <vector>

namespace txc {

inline constexpr std::uint32_t kMaxGutter = 64;
inline constexpr std::int8_t kNoNeighbour = 127;

/// Default gutter: 2 texels at 1024 and in proportion, never less than 2 (the larger side decides).
std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height);

/// First pass, one row: for each texel the signed distance along the row to the nearest owned one (0 on it, the left
/// one of two), at most `gutter` either way, else kNoNeighbour. A texel is owned unless its owner is `nobody`.
void nearest_in_row(const std::uint32_t* owners, std::uint32_t nobody, std::uint32_t width, std::uint32_t gutter,
                    std::int8_t* out);

struct NearestTexel {
    std::int32_t x;
    std::int32_t y;
    bool found;
};

/// Second pass, one texel: the nearest owned texel within `gutter` texels (Euclidean, centre to centre), from all
/// rows' first pass. Of equally near ones the row closest above wins: a fixed choice, so that results repeat.
NearestTexel nearest_owned(const std::vector<std::int8_t>& rows, std::uint32_t width, std::uint32_t height,
                           std::uint32_t gutter, std::uint32_t x, std::uint32_t y);

}  // namespace txc
