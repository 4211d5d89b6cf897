#include "tile_tree.h"

#include <algorithm>
#include <cmath>

#include "local_space_map.h"

namespace txc {

bool ModelToDecal::may_touch(const ModelBox& box) const {
    const glm::dvec3 centre = apply((glm::dvec3(box.min) + glm::dvec3(box.max)) * 0.5);
    const glm::dvec3 half = (glm::dvec3(box.max) - glm::dvec3(box.min)) * 0.5;
    for (int axis = 0; axis < 3; ++axis) {
        const double half_extent = std::fabs(matrix[0][axis]) * half.x + std::fabs(matrix[1][axis]) * half.y +
                                   std::fabs(matrix[2][axis]) * half.z;
        // A little more than the reach: the boxes are rounded to float, and a wrong "may" costs only time.
        if (std::fabs(centre[axis]) - half_extent > reach[axis] + 1e-5) return false;
    }
    return true;
}

void TileTree::build(const LocalSpaceMap& map) {
    const std::uint32_t columns = map.tile_columns();
    group_columns_ = (columns + kGroupSize - 1) / kGroupSize;
    const std::uint32_t group_rows = (map.tile_rows() + kGroupSize - 1) / kGroupSize;
    groups_.assign(static_cast<std::size_t>(group_columns_) * group_rows, Group{});
    for (const MapTile& tile : map.tiles) {
        Group& group = groups_[tile.index / columns / kGroupSize * group_columns_ + tile.index % columns / kGroupSize];
        group.box.min = group.empty ? tile.box.min : glm::min(group.box.min, tile.box.min);
        group.box.max = group.empty ? tile.box.max : glm::max(group.box.max, tile.box.max);
        group.empty = false;
    }
}

void TileTree::find(const LocalSpaceMap& map, const ModelToDecal& to_decal, std::vector<std::uint32_t>& out) const {
    find(
        map, [&](const ModelBox& box) { return to_decal.may_touch(box); }, out);
}

void TileTree::find(const LocalSpaceMap& map, const std::function<bool(const ModelBox&)>& may_touch,
                    std::vector<std::uint32_t>& out) const {
    out.clear();
    const std::uint32_t columns = map.tile_columns();
    const std::uint32_t rows = map.tile_rows();
    std::vector<std::uint32_t> near;  // of a row of groups, their first columns
    for (std::uint32_t row = 0; row < rows; ++row) {
        if (row % kGroupSize == 0) {
            near.clear();
            const Group* groups = groups_.data() + row / kGroupSize * group_columns_;
            for (std::uint32_t g = 0; g < group_columns_; ++g) {
                if (!groups[g].empty && may_touch(groups[g].box)) near.push_back(g * kGroupSize);
            }
        }
        for (const std::uint32_t first : near) {
            for (std::uint32_t column = first; column < std::min(first + kGroupSize, columns); ++column) {
                const std::uint32_t place = map.tile_of[row * columns + column];
                if (place != kNoTile && may_touch(map.tiles[place].box)) out.push_back(place);
            }
        }
    }
}

}  // namespace txc
