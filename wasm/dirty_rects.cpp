#include "dirty_rects.h"

#include <algorithm>

namespace txc {
namespace {

struct Grid {
    const std::vector<std::uint8_t>& marked;
    std::uint32_t columns;
    bool at(std::uint32_t x, std::uint32_t y) const { return marked[static_cast<std::size_t>(y) * columns + x] != 0; }
};

bool is_empty(const TileRect& r) { return r.x0 >= r.x1; }

std::uint64_t area(const TileRect& r) {
    return is_empty(r) ? 0 : static_cast<std::uint64_t>(r.x1 - r.x0) * (r.y1 - r.y0);
}

TileRect unite(const TileRect& a, const TileRect& b) {
    if (is_empty(a)) return b;
    if (is_empty(b)) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// The marked tiles' bounds in each column (`by_column`) or row of a rectangle.
std::vector<TileRect> slice_bounds(const Grid& grid, const TileRect& r, bool by_column) {
    const std::uint32_t count = by_column ? r.x1 - r.x0 : r.y1 - r.y0;
    std::vector<TileRect> slices(count, TileRect{1, 0, 0, 0});
    for (std::uint32_t y = r.y0; y < r.y1; ++y) {
        for (std::uint32_t x = r.x0; x < r.x1; ++x) {
            if (!grid.at(x, y)) continue;
            TileRect& slice = slices[by_column ? x - r.x0 : y - r.y0];
            slice = unite(slice, {x, y, x + 1, y + 1});
        }
    }
    return slices;
}

struct Cut {
    std::uint64_t saved = 0;
    TileRect first{1, 0, 0, 0};
    TileRect second{1, 0, 0, 0};
};

void find_cut(const Grid& grid, const TileRect& r, bool by_column, std::uint64_t rect_cost, Cut& best) {
    const std::vector<TileRect> slices = slice_bounds(grid, r, by_column);
    std::vector<TileRect> after(slices.size() + 1, TileRect{1, 0, 0, 0});
    for (std::size_t i = slices.size(); i-- > 0;) after[i] = unite(slices[i], after[i + 1]);
    TileRect before{1, 0, 0, 0};
    for (std::size_t i = 1; i < slices.size(); ++i) {
        before = unite(before, slices[i - 1]);
        if (is_empty(before) || is_empty(after[i])) continue;
        const std::uint64_t cost = area(before) + area(after[i]) + rect_cost;
        if (cost < area(r) && area(r) - cost > best.saved) best = {area(r) - cost, before, after[i]};
    }
}

}  // namespace

void cover_tiles(const std::vector<std::uint8_t>& marked, std::uint32_t columns, std::uint64_t rect_cost,
                 std::vector<TileRect>& out) {
    out.clear();
    const Grid grid{marked, columns};
    TileRect all{1, 0, 0, 0};
    for (std::size_t at = next_mark(marked, 0); at < marked.size(); at = next_mark(marked, at + 1)) {
        const auto x = static_cast<std::uint32_t>(at % columns);
        const auto y = static_cast<std::uint32_t>(at / columns);
        all = unite(all, {x, y, x + 1, y + 1});
    }
    if (is_empty(all)) return;
    std::vector<TileRect> open{all};
    while (!open.empty()) {
        const TileRect r = open.back();
        open.pop_back();
        Cut cut;
        find_cut(grid, r, true, rect_cost, cut);
        find_cut(grid, r, false, rect_cost, cut);
        if (cut.saved == 0) {
            out.push_back(r);
            continue;
        }
        open.push_back(cut.second);
        open.push_back(cut.first);
    }
}

}  // namespace txc
