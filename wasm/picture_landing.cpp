#include "picture_landing.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

const PyramidLevel& level_for_cells(const ImagePyramid& image) {
    for (const PyramidLevel& level : image.levels) {
        if (std::max(level.width, level.height) <= PictureLanding::kMostCells) return level;
    }
    return image.levels.back();
}

/// Texels from a centre to its edges, and a little more: rounding must leave no cell between two texels unmarked.
constexpr double kReach = 0.5 + 1.0 / 256;

/// The cells [first, last) whose centres lie within `reach` of `centre`.
struct CellRange {
    std::int32_t first;
    std::int32_t last;

    CellRange(double centre, double reach, std::uint32_t count) {
        const auto most = static_cast<double>(count);
        first = static_cast<std::int32_t>(std::ceil(std::clamp(centre - reach, 0.0, most) - 0.5));
        last = static_cast<std::int32_t>(std::floor(std::clamp(centre + reach, 0.0, most) - 0.5)) + 1;
        first = std::max(first, 0);
        last = std::min(last, static_cast<std::int32_t>(count));
    }
};

}  // namespace

PictureLanding::PictureLanding(const ImagePyramid& image, const DecalSettings& settings, double period)
    : level_(&level_for_cells(image)),
      flip_x_(settings.flip_x),
      flip_y_(settings.flip_y),
      period_(period),
      marks_(std::size_t{level_->width} * level_->height, kNothing) {}

void PictureLanding::mark(const PictureSight& sight, Mark mark) {
    mark_at(sight.x, sight.y, sight, mark);
    if (period_ <= 0.0) return;
    // A texel over the back of a whole turn reaches into the picture from both sides.
    mark_at(sight.x - period_, sight.y, sight, mark);
    mark_at(sight.x + period_, sight.y, sight, mark);
}

void PictureLanding::mark_at(double x, double y, const PictureSight& sight, Mark mark) {
    const auto width = static_cast<double>(level_->width);
    const auto height = static_cast<double>(level_->height);
    const double centre_x = (0.5 + (flip_x_ ? -x : x)) * width;
    const double centre_y = (0.5 - (flip_y_ ? -y : y)) * height;
    const double across_x = (flip_x_ ? -sight.across_x : sight.across_x) * width;
    const double down_x = (flip_x_ ? -sight.down_x : sight.down_x) * width;
    const double across_y = (flip_y_ ? sight.across_y : -sight.across_y) * height;
    const double down_y = (flip_y_ ? sight.down_y : -sight.down_y) * height;
    const double det = across_x * down_y - across_y * down_x;
    if (!(std::fabs(det) > 0.0)) return;
    const CellRange columns(centre_x, kReach * (std::fabs(across_x) + std::fabs(down_x)), level_->width);
    const CellRange rows(centre_y, kReach * (std::fabs(across_y) + std::fabs(down_y)), level_->height);
    for (std::int32_t row = rows.first; row < rows.last; ++row) {
        for (std::int32_t column = columns.first; column < columns.last; ++column) {
            const double away_x = column + 0.5 - centre_x;
            const double away_y = row + 0.5 - centre_y;
            // In texels.
            const double texels_x = (away_x * down_y - away_y * down_x) / det;
            const double texels_y = (across_x * away_y - across_y * away_x) / det;
            if (!(std::fabs(texels_x) <= kReach && std::fabs(texels_y) <= kReach)) continue;
            std::uint8_t& cell = marks_[static_cast<std::size_t>(row) * level_->width + column];
            if (mark > cell) cell = mark;
        }
    }
}

bool PictureLanding::is_clear_at(const PictureSight& sight) const {
    const double x = std::clamp((0.5 + (flip_x_ ? -sight.x : sight.x)) * level_->width, 0.0, level_->width - 1.0);
    const double y = std::clamp((0.5 - (flip_y_ ? -sight.y : sight.y)) * level_->height, 0.0, level_->height - 1.0);
    return level_->color_at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))[3] == 0;
}

}  // namespace txc
