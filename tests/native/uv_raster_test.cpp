// Which texels a triangle owns in texture space (spec section 2, the top-left rule).
#include "uv_raster.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"
#include "support/test_session.h"

namespace {

using support::Random;
using txc::TexelTriangle;

struct Point {
    double x, y;
};

/// How many of the triangles own each texel of a size x size square.
class Claims {
public:
    explicit Claims(std::int64_t size) : size_(size), counts_(static_cast<std::size_t>(size * size)) {}

    void add(const TexelTriangle& triangle) {
        const txc::TriangleRaster raster(triangle);
        for (std::int32_t row = raster.rows().first; row < raster.rows().last; ++row) {
            const txc::TexelRange span = raster.span(row);
            for (std::int64_t x = span.first; x < span.last; ++x) {
                if (x < 0 || x >= size_ || row < 0 || row >= size_)
                    ++outside_;
                else
                    ++counts_[static_cast<std::size_t>(row * size_ + x)];
            }
        }
    }
    /// In one of the six orders of its corners: windings and first corners must make no difference.
    void add(Point a, Point b, Point c, Random& random) {
        Point corners[3] = {a, b, c};
        for (int i = 2; i > 0; --i) std::swap(corners[i], corners[random.below(static_cast<std::uint32_t>(i) + 1)]);
        add({{corners[0].x, corners[1].x, corners[2].x}, {corners[0].y, corners[1].y, corners[2].y}});
    }
    std::uint32_t at(std::int64_t x, std::int64_t y) const { return counts_[static_cast<std::size_t>(y * size_ + x)]; }
    std::uint32_t total() const {
        std::uint32_t sum = 0;
        for (const std::uint32_t count : counts_) sum += count;
        return sum;
    }
    bool each_once() const {
        return outside_ == 0 && std::all_of(counts_.begin(), counts_.end(), [](std::uint32_t c) { return c == 1; });
    }

private:
    std::int64_t size_;
    std::vector<std::uint32_t> counts_;
    std::uint32_t outside_ = 0;
};

/// Places in [0, size], on multiples of `grain` where that is above 0: with 1/2 many fall exactly on texel centres.
double draw_place(Random& random, double low, double high, double grain) {
    const double place = random.between(low, high);
    return grain > 0.0 ? std::floor(place / grain + 0.5) * grain : place;
}

constexpr double kGrains[] = {0.0, 0.5, 0.25, 1.0};

}  // namespace

TEST_CASE("A random fan over a square covers each of its texels once") {
    Random random(1);
    for (int round = 0; round < 400; ++round) {
        const auto size = static_cast<std::int64_t>(4 + random.below(29));
        const auto side = static_cast<double>(size);
        const double grain = kGrains[random.below(4)];
        std::vector<Point> rim;
        // Once round the border, corners included, in order.
        for (int edge = 0; edge < 4; ++edge) {
            std::vector<double> steps{0.0};
            for (std::uint32_t i = random.below(5); i > 0; --i) steps.push_back(draw_place(random, 0.0, side, grain));
            std::sort(steps.begin(), steps.end());
            for (const double s : steps) {
                rim.push_back(edge == 0   ? Point{s, 0.0}
                              : edge == 1 ? Point{side, s}
                              : edge == 2 ? Point{side - s, side}
                                          : Point{0.0, side - s});
            }
        }
        const Point hub{draw_place(random, 0.0, side, grain), draw_place(random, 0.0, side, grain)};
        Claims claims(size);
        for (std::size_t i = 0; i < rim.size(); ++i) claims.add(hub, rim[i], rim[(i + 1) % rim.size()], random);
        CAPTURE(round);
        REQUIRE(claims.each_once());
    }
}

