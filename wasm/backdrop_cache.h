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

/// The end of what is in a group, as if it were a layer: what is below it stays while the group's mask changes, and while
/// something is put on top. Ids are counted up from 1 and never come near it.
constexpr TxcLayer end_of(TxcLayer group) { return ~group; }

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
        const std::int64_t above = places_above(lowest, place_of);
        // So little above, backdrops serve as well as its own would: stroke follows stroke, each a layer on the one before.
        if (above > 0 && above <= kNearPlaces && is_worth_filling()) return;
        // One change further up says little: another drag may have begun, or somebody looks at two layers in turn.
        if (above > 0 && candidate_ != lowest) {
            candidate_ = lowest;
            return;
        }
        forget();
        split_ = lowest;
        steady_updates_ = above > 0 ? 2 : 1;
    }

    /// Tells that `layer` will probably be the one that changes: its backdrops are worth their room from now on.
    template <typename PlaceOf>
    void expect(TxcLayer layer, PlaceOf&& place_of) {
        const std::int64_t above = places_above(layer, place_of);
        if (split_ != 0 && above > 0 && above <= kNearPlaces && is_worth_filling()) return;
        if (layer != split_) {
            forget();
            split_ = layer;
        }
        steady_updates_ = 2;
    }

    /// The layer below which backdrops are held is now known by another name.
    void rename(TxcLayer from, TxcLayer to) {
        if (split_ == from) split_ = to;
    }

    /// The layer below which backdrops are held; 0 without one.
    TxcLayer split() const { return split_; }
    /// That layer changed in several updates in a row, so that what lies below it is worth its room.
    bool is_worth_filling() const { return split_ != 0 && steady_updates_ >= 2; }

    /// A tile's backdrops (states * kTileTexels of them), or null where they are not held.
    Float4* find(std::uint32_t tile) const { return tile < tiles_.size() ? tiles_[tile].get() : nullptr; }
    /// Whether a tile's backdrops can be added with none of the others given up for them.
    bool has_room(std::size_t states) const;
    /// Room for a tile's backdrops; null where the budget has none to spare.
    Float4* make(std::uint32_t tile, std::uint32_t tile_count, std::size_t states);

    void forget();
    /// Forgets what is held, but not below which layer: what was wrong with it is over.
    void empty();

private:
    /// How many places `layer` stands above the one below which backdrops are held; negative or 0 where it does not, or
    /// where there is none.
    template <typename PlaceOf>
    std::int64_t places_above(TxcLayer layer, PlaceOf&& place_of) const {
        const std::int64_t held = split_ == 0 ? -1 : place_of(split_);
        return held < 0 ? -1 : place_of(layer) - held;
    }

    // Layers that are composited again at every step for the sake of those which need not be.
    static constexpr std::int64_t kNearPlaces = 4;

    MemoryBudget* budget_;
    BudgetShare share_;
    TxcLayer split_ = 0;
    TxcLayer candidate_ = 0;  // was the lowest in the newest update, above `split_`
    std::uint32_t steady_updates_ = 0;
    std::vector<std::unique_ptr<Float4[]>> tiles_;
};

}  // namespace txc
