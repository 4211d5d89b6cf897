#include "occluder_grid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace txc {
namespace {

constexpr double kHalfSide = RaySpace::kHalfSide;  // texels further out ask the tree
constexpr std::uint32_t kMaxCells = 512;
// Eight occluders to a cell, were each in one cell alone: larger triangles lie in several.
constexpr double kCellsAnOccluder = 0.125;
constexpr std::uint32_t kNoPlace = 0xffffffffu;
// So far beyond an edge, as a share of the box, an occluder still hides. A texel on its triangle's edge may lie beyond it by what
// single precision rounds; where the edge of two occluders lies upon that one, the one on that side has been told apart from the
// triangle, and the other would let light through the crack. (A third of such sights leak with none and with 1e-12; with 2e-7
// texels on edges hide one another where their triangles are seen edge-on.)
constexpr double kEdgeSlack = 2e-8;
constexpr const char* kBudgetName = "a decal's occluders";

// Coordinates in 65,536 steps from one side of the grid to the other; what lies outside is on its rim. Depths are
// counted in the same steps, and all of the volume lies well within. What is apart in steps is apart by a whole step, so
// rounding has no say in it.
constexpr double kStepsAcross = 65535.0;
std::uint16_t step_below(double coordinate) {
    const double step = (coordinate + kHalfSide) * (kStepsAcross / (2 * kHalfSide));
    return static_cast<std::uint16_t>(std::clamp(step, 0.0, kStepsAcross));
}
std::uint16_t step_above(double coordinate) {
    return static_cast<std::uint16_t>(std::min(65535u, step_below(coordinate) + 1u));
}
/// For depths that an occluder's nearest must pass: those beyond the grid stay below its rim.
std::uint16_t step_not_above(double depth) {
    return static_cast<std::uint16_t>(std::min(65534u, std::uint32_t{step_below(depth)}));
}

using UShort8 = std::uint16_t __attribute__((vector_size(16)));
using Short8 = std::int16_t __attribute__((vector_size(16)));

UShort8 load8(const std::uint16_t (&from)[8]) {
    UShort8 values;
    std::memcpy(&values, from, sizeof values);
    return values;
}
UShort8 splat8(std::uint16_t v) { return UShort8{v, v, v, v, v, v, v, v}; }

/// A bit for each lane that is set.
std::uint32_t lane_bits(Short8 mask) {
#if defined(__wasm_simd128__)
    return static_cast<std::uint32_t>(wasm_i16x8_bitmask(reinterpret_cast<v128_t>(mask)));
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= mask[lane] != 0 ? 1u << lane : 0u;
    return bits;
#endif
}

double least_of(const double (&v)[4]) { return std::min(v[0], std::min(v[1], v[2])); }
double greatest_of(const double (&v)[4]) { return std::max(v[0], std::max(v[1], v[2])); }

/// On the left of the triangle's edge from corner `from` on, or all but on it: inside, where corners run counter-clockwise.
bool is_left_of_edge(const double (&x)[4], const double (&y)[4], int from, double at_x, double at_y) {
    const double along_x = x[from + 1] - x[from];
    const double along_y = y[from + 1] - y[from];
    const double slack = kEdgeSlack * (std::fabs(along_x) + std::fabs(along_y));
    return along_x * (at_y - y[from]) - along_y * (at_x - x[from]) >= -slack;
}

using Double2 = double __attribute__((vector_size(16)));
using Mask2 = std::int64_t __attribute__((vector_size(16)));

Double2 load2(const double* from) {
    Double2 values;
    std::memcpy(&values, from, sizeof values);
    return values;
}

Double2 splat2(double value) { return Double2{value, value}; }

bool any_lane(Mask2 mask) {
#if defined(__wasm_simd128__)
    return wasm_v128_any_true(reinterpret_cast<v128_t>(mask));
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

bool all_lanes(Mask2 mask) {
#if defined(__wasm_simd128__)
    return wasm_i64x2_all_true(reinterpret_cast<v128_t>(mask));
#else
    return (mask[0] & mask[1]) != 0;
#endif
}

/// A triangle's edges, two at a time: the first and the second, the third and the first again.
struct EdgePairs {
    Double2 from_x[2], from_y[2], along_x[2], along_y[2];

    template <typename Triangle>
    explicit EdgePairs(const Triangle& t) {
        const Double2 first_x = load2(t.x);
        const Double2 first_y = load2(t.y);
        const Double2 last_x = load2(t.x + 2);
        const Double2 last_y = load2(t.y + 2);
        from_x[0] = first_x;
        from_y[0] = first_y;
        along_x[0] = load2(t.x + 1) - first_x;
        along_y[0] = load2(t.y + 1) - first_y;
        from_x[1] = last_x;
        from_y[1] = last_y;
        along_x[1] = first_x - last_x;
        along_y[1] = first_y - last_y;
    }

    /// True where all corners of `other` lie on the right of one of the edges, or on it. Corners that both triangles
    /// share lie on it exactly. All edges are asked: which of them parts, no processor foresees. (As loops, which the
    /// module's build leaves as they are, a drag over 200,000 triangles takes 1.05 of the time, over 20,000 1.01.)
    template <typename Triangle>
    bool part(const Triangle& other) const {
        const auto on_the_right = [&](int pair, int c) {
            return along_x[pair] * (splat2(other.y[c]) - from_y[pair]) -
                       along_y[pair] * (splat2(other.x[c]) - from_x[pair]) <=
                   splat2(0.0);
        };
        const auto by_pair = [&](int pair) {
            return on_the_right(pair, 0) & on_the_right(pair, 1) & on_the_right(pair, 2);
        };
        return any_lane(by_pair(0) | by_pair(1));
    }
};

/// True where `other` nowhere comes more than `margin` before the triangle, over all of one of them.
template <typename Triangle>
bool is_nowhere_before(const Triangle& other, const Triangle& triangle, double margin) {
    const Double2 depth = splat2(other.depth - triangle.depth);
    const Double2 depth_dx = splat2(other.depth_dx - triangle.depth_dx);
    const Double2 depth_dy = splat2(other.depth_dy - triangle.depth_dy);
    const auto is_within = [&](const Triangle& t, int corner) {
        return depth + depth_dx * load2(t.x + corner) + depth_dy * load2(t.y + corner) <= splat2(margin);
    };
    return all_lanes(is_within(triangle, 0) & is_within(triangle, 2)) ||
           all_lanes(is_within(other, 0) & is_within(other, 2));
}

/// True where a flattened triangle meets the box that the grid covers.
template <typename Triangle>
bool is_in_volume(const Triangle& t) {
    return least_of(t.x) <= kHalfSide && greatest_of(t.x) >= -kHalfSide && least_of(t.y) <= kHalfSide &&
           greatest_of(t.y) >= -kHalfSide && t.farthest <= 0.5 && t.nearest >= -0.5;
}

}  // namespace

TxcStatus OccluderGrid::build() {
    std::vector<std::uint32_t> near;
    tree_.find(space_, near);
    const std::size_t word_count = mesh_.triangles.size() / 32 + 1;
    if (const TxcStatus status = share_.resize(
            near.size() * (sizeof(Occluder) + sizeof(Bounds16) + 4) + word_count * sizeof(PlaceWord), kBudgetName);
        status != TXC_STATUS_OK)
        return status;
    places_.assign(word_count, {0, 0});
    for (const std::uint32_t triangle : near) places_[triangle / 32].listed |= 1u << triangle % 32;
    occluders_.reserve(near.size());
    std::vector<Bounds16> bounds;
    bounds.reserve(near.size());
    for (std::uint32_t w = 0; w < word_count; ++w) {
        PlaceWord& word = places_[w];
        word.first = static_cast<std::uint32_t>(occluders_.size());
        for (std::uint32_t left = word.listed; left != 0; left &= left - 1) {
            const std::uint32_t triangle = w * 32 + static_cast<std::uint32_t>(__builtin_ctz(left));
            Occluder occluder;
            const bool is_flat = flatten(triangle, occluder);
            if (is_flat && is_in_volume(occluder)) {
                occluders_.push_back(occluder);
                bounds.push_back(bounds_of(occluder));
            } else {
                word.listed ^= left & -left;
                if (!is_flat && reaches_behind_eye(triangle)) is_whole_ = false;
            }
        }
    }
    return fill_cells(bounds);
}

OccluderGrid::Bounds16 OccluderGrid::bounds_of(const Occluder& o) {
    return {step_below(least_of(o.x)), step_above(greatest_of(o.x)), step_below(least_of(o.y)),
            step_above(greatest_of(o.y)), step_above(o.nearest)};
}

std::uint32_t OccluderGrid::meeting(const Block& block, const Bounds16& bounds, std::uint16_t beyond) {
    const auto meets = (load8(block.low_x) <= splat8(bounds.high_x)) & (load8(block.high_x) >= splat8(bounds.low_x)) &
                       (load8(block.low_y) <= splat8(bounds.high_y)) & (load8(block.high_y) >= splat8(bounds.low_y)) &
                       (load8(block.nearest) > splat8(beyond));
    return lane_bits(meets);
}

std::uint32_t OccluderGrid::beginning(const Block& block, std::uint16_t column, std::uint16_t row) {
    return lane_bits((load8(block.low_x) >= splat8(column)) & (load8(block.low_y) >= splat8(row)));
}

std::uint32_t OccluderGrid::place_of(std::uint32_t triangle) const {
    const PlaceWord& word = places_[triangle / 32];
    const std::uint32_t bit = 1u << triangle % 32;
    if ((word.listed & bit) == 0) return kNoPlace;
    return word.first + static_cast<std::uint32_t>(__builtin_popcount(word.listed & (bit - 1)));
}

void OccluderGrid::find_corners(std::uint32_t triangle, glm::dvec3 (&out)[3]) const {
    glm::dvec3 points[3];
    for (int c = 0; c < 3; ++c) points[c] = glm::dvec3(mesh_.positions[mesh_.triangles[triangle].vertex[c]]);
    space_.apply(points, out);
}

bool OccluderGrid::reaches_behind_eye(std::uint32_t triangle) const {
    glm::dvec3 corner[3];
    find_corners(triangle, corner);
    int behind = 0;
    for (const glm::dvec3& c : corner) behind += std::isinf(c.x) ? 1 : 0;
    return behind == 1 || behind == 2;
}

bool OccluderGrid::flatten(std::uint32_t triangle, Occluder& out) const {
    glm::dvec3 corner[3];
    find_corners(triangle, corner);
    const glm::dvec3 low = glm::min(corner[0], glm::min(corner[1], corner[2]));
    const glm::dvec3 high = glm::max(corner[0], glm::max(corner[1], corner[2]));
    const glm::dvec3 ab = corner[1] - corner[0];
    const glm::dvec3 ac = corner[2] - corner[0];
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0.0 || std::isinf(high.x)) return false;  // seen edge-on: a ray passes it by; or from behind the eye
    out.depth_dx = (ab.z * ac.y - ac.z * ab.y) / area;
    out.depth_dy = (ac.z * ab.x - ab.z * ac.x) / area;
    out.depth = corner[0].z - out.depth_dx * corner[0].x - out.depth_dy * corner[0].y;
    out.nearest = high.z;
    out.farthest = low.z;
    out.triangle = triangle;
    for (int c = 0; c < 3; ++c) {
        // Counter-clockwise, so that inside is on the left of every edge.
        const int from = area > 0.0 ? c : 2 - c;
        out.x[c] = corner[from].x;
        out.y[c] = corner[from].y;
    }
    out.x[3] = out.x[0];
    out.y[3] = out.y[0];
    return true;
}

