// What of a picture lands on the surface: a grid over the picture, on which each texel marks what it takes.
#pragma once

#include <cstdint>
#include <vector>

#include "image_pyramid.h"
#include "projection.h"
#include "texel_sight.h"

namespace txc {

class PictureLanding {
public:
    /// Cells are the pixels of the first level of the picture that has at most kMostCells a side.
    PictureLanding(const ImagePyramid& image, const DecalSettings& settings, double period);

    enum Mark : std::uint8_t { kNothing, kHidden, kKept };

    /// Marks the cells whose centres lie in the texel's footprint, unless they bear a higher mark.
    void mark(const PictureSight& sight, Mark mark);

    /// Whether there is anything of the picture at a place.
    bool is_clear_at(const PictureSight& sight) const;

    /// Shares of the picture, by its alpha; 0 of one that is transparent all over.
    double clipped() const {
        return share_where([](std::uint8_t mark) { return mark != kKept; });
    }
    double hidden() const {
        return share_where([](std::uint8_t mark) { return mark == kHidden; });
    }

    static constexpr std::uint32_t kMostCells = 512;

private:
    void mark_at(double x, double y, const PictureSight& sight, Mark mark);

    template <typename Wanted>
    double share_where(Wanted&& wanted) const {
        double all = 0.0;
        double some = 0.0;
        for (std::uint32_t row = 0; row < level_->height; ++row) {
            for (std::uint32_t column = 0; column < level_->width; ++column) {
                const double alpha = level_->color_at(column, row)[3];
                all += alpha;
                if (wanted(marks_[std::size_t{row} * level_->width + column])) some += alpha;
            }
        }
        return all > 0.0 ? some / all : 0.0;
    }

    const PyramidLevel* level_;
    bool flip_x_;
    bool flip_y_;
    double period_;  // the sight's x meets itself after so many picture widths; 0 where it does not
    std::vector<std::uint8_t> marks_;
};

}  // namespace txc
