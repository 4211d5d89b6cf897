#include "occluder_grid.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

// Texels whose centre lies a little outside the picture still take paint (their footprint reaches in). The grid covers
// that much more on each side; texels further out ask the tree.
constexpr double kHalfSide = 0.5625;
constexpr std::uint32_t kMaxCells = 512;

double least_of(const double (&v)[3]) { return std::min(v[0], std::min(v[1], v[2])); }
double greatest_of(const double (&v)[3]) { return std::max(v[0], std::max(v[1], v[2])); }

/// Above 0 on the left of the triangle's edge from corner `from` on: inside, where corners run counter-clockwise.
double left_of_edge(const double (&x)[3], const double (&y)[3], int from, double at_x, double at_y) {
    const int to = from == 2 ? 0 : from + 1;
    return (x[to] - x[from]) * (at_y - y[from]) - (y[to] - y[from]) * (at_x - x[from]);
}

/// True where all corners of `other` lie on the right of one of the triangle's edges, or on it. Corners that both
/// triangles share lie on it exactly.
template <typename Triangle>
bool has_parting_edge(const Triangle& triangle, const Triangle& other) {
    for (int from = 0; from < 3; ++from) {
        bool parts = true;
        for (int corner = 0; corner < 3 && parts; ++corner) {
            parts = left_of_edge(triangle.x, triangle.y, from, other.x[corner], other.y[corner]) <= 0.0;
        }
        if (parts) return true;
    }
    return false;
}

/// True where two triangles do not overlap in the plane.
template <typename Triangle>
bool lie_apart(const Triangle& a, const Triangle& b) {
    return has_parting_edge(a, b) || has_parting_edge(b, a);
}

/// True where `other` nowhere comes more than `margin` before the triangle, over all of one of them.
template <typename Triangle>
bool is_nowhere_before(const Triangle& other, const Triangle& triangle, double margin) {
    const double depth = other.depth - triangle.depth;
    const double depth_dx = other.depth_dx - triangle.depth_dx;
    const double depth_dy = other.depth_dy - triangle.depth_dy;
    const auto most_over = [&](const Triangle& t) {
        double most = depth + depth_dx * t.x[0] + depth_dy * t.y[0];
        for (int c = 1; c < 3; ++c) most = std::max(most, depth + depth_dx * t.x[c] + depth_dy * t.y[c]);
        return most;
    };
    return most_over(triangle) <= margin || most_over(other) <= margin;
}

/// True where a flattened triangle meets the box that the grid covers.
template <typename Triangle>
bool is_in_volume(const Triangle& t) {
    return least_of(t.x) <= kHalfSide && greatest_of(t.x) >= -kHalfSide && least_of(t.y) <= kHalfSide &&
           greatest_of(t.y) >= -kHalfSide && t.farthest <= 0.5 && t.nearest >= -0.5;
}

}  // namespace

TxcStatus OccluderGrid::build() {
    ModelToDecal volume = projector_.to_decal;
    volume.reach = glm::dvec3(kHalfSide, kHalfSide, 0.5);
    std::vector<std::uint32_t> near;
    tree_.find(volume, near);
    if (const TxcStatus status =
            share_.resize(near.size() * (sizeof(Occluder) + 17 * sizeof(std::uint32_t)), "a decal's occluders");
        status != TXC_STATUS_OK)
        return status;
    occluders_.reserve(near.size());
    for (const std::uint32_t triangle : near) {
        Occluder occluder;
        if (flatten(triangle, occluder) && is_in_volume(occluder)) occluders_.push_back(occluder);
    }
    // About two occluders a cell where they are evenly spread.
    cells_ =
        std::clamp(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(occluders_.size()) * 0.5)), 1u, kMaxCells);
    fill_cells();
    return TXC_STATUS_OK;
}

bool OccluderGrid::flatten(std::uint32_t triangle, Occluder& out) const {
    glm::dvec3 corner[3];
    for (int c = 0; c < 3; ++c)
        corner[c] = projector_.to_decal.apply(glm::dvec3(mesh_.positions[mesh_.triangles[triangle].vertex[c]]));
    const glm::dvec3 low = glm::min(corner[0], glm::min(corner[1], corner[2]));
    const glm::dvec3 high = glm::max(corner[0], glm::max(corner[1], corner[2]));
    const glm::dvec3 ab = corner[1] - corner[0];
    const glm::dvec3 ac = corner[2] - corner[0];
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0.0) return false;  // seen edge-on: a ray passes it by
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
    return true;
}

std::uint32_t OccluderGrid::cell_of(double coordinate) const {
    const double cell = (coordinate + kHalfSide) * (cells_ / (2 * kHalfSide));
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, static_cast<double>(cells_ - 1)));
}