TxcStatus OccluderGrid::fill_cells(const std::vector<Bounds16>& bounds) {
    const auto count = static_cast<std::uint32_t>(bounds.size());
    cells_ =
        std::clamp(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count) * kCellsAnOccluder)), 1u, kMaxCells);
    // Triangles that each cover much of the picture would fill every cell: coarser cells hold them as well.
    for (; cells_ > 1; cells_ /= 2) {
        std::uint64_t entries = 0;
        for (const Bounds16& b : bounds) {
            entries += static_cast<std::uint64_t>(cell_of(b.high_x) - cell_of(b.low_x) + 1) *
                       (cell_of(b.high_y) - cell_of(b.low_y) + 1);
        }
        if (entries <= count * 16ull + 1024) break;
    }
    const auto for_each_cell = [this](const Bounds16& b, auto&& visit) {
        const std::uint32_t x0 = cell_of(b.low_x);
        const std::uint32_t x1 = cell_of(b.high_x);
        const std::uint32_t y1 = cell_of(b.high_y);
        for (std::uint32_t y = cell_of(b.low_y); y <= y1; ++y) {
            for (std::uint32_t x = x0; x <= x1; ++x) visit(y * cells_ + x);
        }
    };
    std::vector<std::uint32_t> filled(static_cast<std::size_t>(cells_) * cells_, 0);
    for (const Bounds16& b : bounds) {
        for_each_cell(b, [&](std::uint32_t cell) { ++filled[cell]; });
    }
    cell_start_.resize(filled.size() + 1);
    std::uint32_t block_count = 0;
    for (std::size_t cell = 0; cell < filled.size(); ++cell) {
        cell_start_[cell] = block_count;
        block_count += (filled[cell] + 7) / 8;
        filled[cell] = 0;
    }
    cell_start_.back() = block_count;
    if (const TxcStatus status = share_.resize(
            share_.bytes() + std::uint64_t{block_count} * sizeof(Block) + 2 * filled.size() * 4, kBudgetName);
        status != TXC_STATUS_OK)
        return status;
    blocks_.resize(block_count);
    for (std::uint32_t o = 0; o < count; ++o) {
        const Bounds16 b = bounds[o];
        for_each_cell(b, [&](std::uint32_t cell) {
            const std::uint32_t entry = filled[cell]++;
            Block& block = blocks_[cell_start_[cell] + entry / 8];
            const std::uint32_t lane = entry % 8;
            block.low_x[lane] = b.low_x;
            block.high_x[lane] = b.high_x;
            block.low_y[lane] = b.low_y;
            block.high_y[lane] = b.high_y;
            block.nearest[lane] = b.nearest;
            block.place[lane] = o;
        });
    }
    return TXC_STATUS_OK;
}

