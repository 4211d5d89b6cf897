// Triangle coverage in texture space: which texels have their centre inside a triangle (spec section 2, top-left rule).
//
// Each edge crosses a row of centres at one place, computed from its endpoints in a fixed order, so the two triangles
// that share the edge get the same number to the last bit; spans are half open on it. Every texel under a shared edge
// or vertex therefore belongs to exactly one triangle, whatever the rounding.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "double2.h"

namespace txc {

/// A triangle's corners in texels: x = u * width, y = v * height. Not wrapped; below 2^30 either way.
struct TexelTriangle {
    double x[3];
    double y[3];

    /// Twice the signed area; 0 for a triangle that owns no texel.
    double doubled_area() const { return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]); }
};

/// Rows, or the texels of a row: [first, last). Empty where first >= last.
struct TexelRange {
    std::int32_t first;
    std::int32_t last;
};

/// First integer whose centre (+ 1/2) is at or after `coordinate`.
inline std::int32_t first_centre_from(double coordinate) {
    return static_cast<std::int32_t>(std::ceil(coordinate - 0.5));
}

/// A triangle with its corners in the order in which rows come, ready to be walked row by row.
class TriangleRaster {
public:
    TriangleRaster() = default;
    explicit TriangleRaster(const TexelTriangle& t) {
        int top = 0;
        int middle = 1;
        int bottom = 2;
        if (t.y[middle] < t.y[top]) std::swap(top, middle);
        if (t.y[bottom] < t.y[middle]) std::swap(middle, bottom);
        if (t.y[middle] < t.y[top]) std::swap(top, middle);
        middle_y_ = t.y[middle];
        rows_ = {first_centre_from(t.y[top]), first_centre_from(t.y[bottom])};
        upper_ = EdgePair(t, top, bottom, top, middle);
        lower_ = EdgePair(t, top, bottom, middle, bottom);
    }

    /// The rows whose centres can lie inside.
    TexelRange rows() const { return rows_; }

    /// The texels of one of rows() whose centres lie inside.
    TexelRange span(std::int32_t row) const {
        // A row of centres meets the long edge and one of the others. Half open on rows too: an edge owns the centre
        // lines from its upper end up to, not with, its lower end.
        const double centre = static_cast<double>(row) + 0.5;
        const WholePair ends = middle_y_ <= centre ? lower_.first_centres(centre) : upper_.first_centres(centre);
        return ends.first < ends.second ? TexelRange{ends.first, ends.second} : TexelRange{ends.second, ends.first};
    }

private:
    /// The long edge and one of the others.
    struct EdgePair {
        Double2 x{};
        Double2 y{};
        Double2 x_extent{};
        Double2 y_extent{};
        Double2 slope{};

        EdgePair() = default;
        EdgePair(const TexelTriangle& t, int from, int to, int other_from, int other_to)
            : x{t.x[from], t.x[other_from]},
              y{t.y[from], t.y[other_from]},
              x_extent(Double2{t.x[to], t.x[other_to]} - x),
              y_extent(Double2{t.y[to], t.y[other_to]} - y),
              slope(x_extent / y_extent) {}

        /// The first centres at or after the edges, on a line of centres that both cross.
        WholePair first_centres(double row_centre) const {
            // By the slope, which spares a division, is off by 2^-20 texels at most (coordinates are below 2^30); so
            // near a centre the exact place decides, elsewhere both would round to the same texel.
            constexpr double kUnsure = 1.0 / (1 << 16);
            const Double2 below = splat2(row_centre) - y;
            const Double2 quick = x + below * slope - splat2(0.5);
            const Double2 rounded = ceil2(quick);
            const Double2 above = rounded - quick;
            if (!any_lane2((above < splat2(kUnsure)) | (above > splat2(1.0 - kUnsure)))) return whole_to_int(rounded);
            // Multiplied before divided: a crossing that falls exactly on a centre is then exact for edges of small
            // rational slope, so ties go where the top-left rule says.
            return whole_to_int(ceil2(x + below * x_extent / y_extent - splat2(0.5)));
        }
    };

    double middle_y_ = 0.0;
    TexelRange rows_{0, 0};
    EdgePair upper_;
    EdgePair lower_;
};

}  // namespace txc
