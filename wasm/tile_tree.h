// The broad phase that the paper leaves to future work: boxes around the map's tiles, and boxes around groups of
// 8 x 8 tiles, so that a decal looks only at texels near it and its cost follows its footprint, not the texture.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace txc {

struct LocalSpaceMap;

/// An axis-aligned box in model space.
struct ModelBox {
    glm::vec3 min;
    glm::vec3 max;
};

/// An affine map from model space to decal space, q = matrix * p + offset, and how far from the middle the decal
/// paints there: 1/2, and on x and y half a picture pixel more, over which the picture fades out.
struct ModelToDecal {
    glm::dmat3 matrix{1.0};
    glm::dvec3 offset{0.0};
    glm::dvec3 reach{0.5};

    glm::dvec3 apply(const glm::dvec3& p) const { return matrix * p + offset; }

    /// True where the box may touch the decal's volume: its own bounds in decal space do.
    bool may_touch(const ModelBox& box) const;
};

class TileTree {
public:
    static constexpr std::uint32_t kGroupSize = 8;  // tiles along a side

    void build(const LocalSpaceMap& map);

    /// Places (in LocalSpaceMap::tiles) of the tiles that may touch the decal's volume, ascending.
    void find(const LocalSpaceMap& map, const ModelToDecal& to_decal, std::vector<std::uint32_t>& out) const;

    /// The same for a volume of any form: `may_touch` says whether a box may hold texels that take paint.
    void find(const LocalSpaceMap& map, const std::function<bool(const ModelBox&)>& may_touch,
              std::vector<std::uint32_t>& out) const;

    std::uint64_t byte_count() const { return groups_.size() * sizeof(Group); }

private:
    struct Group {
        ModelBox box;
        bool empty = true;
    };
    std::vector<Group> groups_;  // row-major
    std::uint32_t group_columns_ = 0;
};

}  // namespace txc