TEST_CASE("A random grid with diagonals either way covers each texel once") {
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        const std::uint32_t cells = 1 + random.below(8);
        const auto size = static_cast<std::int64_t>(8 + random.below(40));
        const double step = static_cast<double>(size) / cells;
        const double grain = kGrains[random.below(4)];
        std::vector<Point> vertices;
        for (std::uint32_t row = 0; row <= cells; ++row) {
            for (std::uint32_t column = 0; column <= cells; ++column) {
                Point p{column * step, row * step};
                // At most a quarter of a cell: its quadrangle stays convex enough for either diagonal.
                const bool inner_x = column > 0 && column < cells;
                const bool inner_y = row > 0 && row < cells;
                if (inner_x) p.x = draw_place(random, p.x - step * 0.2, p.x + step * 0.2, step > 8.0 ? grain : 0.0);
                if (inner_y) p.y = draw_place(random, p.y - step * 0.2, p.y + step * 0.2, step > 8.0 ? grain : 0.0);
                if (column == cells) p.x = static_cast<double>(size);
                if (row == cells) p.y = static_cast<double>(size);
                vertices.push_back(p);
            }
        }
        Claims claims(size);
        for (std::uint32_t row = 0; row < cells; ++row) {
            for (std::uint32_t column = 0; column < cells; ++column) {
                const Point a = vertices[row * (cells + 1) + column];
                const Point b = vertices[row * (cells + 1) + column + 1];
                const Point c = vertices[(row + 1) * (cells + 1) + column + 1];
                const Point d = vertices[(row + 1) * (cells + 1) + column];
                if (random.coin()) {
                    claims.add(a, b, c, random);
                    claims.add(a, c, d, random);
                } else {
                    claims.add(a, b, d, random);
                    claims.add(b, c, d, random);
                }
            }
        }
        CAPTURE(round);
        REQUIRE(claims.each_once());
    }
}

TEST_CASE("A walk down a triangle finds the spans that its rows have, on textures of any size") {
    Random random(3);
    for (int round = 0; round < 3000; ++round) {
        const double side = static_cast<double>(1u << (2 + random.below(13)));
        const double grain = kGrains[random.below(4)];
        // Slivers too: from a narrow band, steep or flat.
        const double width = random.coin() ? side : std::min(side, random.between(1e-4, 2.0));
        const double height = random.coin() ? side : std::min(side, random.between(1e-4, 2.0));
        TexelTriangle triangle{};
        for (int corner = 0; corner < 3; ++corner) {
            triangle.x[corner] = draw_place(random, 0.0, width, grain);
            triangle.y[corner] = draw_place(random, 0.0, height, grain);
        }
        const txc::TriangleRaster raster(triangle);
        CAPTURE(round);
        for (std::int32_t row = raster.rows().first; row < raster.rows().last;) {
            const std::int32_t end = raster.part_end(row);
            REQUIRE(end > row);
            txc::SpanWalk walk(raster, row);
            for (; row < end; ++row) {
                const txc::TexelRange found = walk.next();
                const txc::TexelRange span = raster.span(row);
                REQUIRE(found.first == span.first);
                REQUIRE(found.last == span.last);
            }
        }
    }
}

TEST_CASE("Edges through texel centres belong to the triangle on their right or below them") {
    // Legs on centre lines at the top and left, hypotenuse through centres: top and left own theirs, it does not.
    Claims upper(6);
    upper.add(TexelTriangle{{0.5, 4.5, 0.5}, {0.5, 0.5, 4.5}});
    for (std::int64_t y = 0; y < 6; ++y) {
        for (std::int64_t x = 0; x < 6; ++x) CHECK(upper.at(x, y) == (x + y < 4 ? 1u : 0u));
    }
    // The other half of that square: its left edge is the hypotenuse, its right and bottom edges own nothing.
    Claims lower(6);
    lower.add(TexelTriangle{{4.5, 4.5, 0.5}, {0.5, 4.5, 4.5}});
    for (std::int64_t y = 0; y < 6; ++y) {
        for (std::int64_t x = 0; x < 6; ++x) CHECK(lower.at(x, y) == (x < 4 && y < 4 && x + y >= 4 ? 1u : 0u));
    }
}

TEST_CASE("A diagonal through texel centres belongs to the triangle on its right whatever decimals its corners have") {
    for (const std::int64_t size : {77, 100, 333, 1000}) {
        for (const auto& side : {std::pair{0.05f, 0.95f}, {0.1f, 0.9f}, {0.2f, 0.6f}, {0.15f, 0.85f}}) {
            const double from = static_cast<double>(side.first) * static_cast<double>(size);
            const double to = static_cast<double>(side.second) * static_cast<double>(size);
            Claims right(size);
            Claims left(size);
            right.add(TexelTriangle{{from, to, to}, {from, from, to}});
            left.add(TexelTriangle{{from, to, from}, {from, to, to}});
            CAPTURE(size);
            CAPTURE(side.first);
            for (std::int64_t i = 0; i < size; ++i) {
                const double centre = static_cast<double>(i) + 0.5;
                REQUIRE(right.at(i, i) == (centre > from && centre < to ? 1u : 0u));
                REQUIRE(left.at(i, i) == 0u);
            }
        }
    }
}

