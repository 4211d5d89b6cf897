// Triangle coverage in texture space: which texels have their centre inside a triangle (spec section 2, top-left rule).
//
// Each edge crosses a row of centres at one place, computed from its endpoints in a fixed order, so the two triangles
// that share the edge get the same number to the last bit; spans are half open on it. Every texel under a shared edge
// or vertex therefore belongs to exactly one triangle, whatever the rounding.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

namespace txc {

/// A triangle's corners in texels: x = u * width, y = v * height. Not wrapped.
struct TexelTriangle {
    double x[3];
    double y[3];

    /// Twice the signed area; 0 for a triangle that owns no texel.
    double doubled_area() const { return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]); }
};

/// The rows [first, last) whose centres can lie inside.
struct RowRange {
    std::int64_t first;
    std::int64_t last;
};

/// First integer whose centre (+ 1/2) is at or after `coordinate`.
inline std::int64_t first_centre_from(double coordinate) {
    return static_cast<std::int64_t>(std::ceil(coordinate - 0.5));
}

inline RowRange raster_rows(const TexelTriangle& t) {
    const double top = std::fmin(t.y[0], std::fmin(t.y[1], t.y[2]));
    const double bottom = std::fmax(t.y[0], std::fmax(t.y[1], t.y[2]));
    return {first_centre_from(top), first_centre_from(bottom)};
}

/// Where the edge from corner a to corner b crosses a row's centre line. The upper end comes first (the left one where
/// they are level), so the result does not hang on the direction in which a triangle names its edge.
inline double edge_crossing(const TexelTriangle& t, int a, int b, double row_centre) {
    if (t.y[a] > t.y[b] || (t.y[a] == t.y[b] && t.x[a] > t.x[b])) std::swap(a, b);
    // Multiplied before divided: a crossing that falls exactly on a texel centre is then exact for edges of small
    // rational slope, so ties go where the top-left rule says.
    return t.x[a] + (row_centre - t.y[a]) * (t.x[b] - t.x[a]) / (t.y[b] - t.y[a]);
}

/// The texels [first, last) of a row whose centres lie inside. Empty where first >= last.
inline RowRange raster_span(const TexelTriangle& t, std::int64_t row) {
    const double centre = static_cast<double>(row) + 0.5;
    double left = 0.0;
    double right = 0.0;
    int crossings = 0;
    for (int a = 0; a < 3; ++a) {
        const int b = a == 2 ? 0 : a + 1;
        // Half open on rows too: an edge owns the centre lines from its upper end up to, not with, its lower end.
        const bool crosses = (t.y[a] <= centre) != (t.y[b] <= centre);
        if (!crosses) continue;
        const double x = edge_crossing(t, a, b, centre);
        if (crossings == 0) left = right = x;
        left = std::fmin(left, x);
        right = std::fmax(right, x);
        ++crossings;
    }
    if (crossings < 2) return {0, 0};
    return {first_centre_from(left), first_centre_from(right)};
}

}  // namespace txc
