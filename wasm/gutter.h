// The texels around a chart that carry its nearest triangle onward (spec section 2): found here, stored by the bake.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "coverage_bits.h"

namespace txc {

inline constexpr std::uint32_t kMaxGutter = 64;

/// Default gutter: 2 texels at 1024 and in proportion, never less than 2 (the larger side decides).
std::uint32_t default_gutter(std::uint32_t width, std::uint32_t height);

/// Looks for gutter texels 64 at a time: of all places around, nearest first, which of the texels that are left have a
/// covered one there? (Each texel searching for itself, a row at a time, took eight times as long.)
class GutterSearch {
public:
    /// `covered` must outlive this. A gutter reaches kMaxGutter texels at most.
    GutterSearch(const CoverageBits& covered, std::uint32_t width, std::uint32_t height, std::uint32_t gutter);

    /// What a search of this size holds.
    static std::uint64_t byte_count(std::uint32_t width, std::uint32_t height) {
        return CoverageBits::byte_count(width, height);
    }

    /// To be done for every row before the first search.
    void prepare_row(std::uint32_t y) { near_covered_.spread_row(covered_, y, gutter_); }

    /// Calls visit(x, nearest_x, nearest_y) for each texel of row y that is not covered itself, but has a covered one
    /// within the gutter (Euclidean, centre to centre). Of equally near ones the row closest by, above before below,
    /// then the left one counts: a fixed choice, so that results repeat. Marks the texels in `out`, a bit each.
    template <typename Visit>
    void search_row(std::uint32_t y, std::uint64_t* out, Visit&& visit) const {
        collect_candidates(y, out);
        for (std::uint32_t w = 0; w < covered_.words(); ++w) {
            std::uint64_t left = out[w];
            for (std::size_t i = 0; left != 0 && i < places_.size(); ++i) {
                const std::int32_t row = static_cast<std::int32_t>(y) + places_[i].dy;
                if (row < 0 || row >= static_cast<std::int32_t>(height_)) continue;
                const std::uint64_t found =
                    left & shifted(covered_.row(static_cast<std::uint32_t>(row)), w, places_[i].dx);
                left ^= found;
                for (std::uint64_t bits = found; bits != 0; bits &= bits - 1) {
                    const std::uint32_t x = w * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
                    visit(x, static_cast<std::uint32_t>(static_cast<std::int32_t>(x) + places_[i].dx),
                          static_cast<std::uint32_t>(row));
                }
            }
            out[w] ^= left;
        }
    }

private:
    struct Place {
        std::int32_t dx;
        std::int32_t dy;
    };

    void collect_candidates(std::uint32_t y, std::uint64_t* out) const;

    /// The word whose bit i is the row's texel 64 * w + i + dx.
    std::uint64_t shifted(const std::uint64_t* row, std::uint32_t w, std::int32_t dx) const {
        if (dx == 0) return row[w];
        if (dx > 0) {
            const std::uint64_t next = w + 1 < covered_.words() ? row[w + 1] : 0;
            return dx == 64 ? next : row[w] >> dx | next << (64 - dx);
        }
        const std::uint64_t before = w > 0 ? row[w - 1] : 0;
        return dx == -64 ? before : row[w] << -dx | before >> (64 + dx);
    }

    const CoverageBits& covered_;
    CoverageBits near_covered_;  // texels with a covered one in their row within the gutter
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t gutter_;
    std::vector<Place> places_;  // within the gutter, in the order in which they count
};

}  // namespace txc
