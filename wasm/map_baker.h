// The bake, in steps: draws a material's triangles into texture space, sorts their spans into tiles, finds the gutter
// and bounds the tiles; what is left is a local space map (spec section 2).
//
// Nothing here touches texels one by one but at the charts' borders. Rejected: an array of each texel's owner, filled by
// the raster, searched for runs and scanned twice for the gutter; it took 3.3 times as long on 20,000 triangles at
// 2048 x 2048 (2.2 times on 200,000), and 5 bytes a texel while at work.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "float4.h"
#include "gutter.h"
#include "local_space_map.h"
#include "span_raster.h"
#include "tile_owners.h"

namespace txc {

/// Bounds of a tile's footprints in model space; the last lane is idle.
struct TileBox {
    Float4 low = splat(std::numeric_limits<float>::max());
    Float4 high = splat(-std::numeric_limits<float>::max());
};

class MapBaker {
public:
    /// Checks key and memory. `mesh` must outlive the baker. Errors: BAD_UVS, OUT_OF_BUDGET.
    static TxcStatus begin(const Mesh& mesh, const MapKey& key, MemoryBudget& budget,
                           std::unique_ptr<MapBaker>& out_baker);

    /// Works on until about `work_limit` texels were visited. PENDING while there is more, OK when done.
    TxcStatus step(std::uint32_t work_limit);

    /// 0 to 1.
    float progress() const;

    /// The finished map, once step() has said OK.
    std::shared_ptr<LocalSpaceMap> take() { return std::move(map_); }

private:
    enum class Phase { kRaster, kSort, kPrepare, kGutter, kDone };

    MapBaker(const Mesh& mesh, const MapKey& key, MemoryBudget& budget);
    TxcStatus begin_sorting();
    void sort_spans(std::uint64_t count);
    void begin_gutter();
    TxcStatus finish_tile_row(std::uint32_t tile_row);
    void find_gutter(std::uint32_t first_row, std::uint32_t rows);
    std::uint32_t extended_owner(std::uint32_t x, std::uint32_t y, std::uint32_t nearest_x, std::uint32_t nearest_y);
    TxcStatus add_gutter_runs(std::uint32_t tile_row, std::uint32_t tile_column, std::uint32_t rows);
    TxcStatus reserve_gutter_runs(std::size_t count);
    TxcStatus finish();

    std::shared_ptr<LocalSpaceMap> map_;
    BudgetShare scratch_;
    SpanRaster raster_;
    Phase phase_ = Phase::kRaster;
    std::uint64_t next_span_ = 0;          // when sorting
    std::vector<std::uint32_t> run_ends_;  // per tile: where its next run goes; once sorted, the end of its runs
    std::vector<TileBox> boxes_;           // per tile
    std::uint32_t next_row_ = 0;           // when preparing the gutter; of tiles, when finding it
    std::unique_ptr<GutterSearch> gutter_;
    // Of the tile row under way: which texels are gutter, and who owns those.
    std::vector<std::uint64_t> gutter_bits_;
    std::vector<std::uint32_t> gutter_owners_;
    std::unique_ptr<TileOwners> owners_;
};

}  // namespace txc
