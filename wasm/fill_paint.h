// A fill that does not go everywhere alike: kept to some triangles, or coloured by a gradient (texelcast.h, "Fills").
#pragma once

#include <vector>

#include "layer_tiles.h"

namespace txc {

/// A fill layer's own state, beside its colour.
struct FillShape {
    explicit FillShape(MemoryBudget& budget) : share(budget) {}

    bool has_gradient = false;
    TxcGradient gradient{};
    bool has_triangles = false;
    std::vector<std::uint32_t> triangles;  // of the material, in any order
    BudgetShare share;                     // of `triangles`

    /// The same colour on every texel of the target, those that belong to no triangle included.
    bool is_everywhere() const { return !has_gradient && !has_triangles; }
    void clear();
};

/// BAD_ARGUMENT names the field.
TxcStatus check_gradient(const TxcGradient& gradient);

/// Paints the fill into `out` (in place of what was there). `out_texels`: how many texels took colour. Errors:
/// OUT_OF_BUDGET; `out` is then empty, or as it was.
TxcStatus paint_fill(const LocalSpaceMap& map, const Mesh& mesh, const FillShape& shape, const TxcLayerDef& def,
                     LayerTiles& out, std::uint32_t& out_texels);

}  // namespace txc