bool OccluderGrid::lies_in_grid(const glm::dvec3& q) const {
    return std::fabs(q.x) <= kHalfSide && std::fabs(q.y) <= kHalfSide;
}

bool OccluderGrid::is_before(const Occluder& o, const glm::dvec3& q, double least) const {
    const double depth = o.depth + o.depth_dx * q.x + o.depth_dy * q.y;
    if (!(depth > least && depth <= 0.5)) return false;
    for (int from = 0; from < 3; ++from) {
        if (!is_left_of_edge(o.x, o.y, from, q.x, q.y)) return false;
    }
    return true;
}

bool OccluderGrid::hides(const Occluder& o, const glm::dvec3& q, double least) const {
    if (!is_before(o, q, least)) return false;
    if (!space_.has_eye()) return true;
    return o.depth + o.depth_dx * q.x + o.depth_dy * q.y > q.z + space_.lift(q, tree_.least_distance());
}

bool OccluderGrid::is_blocked(const glm::dvec3& point, std::uint32_t own) const {
    const glm::dvec3 q = space_.apply(point);
    if (!lies_in_grid(q)) {
        const TexelRay ray = space_.ray_from(point, q, own);
        return ray.length > 0.0 && tree_.is_blocked(ray);
    }
    const double least = least_depth(q);
    const Bounds16 at = {step_below(q.x), step_above(q.x), step_below(q.y), step_above(q.y), 0};
    const std::uint16_t beyond = step_not_above(least);
    const std::uint32_t cell = cell_of(at.low_y) * cells_ + cell_of(at.low_x);
    for (std::uint32_t block = cell_start_[cell]; block < cell_start_[cell + 1]; ++block) {
        for (std::uint32_t left = meeting(blocks_[block], at, beyond); left != 0; left &= left - 1) {
            const Occluder& o = occluders_[blocks_[block].place[__builtin_ctz(left)]];
            if (o.nearest > least && o.triangle != own && hides(o, q, least)) return true;
        }
    }
    return false;
}

