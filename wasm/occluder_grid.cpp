#include "occluder_grid.h"

#include <algorithm>
#include <cmath>

namespace txc {
namespace {

// Texels whose centre lies a little outside the picture still take paint (their footprint reaches in). The grid covers
// that much more on each side; texels further out ask the tree.
constexpr double kHalfSide = 0.5625;
constexpr std::uint32_t kMaxCells = 128;

}  // namespace

TxcStatus OccluderGrid::build() {
    ModelToDecal volume = projector_.to_decal;
    volume.reach = glm::dvec3(kHalfSide, kHalfSide, 0.5);
    std::vector<std::uint32_t> near;
    tree_.find(volume, near);
    if (const TxcStatus status =
            share_.resize(near.size() * (sizeof(Occluder) + 16 * sizeof(std::uint32_t)), "a decal's occluders");
        status != TXC_STATUS_OK)
        return status;
    occluders_.reserve(near.size());
    for (const std::uint32_t triangle : near) {
        Occluder occluder;
        if (flatten(triangle, occluder)) occluders_.push_back(occluder);
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
    if (low.x > kHalfSide || high.x < -kHalfSide || low.y > kHalfSide || high.y < -kHalfSide || low.z > 0.5 ||
        high.z < -0.5)
        return false;
    const glm::dvec3 ab = corner[1] - corner[0];
    const glm::dvec3 ac = corner[2] - corner[0];
    const double area = ab.x * ac.y - ab.y * ac.x;
    if (area == 0.0) return false;  // seen edge-on: a ray passes it by
    out.depth_dx = (ab.z * ac.y - ac.z * ab.y) / area;
    out.depth_dy = (ac.z * ab.x - ab.z * ac.x) / area;
    out.depth = corner[0].z - out.depth_dx * corner[0].x - out.depth_dy * corner[0].y;
    out.nearest = high.z;
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
        const std::uint32_t x0 = cell_of(std::min(o.x[0], std::min(o.x[1], o.x[2])));
        const std::uint32_t x1 = cell_of(std::max(o.x[0], std::max(o.x[1], o.x[2])));
        const std::uint32_t y0 = cell_of(std::min(o.y[0], std::min(o.y[1], o.y[2])));
        const std::uint32_t y1 = cell_of(std::max(o.y[0], std::max(o.y[1], o.y[2])));
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

bool OccluderGrid::is_blocked(const glm::dvec3& point, std::uint32_t own) const {
    const glm::dvec3 q = projector_.to_decal.apply(point);
    if (std::fabs(q.x) > kHalfSide || std::fabs(q.y) > kHalfSide) {
        return tree_.is_blocked(point, projector_.towards_viewer, (0.5 - q.z) * projector_.depth, own);
    }
    const double least = q.z + tree_.least_distance() / projector_.depth;
    const std::uint32_t cell = cell_of(q.y) * cells_ + cell_of(q.x);
    if (cell_nearest_[cell] <= least) return false;
    for (std::uint32_t i = cell_start_[cell]; i < cell_start_[cell + 1]; ++i) {
        const Occluder& o = occluders_[cell_occluders_[i]];
        if (o.nearest <= least || o.triangle == own) continue;
        const double depth = o.depth + o.depth_dx * q.x + o.depth_dy * q.y;
        if (!(depth > least && depth <= 0.5)) continue;
        if ((o.x[1] - o.x[0]) * (q.y - o.y[0]) - (o.y[1] - o.y[0]) * (q.x - o.x[0]) < 0.0) continue;
        if ((o.x[2] - o.x[1]) * (q.y - o.y[1]) - (o.y[2] - o.y[1]) * (q.x - o.x[1]) < 0.0) continue;
        if ((o.x[0] - o.x[2]) * (q.y - o.y[2]) - (o.y[0] - o.y[2]) * (q.x - o.x[2]) < 0.0) continue;
        return true;
    }
    return false;
}

}  // namespace txc
