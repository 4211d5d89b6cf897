// The bake, in steps: rasterises a material's triangles in texture space, finds the gutter, and packs the result into a
// local space map (spec section 2).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "local_space_map.h"
#include "uv_raster.h"

namespace txc {

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
    enum class Phase { kRaster, kRows, kGutter, kPack, kDone };

    /// One repeat of the triangle under way, and its frame.
    struct OpenFrame {
        std::int64_t repeat_x;
        std::int64_t repeat_y;
        std::uint32_t frame;
    };

    MapBaker(const Mesh& mesh, const MapKey& key, MemoryBudget& budget);
    TxcStatus raster(std::int64_t& work);
    void open_triangle(std::uint32_t triangle);
    TxcStatus raster_row(std::int64_t row, std::int64_t& work);
    TxcStatus claim_span(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                         std::int64_t repeat_y);
    TxcStatus count_overlap(std::uint32_t x, std::uint32_t y);
    TxcStatus frame_for(std::uint32_t x, std::uint32_t y, std::int64_t repeat_x, std::int64_t repeat_y,
                        std::uint32_t& out_frame);
    TexelFrame make_frame(std::uint32_t x, std::uint32_t y, std::int64_t repeat_x, std::int64_t repeat_y) const;
    void measure_row(std::uint32_t row);
    void find_gutter_row(std::uint32_t row);
    bool may_have_texels(std::uint32_t row, std::uint32_t tile_column) const;
    void extend_to(std::uint32_t x, std::uint32_t row);
    TxcStatus begin_packing();
    void pack_tile_row(std::uint32_t tile_row);
    void pack_tile(std::uint32_t tile_row, std::uint32_t tile_column);

    const Mesh& mesh_;
    const Material& material_;
    std::shared_ptr<LocalSpaceMap> map_;
    BudgetShare scratch_;
    Phase phase_ = Phase::kRaster;

    std::vector<std::uint32_t> owners_;       // per texel: a frame with the marks below, or kNobody
    std::vector<std::int8_t> row_distances_;  // per texel: see gutter.h
    std::size_t next_triangle_ = 0;           // in the material's list
    std::vector<std::uint8_t> near_tiles_;    // per tile: some texel has an owned one in its row within the gutter
    std::uint32_t next_row_ = 0;              // of the phase under way (tile row when packing)
    std::uint64_t run_count_ = 0;

    // The triangle under way.
    std::uint32_t triangle_ = 0;
    TexelTriangle texels_{};
    RowRange rows_{0, 0};
    bool overlaps_itself_ = false;  // spans more than one repeat of the texture
    std::vector<bool> claimed_;     // per texel, for such a triangle: it counts once
    std::vector<OpenFrame> open_frames_;
};

}  // namespace txc