bool OccluderGrid::is_blocked_by(std::vector<std::uint32_t>& blockers, const glm::dvec3& point,
                                 std::uint32_t own) const {
    const glm::dvec3 q = space_.apply(point);
    if (!lies_in_grid(q)) return is_blocked(point, own);
    const double least = least_depth(q);
    for (std::uint32_t& place : blockers) {
        if (!hides(occluders_[place], q, least)) continue;
        std::swap(place, blockers.front());
        return true;
    }
    return false;
}

bool OccluderGrid::find_blockers(std::uint32_t own, std::vector<std::uint32_t>& out) {
    out.clear();
    Occluder triangle;
    const std::uint32_t own_place = place_of(own);
    if (own_place != kNoPlace) {
        triangle = occluders_[own_place];
    } else if (!flatten(own, triangle)) {
        return false;
    }
    const double margin = space_.least_lift(triangle.x, triangle.y, triangle.farthest, tree_.least_distance());
    const double least = triangle.farthest + margin;
    const EdgePairs edges(triangle);
    const Bounds16 bounds = bounds_of(triangle);
    const std::uint16_t beyond = step_not_above(least);
    const std::uint32_t x0 = cell_of(bounds.low_x);
    const std::uint32_t x1 = cell_of(bounds.high_x);
    const std::uint32_t y0 = cell_of(bounds.low_y);
    const std::uint32_t y1 = cell_of(bounds.high_y);
    for (std::uint32_t y = y0; y <= y1; ++y) {
        for (std::uint32_t x = x0; x <= x1; ++x) {
            // What lies in several of these cells is looked at in the first.
            const std::uint16_t column = x == x0 ? 0 : first_step_of(x);
            const std::uint16_t row = y == y0 ? 0 : first_step_of(y);
            const std::uint32_t cell = y * cells_ + x;
            for (std::uint32_t b = cell_start_[cell]; b != cell_start_[cell + 1]; ++b) {
                const Block& block = blocks_[b];
                std::uint32_t left = meeting(block, bounds, beyond) & beginning(block, column, row);
                for (; left != 0; left &= left - 1) {
                    const std::uint32_t place = block.place[__builtin_ctz(left)];
                    const Occluder& other = occluders_[place];
                    if (place == own_place || edges.part(other) || other.nearest <= least ||
                        is_nowhere_before(other, triangle, margin) || EdgePairs(other).part(triangle))
                        continue;
                    out.push_back(place);
                }
            }
        }
    }
    return true;
}

}  // namespace txc