TEST_CASE("A square whose border lies on centres owns its top and left rows alone") {
    Claims claims(8);
    claims.add(TexelTriangle{{1.5, 5.5, 5.5}, {1.5, 1.5, 5.5}});
    claims.add(TexelTriangle{{1.5, 5.5, 1.5}, {1.5, 5.5, 5.5}});
    for (std::int64_t y = 0; y < 8; ++y) {
        for (std::int64_t x = 0; x < 8; ++x) CHECK(claims.at(x, y) == (x >= 1 && x < 5 && y >= 1 && y < 5 ? 1u : 0u));
    }
}

TEST_CASE("Triangles without area own nothing") {
    const TexelTriangle lines[] = {
        {{2.5, 2.5, 2.5}, {2.5, 2.5, 2.5}},   // a point on a centre
        {{0.0, 4.0, 8.0}, {2.5, 2.5, 2.5}},   // along a row of centres
        {{3.5, 3.5, 3.5}, {0.0, 7.0, 2.0}},   // down a column of centres
        {{0.5, 4.5, 2.5}, {0.5, 4.5, 2.5}},   // through centres aslant
        {{1.0, 7.0, 1.0}, {1.25, 6.5, 1.25}}  // there and back
    };
    for (const TexelTriangle& line : lines) {
        Claims claims(8);
        claims.add(line);
        CHECK(line.doubled_area() == 0.0);
        CHECK(claims.total() == 0);
    }
}

TEST_CASE("A triangle between the centres owns no texel") {
    Claims claims(4);
    claims.add(TexelTriangle{{1.6, 2.4, 2.0}, {1.6, 1.7, 2.4}});
    CHECK(claims.total() == 0);
}

TEST_CASE("A needle between two far corners leaves no hole beside its neighbours") {
    // Three slivers that share long edges, in a square of four triangles more.
    Random random(3);
    for (int round = 0; round < 100; ++round) {
        const Point a{0.0, 0.0};
        const Point b{64.0, 64.0};
        const Point near{random.between(31.0, 33.0), random.between(31.0, 33.0)};
        Claims claims(64);
        claims.add(a, near, {64.0, 0.0}, random);
        claims.add(near, b, {64.0, 0.0}, random);
        claims.add(a, near, {0.0, 64.0}, random);
        claims.add(near, b, {0.0, 64.0}, random);
        CAPTURE(near.x);
        CAPTURE(near.y);
        REQUIRE(claims.each_once());
    }
}

TEST_CASE("A chart that leaves the texture comes in again at the other side") {
    for (const auto& shift : {std::pair{0.5, 0.25}, {-0.75, 0.0}, {0.0, 3.125}, {-7.5, -2.5}, {100.25, 31.75}}) {
        CAPTURE(shift.first);
        CAPTURE(shift.second);
        support::TestSession session(
            support::make_plane(1.0, 0.0, {shift.first, shift.second, shift.first + 1.0, shift.second + 1.0}));
        const TxcMapInfo info = session.map_info(session.target(64, 48));
        CHECK(info.covered_texels == 64 * 48);
        CHECK(info.overlapping_texels == 0);
        CHECK(info.gutter_texels == 0);
    }
}

TEST_CASE("Whole repeats of the texture change nothing") {
    support::TestSession here(support::make_sphere(1.0, 16, 8));
    support::TestSession there(support::make_sphere(1.0, 16, 8, {3.0, -2.0, 4.0, -1.0}));
    const support::MapArrays expected = here.map(here.target(64, 64));
    const support::MapArrays actual = there.map(there.target(64, 64));
    CHECK(expected.coverage == actual.coverage);
    CHECK(expected.overlap == actual.overlap);
    float worst = 0.0f;
    for (std::size_t i = 0; i < expected.positions.size(); ++i)
        worst = std::max(worst, std::fabs(expected.positions[i] - actual.positions[i]));
    CHECK(worst < 1e-6f);
}
