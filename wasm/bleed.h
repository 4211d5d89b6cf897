// Colour bled outward from charts (spec section 6): what an exported texture holds beyond the gutter, so that no fringe
// shows where a viewer filters it or makes mip-maps of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "memory_budget.h"

namespace txc {

struct Target;

/// A texel that the exported texture holds another colour at.
struct BledTexel {
    std::uint32_t index;  // row-major
    std::uint32_t rgba;   // as four bytes in memory

    /// As a key to be sorted by the index.
    std::uint64_t packed() const { return std::uint64_t{index} << 32 | rgba; }
    static BledTexel of(std::uint64_t packed) {
        return {static_cast<std::uint32_t>(packed >> 32), static_cast<std::uint32_t>(packed)};
    }
};

/// A target's bled texels, ascending: found when an export first asks, void after the next update.
struct Bleed {
    explicit Bleed(MemoryBudget& budget) : share(budget) {}
    std::vector<std::uint64_t> texels;  // packed
    bool is_known = false;
    BudgetShare share;

    void forget();
};

/// How far colour bleeds: 16 texels at 1024, in proportion, never less than 16 (the larger side decides).
std::uint32_t bleed_reach(std::uint32_t width, std::uint32_t height);

/// Fills in target.bleed: ring by ring, each empty texel beside one that layers changed takes the mean colour of its
/// neighbours that are charted or were filled before. Beside charts that no layer changed the base stays: a picture has
/// its own margin, and other materials' charts may lie there. Errors: OUT_OF_BUDGET.
TxcStatus find_bleed(Target& target, MemoryBudget& budget);

/// Rows of the texture with its bled texels. find_bleed() comes first.
void read_bled_rows(const Target& target, std::uint32_t row, std::uint32_t row_count, std::uint8_t* out);

}  // namespace txc
