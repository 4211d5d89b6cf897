// Test 4 of spec section 4 for one planar or perspective decal. In its ray space all rays run along the Z axis, so "does the ray meet
// a triangle" is "does a triangle, seen from the viewer, cover this point nearer to the viewer": triangles near the volume are
// flattened into that space's XY plane and sorted into a grid of cells, and a texel looks at its own cell alone.
//
// Most texels need not look at all: two triangles that do not overlap in that plane cannot hide each other, so each
// triangle is asked once which others may stand before it, and on a surface without folds the answer is "none".
//
// A cell keeps its occluders' bounds by eights, in 16 bits a side: one comparison of each side tells which of the eight
// may stand before a triangle, and all but a few of them need no more. What those then are asked is asked of two edges or
// corners at a time. A drag step over a torus of 20,000 triangles spends 1.8 ms more with occluders than without, instead
// of 3.6 ms; over one of 200,000, 13 ms instead of 25 ms.
//
// Ways that did not pay, by the time to ask for all blockers of the 3,200 occluders of such a step: depths compared before
// edges 1.44 ms against 1.24 (a parting edge settles most of them); marks on occluders already looked at from another
// cell 1.51 ms against 1.41; two occluders to a cell 1.85 ms, and one, 1.85, against 1.52 with eight.
// Where triangles are many, memory is what takes the time: with occluders in the model's order, found by bits, a step over
// 200,000 triangles takes 0.91 of what it took with a hash table of them (over 20,000, 1.00). Edges that part asked first in single
// precision, all three at once, made it 1.06; corners in a list of their own 1.06.
//
// A perspective decal over all that is seen of a mug takes 0.63 of the time that the tree's rays took, by tiles, over tori of 20,000 and
// 200,000 triangles a quarter, at 2048 x 2048.
//
// The same answers as rays through the tree give (a test compares them). 306,000 texels of a 20,000 triangle torus took
// 340 ms with one ray each, in WebAssembly, 30 ms with a look into the cell each, and 4 ms so.
#pragma once

#include <cstdint>
#include <vector>

#include "ray_space.h"

namespace txc {

class OccluderGrid {
public:
    OccluderGrid(const Mesh& mesh, const OcclusionTree& tree, const RaySpace& space, MemoryBudget& budget)
        : mesh_(mesh), tree_(tree), space_(space), share_(budget) {}

    /// Gathers the triangles near the decal's volume. Errors: OUT_OF_BUDGET.
    TxcStatus build();

    /// Whether it is for decals in this place. What they cast, and onto which material, is nothing to it.
    bool is_of(const RaySpace& space) const { return space_.is_same(space); }

    /// False where the volume has a triangle that reaches behind the eye, and so has no place in the ray space: the tree's rays
    /// must be asked then.
    bool is_whole() const { return is_whole_; }

    /// True where a triangle other than `own` stands between the point (model space) and the front of the volume.
    bool is_blocked(const glm::dvec3& point, std::uint32_t own) const;

    /// Which occluders may stand before points of the triangle `own`: places in the grid's own list, for
    /// is_blocked_by(). False where that cannot be said, as the triangle is seen edge-on; ask is_blocked() then.
    bool find_blockers(std::uint32_t own, std::vector<std::uint32_t>& out);

    /// is_blocked() for a point of the triangle that `blockers` were found for. The one that blocks goes to the front of
    /// them, as it will block the next point too.
    bool is_blocked_by(std::vector<std::uint32_t>& blockers, const glm::dvec3& point, std::uint32_t own) const;

private:
    /// A triangle in ray space: corners in the plane, and its depth there as an affine function.
    struct Occluder {
        double x[4];  // the fourth is the first again
        double y[4];
        double depth, depth_dx, depth_dy;
        double nearest;  // its greatest depth: how near it comes to the viewer
        double farthest;
        std::uint32_t triangle;
    };

    /// Which of 32 triangles are occluders, the first in the lowest bit, and the place of the first that is.
    struct PlaceWord {
        std::uint32_t listed, first;
    };

    /// An occluder's bounds in 65,536 steps across the grid, rounded outwards.
    struct Bounds16 {
        std::uint16_t low_x, high_x, low_y, high_y, nearest;
    };

    /// Eight occluders of a cell. All 0 where there are fewer, which comes nowhere near.
    struct Block {
        std::uint16_t low_x[8], high_x[8], low_y[8], high_y[8], nearest[8];
        std::uint32_t place[8];
    };

    static Bounds16 bounds_of(const Occluder& occluder);
    /// Which of a block's occluders may overlap the bounds in the plane, and come nearer than `beyond` there: a bit each.
    static std::uint32_t meeting(const Block& block, const Bounds16& bounds, std::uint16_t beyond);
    /// Which of a block's occluders have their low corner in neither an earlier column nor an earlier row than these.
    static std::uint32_t beginning(const Block& block, std::uint16_t column, std::uint16_t row);
    void find_corners(std::uint32_t triangle, glm::dvec3 (&out)[3]) const;
    bool reaches_behind_eye(std::uint32_t triangle) const;
    bool flatten(std::uint32_t triangle, Occluder& out) const;
    std::uint32_t place_of(std::uint32_t triangle) const;
    bool is_before(const Occluder& occluder, const glm::dvec3& q, double least) const;
    bool hides(const Occluder& occluder, const glm::dvec3& q, double least) const;
    bool lies_in_grid(const glm::dvec3& q) const;
    /// What an occluder must come nearer than to hide q. Before an eye the least for that, since how much more it is takes time.
    double least_depth(const glm::dvec3& q) const {
        return space_.has_eye() ? q.z : q.z + space_.lift(q, tree_.least_distance());
    }
    std::uint32_t cell_of(std::uint16_t coordinate) const { return coordinate * cells_ >> 16; }
    /// The least coordinate in a column or row of cells.
    std::uint16_t first_step_of(std::uint32_t cell) const {
        return static_cast<std::uint16_t>(((cell << 16) + cells_ - 1) / cells_);
    }
    TxcStatus fill_cells(const std::vector<Bounds16>& bounds);

    const Mesh& mesh_;
    const OcclusionTree& tree_;
    const RaySpace space_;
    bool is_whole_ = true;
    std::uint32_t cells_ = 1;  // along one side
    std::vector<Occluder> occluders_;
    std::vector<std::uint32_t> cell_start_;  // first block; cells_ * cells_ + 1
    std::vector<Block> blocks_;
    std::vector<PlaceWord> places_;  // by triangles
    BudgetShare share_;
};

}  // namespace txc
