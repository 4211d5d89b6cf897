// What a target's tiles look like below the layer that is being changed again and again: a drag of the topmost of a hundred
// layers then composites one layer a step, not a hundred.
//
// Held are the compositor's own floats, so that a tile comes out the same to the last bit whether it was found here or not.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "float4.h"
#include "layer_tiles.h"

namespace txc {

class BackdropCache {
public:
    explicit BackdropCache(MemoryBudget& budget) : budget_(&budget), share_(budget) {}

    /// Tells of an update in which `lowest` (0: none) was the lowest layer that changed. `place_of(id)`: where a layer stands,
    /// counted over the tree from the bottom, or a negative number. Backdrops below a layer that changed are forgotten.
    template <typename PlaceOf>
    void follow(TxcLayer lowest, PlaceOf&& place_of) {
        if (lowest == 0) return;
        if (lowest == split_) {
            ++steady_updates_;
            candidate_ = 0;
            return;
        }
        const std::int64_t held = split_ == 0 ? -1 : place_of(split_);
        // One change further up says little: another drag may have begun, or somebody looks at two layers in turn.
        const bool is_above = held >= 0 && place_of(lowest) > held;
        if (is_above && candidate_ != lowest) {
            candidate_ = lowest;
            return;
        }
        forget();
        split_ = lowest;
        steady_updates_ = is_above ? 2 : 1;
    }

    /// The layer below which backdrops are held; 0 without one.
    TxcLayer split() const { return split_; }
    /// That layer changed in several updates in a row, so that what lies below it is worth its room.
    bool is_worth_filling() const { return split_ != 0 && steady_updates_ >= 2; }

    /// A tile's backdrops (states * kTileTexels of them), or null where they are not held.
    Float4* find(std::uint32_t tile) const { return tile < tiles_.size() ? tiles_[tile].get() : nullptr; }
    /// Room for a tile's backdrops; null where the budget has none to spare.
    Float4* make(std::uint32_t tile, std::uint32_t tile_count, std::size_t states);

    void forget();

private:
    MemoryBudget* budget_;
    BudgetShare share_;
    TxcLayer split_ = 0;
    TxcLayer candidate_ = 0;  // was the lowest in the newest update, above `split_`
    std::uint32_t steady_updates_ = 0;
    std::vector<std::unique_ptr<Float4[]>> tiles_;
};

}  // namespace txc
