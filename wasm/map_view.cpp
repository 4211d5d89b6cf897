#include "map_view.h"

#include <cstring>
#include <vector>

#include "exact_math.h"
#include "texelcast.h"

namespace txc {
namespace {

struct Color {
    std::uint8_t red, green, blue;
};

constexpr Color kCoveredColor{226, 232, 240};
constexpr Color kGutterColor{100, 116, 139};
constexpr Color kClaimedOnce{34, 139, 94};
constexpr Color kClaimedTwice{240, 170, 50};
constexpr Color kClaimedMore{215, 60, 60};

void put(std::uint8_t* texel, Color color) {
    texel[0] = color.red;
    texel[1] = color.green;
    texel[2] = color.blue;
    texel[3] = 255;
}

double share_of(float value, float low, float high) {
    return high > low ? static_cast<double>(value - low) / static_cast<double>(high - low) : 0.5;
}

}  // namespace

void draw_map_view(const LocalSpaceMap& map, std::uint32_t view, std::uint32_t row, std::uint32_t row_count,
                   std::uint8_t* out_rgba) {
    const std::size_t width = map.key.width;
    std::memset(out_rgba, 0, row_count * width * 4);
    std::vector<std::uint8_t> claims;
    if (view == TXC_VIEW_OVERLAP) {
        claims.resize(row_count * width);
        map.read_overlap(row, row_count, claims.data());
    }
    map.for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        for (std::uint32_t i = 0; i < run.length; ++i) {
            const std::uint32_t x = tile_x + run.x + i;
            const std::size_t texel = (y - row) * width + x;
            std::uint8_t* out = out_rgba + texel * 4;
            const bool gutter = (run.flags & kRunGutter) != 0;
            if (view == TXC_VIEW_POSITIONS) {
                const glm::vec3 p =
                    map.frames[run.frame].position_at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
                for (int c = 0; c < 3; ++c) out[c] = to_byte(share_of(p[c], map.bounds.min[c], map.bounds.max[c]));
                out[3] = 255;
            } else if (view == TXC_VIEW_NORMALS) {
                const glm::vec3 n = map.unit_normal(run, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
                for (int c = 0; c < 3; ++c) out[c] = to_byte(static_cast<double>(n[c]) * 0.5 + 0.5);
                out[3] = 255;
            } else if (view == TXC_VIEW_COVERAGE) {
                put(out, gutter ? kGutterColor : kCoveredColor);
            } else if (claims[texel] > 0) {
                put(out, claims[texel] == 1 ? kClaimedOnce : claims[texel] == 2 ? kClaimedTwice : kClaimedMore);
            }
        }
    });
}

}  // namespace txc