void OccluderGrid::fill_cells() {
    const auto for_each_cell = [this](const Occluder& o, auto&& visit) {
        const std::uint32_t x0 = cell_of(least_of(o.x));
        const std::uint32_t x1 = cell_of(greatest_of(o.x));
        const std::uint32_t y0 = cell_of(least_of(o.y));
        const std::uint32_t y1 = cell_of(greatest_of(o.y));
        for (std::uint32_t y = y0; y <= y1; ++y) {
            for (std::uint32_t x = x0; x <= x1; ++x) visit(y * cells_ + x);
        }
    };
    for (;;) {
        cell_start_.assign(static_cast<std::size_t>(cells_) * cells_ + 1, 0);
        std::uint64_t entries = 0;
        for (const Occluder& occluder : occluders_) {
            for_each_cell(occluder, [&](std::uint32_t cell) {
                ++cell_start_[cell + 1];
                ++entries;
            });
        }
        // Triangles that each cover much of the picture would fill every cell: coarser cells hold them as well.
        if (entries <= occluders_.size() * 16 + 1024 || cells_ == 1) break;
        cells_ /= 2;
    }
    cell_nearest_.assign(static_cast<std::size_t>(cells_) * cells_, -1.0);
    for (const Occluder& occluder : occluders_) {
        for_each_cell(occluder, [&](std::uint32_t cell) {
            cell_nearest_[cell] = std::max(cell_nearest_[cell], occluder.nearest);
        });
    }
    for (std::size_t cell = 1; cell < cell_start_.size(); ++cell) cell_start_[cell] += cell_start_[cell - 1];
    cell_occluders_.resize(cell_start_.back());
    std::vector<std::uint32_t> next(cell_start_.begin(), cell_start_.end() - 1);
    for (std::uint32_t o = 0; o < occluders_.size(); ++o) {
        for_each_cell(occluders_[o], [&](std::uint32_t cell) { cell_occluders_[next[cell]++] = o; });
    }
}

bool OccluderGrid::lies_in_grid(const glm::dvec3& q) const {
    return std::fabs(q.x) <= kHalfSide && std::fabs(q.y) <= kHalfSide;
}

bool OccluderGrid::is_before(const Occluder& o, const glm::dvec3& q, double least) const {
    const double depth = o.depth + o.depth_dx * q.x + o.depth_dy * q.y;
    if (!(depth > least && depth <= 0.5)) return false;
    for (int from = 0; from < 3; ++from) {
        if (left_of_edge(o.x, o.y, from, q.x, q.y) < 0.0) return false;
    }
    return true;
}

bool OccluderGrid::is_blocked(const glm::dvec3& point, std::uint32_t own) const {
    const glm::dvec3 q = projector_.to_decal.apply(point);
    if (!lies_in_grid(q))
        return tree_.is_blocked(point, projector_.towards_viewer, (0.5 - q.z) * projector_.depth, own);
    const double least = least_depth(q);
    const std::uint32_t cell = cell_of(q.y) * cells_ + cell_of(q.x);
    if (cell_nearest_[cell] <= least) return false;
    for (std::uint32_t i = cell_start_[cell]; i < cell_start_[cell + 1]; ++i) {
        const Occluder& o = occluders_[cell_occluders_[i]];
        if (o.nearest > least && o.triangle != own && is_before(o, q, least)) return true;
    }
    return false;
}

bool OccluderGrid::is_blocked_by(const std::vector<std::uint32_t>& blockers, const glm::dvec3& point,
                                 std::uint32_t own) const {
    const glm::dvec3 q = projector_.to_decal.apply(point);
    if (!lies_in_grid(q)) return is_blocked(point, own);
    const double least = least_depth(q);
    for (const std::uint32_t place : blockers) {
        if (is_before(occluders_[place], q, least)) return true;
    }
    return false;
}

bool OccluderGrid::find_blockers(std::uint32_t own, std::vector<std::uint32_t>& out) {
    out.clear();
    Occluder triangle;
    if (!flatten(own, triangle)) return false;
    seen_by_.resize(occluders_.size(), 0);
    ++question_;
    const double margin = tree_.least_distance() / projector_.depth;
    const std::uint32_t x0 = cell_of(least_of(triangle.x));
    const std::uint32_t x1 = cell_of(greatest_of(triangle.x));
    const std::uint32_t y0 = cell_of(least_of(triangle.y));
    const std::uint32_t y1 = cell_of(greatest_of(triangle.y));
    for (std::uint32_t y = y0; y <= y1; ++y) {
        for (std::uint32_t x = x0; x <= x1; ++x) {
            const std::uint32_t cell = y * cells_ + x;
            if (cell_nearest_[cell] <= triangle.farthest + margin) continue;
            for (std::uint32_t i = cell_start_[cell]; i < cell_start_[cell + 1]; ++i) {
                const std::uint32_t place = cell_occluders_[i];
                if (seen_by_[place] == question_) continue;
                seen_by_[place] = question_;
                const Occluder& other = occluders_[place];
                if (other.triangle == own || other.nearest <= triangle.farthest + margin) continue;
                if (is_nowhere_before(other, triangle, margin) || lie_apart(other, triangle)) continue;
                out.push_back(place);
            }
        }
    }
    return true;
}

}  // namespace txc
