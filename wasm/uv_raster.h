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

/// First integers whose centres (+ 1/2) are at or after the coordinates.
inline WholePair first_centres_from(Double2 coordinates) { return whole_to_int(ceil2(coordinates - splat2(0.5))); }

/// Two of a triangle's edges that cross the same rows: the long one and one of the others. Each from its upper end.
struct EdgePair {
    Double2 x{};
    Double2 y{};
    Double2 x_extent{};
    Double2 y_extent{};

    /// The first centres at or after the edges, on a row that both cross. Rounding can put a crossing that falls exactly on a
    /// centre to either side of it (in a square from 0.05 to 0.95, cut in two, at 333 x 333): the products tell which.
    WholePair first_centres(std::int32_t row) const {
        const Double2 below = splat2(static_cast<double>(row) + 0.5) - y;
        const Double2 nearest = floor2(x + below * x_extent / y_extent);
        const Double2 to_nearest = nearest + splat2(0.5) - x;
        const Long2 is_before = product_difference2(to_nearest, y_extent, below, x_extent) < splat2(0.0);
        const WholePair centres = whole_to_int(nearest);
        return {centres.first - static_cast<std::int32_t>(is_before[0]),
                centres.second - static_cast<std::int32_t>(is_before[1])};
    }
};

inline TexelRange range_between(WholePair ends) {
    // Without a branch, which small triangles would take at random.
    const std::int32_t difference = ends.first - ends.second;
    const std::int32_t excess = difference & difference >> 31;
    return {ends.second + excess, ends.first - excess};
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
        const WholePair rows = first_centres_from(Double2{t.y[top], t.y[bottom]});
        rows_ = {rows.first, rows.second};
        middle_row_ = first_centres_from(splat2(t.y[middle])).first;
        top_ = Double2{t.x[top], t.y[top]};
        middle_ = Double2{t.x[middle], t.y[middle]};
        bottom_ = Double2{t.x[bottom], t.y[bottom]};
    }

    /// The rows whose centres can lie inside.
    TexelRange rows() const { return rows_; }

    /// After the last of rows() that cross the same edges as this one. Half open on rows too: an edge owns the centre
    /// lines from its upper end up to, not with, its lower end.
    std::int32_t part_end(std::int32_t row) const { return row < middle_row_ ? middle_row_ : rows_.last; }

    EdgePair edges(std::int32_t row) const {
        const bool is_upper = row < middle_row_;
        const Double2 from = is_upper ? top_ : middle_;
        const Double2 to = is_upper ? middle_ : bottom_;
        const Double2 x = {top_[0], from[0]};
        const Double2 y = {top_[1], from[1]};
        return {x, y, Double2{bottom_[0], to[0]} - x, Double2{bottom_[1], to[1]} - y};
    }

    /// The texels of one of rows() whose centres lie inside.
    TexelRange span(std::int32_t row) const { return range_between(edges(row).first_centres(row)); }

private:
    TexelRange rows_{0, 0};
    std::int32_t middle_row_ = 0;
    Double2 top_{};  // x and y
    Double2 middle_{};
    Double2 bottom_{};
};

/// The same spans, one after the other, of a triangle whose coordinates lie between 0 and 2^15.
///
/// Places go from row to row by the slopes, in fixed point: off by less than 2^-18 texels after as many rows. So near a
/// centre the exact place decides; elsewhere both would round to the same texel.
class SpanWalk {
public:
    /// At one of the triangle's rows, and good up to, not with, part_end(row).
    SpanWalk(const TriangleRaster& triangle, std::int32_t row) : edges_(triangle.edges(row)), row_(row) {
        const Double2 slope = edges_.x_extent / edges_.y_extent;
        const Double2 below = splat2(static_cast<double>(row) + 0.5) - edges_.y;
        // A slope too large for fixed point belongs to an edge that crosses but this row.
        const Fixed2 slopes = to_fixed(slope);
        const Fixed2 places = to_fixed(edges_.x + below * slope + splat2(0.5));
        long_slope_ = slopes.first;
        slope_ = slopes.second;
        long_place_ = places.first;
        place_ = places.second;
    }

    TexelRange next() {
        constexpr std::uint32_t kUnsure = 1u << 16;
        const std::uint64_t a = long_place_;
        const std::uint64_t b = place_;
        long_place_ += long_slope_;
        place_ += slope_;
        const std::int32_t row = row_++;
        const bool is_unsure = (static_cast<std::uint32_t>(a) + kUnsure < 2 * kUnsure) |
                               (static_cast<std::uint32_t>(b) + kUnsure < 2 * kUnsure);
        if (is_unsure) return range_between(edges_.first_centres(row));
        return range_between({static_cast<std::int32_t>(a >> 32), static_cast<std::int32_t>(b >> 32)});
    }

private:
    struct Fixed2 {
        std::uint64_t first;
        std::uint64_t second;
    };

    /// Times 2^32, of values below 2^19 either way: with 1.5 * 2^20 added they stand in the doubles' lowest bits.
    static Fixed2 to_fixed(Double2 values) {
        const Long2 bits = reinterpret_cast<Long2>(values + splat2(1572864.0));
        constexpr std::uint64_t kZero = 0x4138000000000000u;
        return {static_cast<std::uint64_t>(bits[0]) - kZero, static_cast<std::uint64_t>(bits[1]) - kZero};
    }

    EdgePair edges_;
    std::uint64_t long_place_;  // half a texel on: outside the doubt, the whole part is the first centre at or after
    std::uint64_t long_slope_;
    std::uint64_t place_;
    std::uint64_t slope_;
    std::int32_t row_;
};

}  // namespace txc
