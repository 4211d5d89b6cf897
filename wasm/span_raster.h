// First phase of the bake: draws a material's triangles into texture space, lowest index first. Each texel goes to the
// first triangle that covers its centre; what others claim of it is counted as overlap (spec section 2).
#pragma once

#include <cstdint>
#include <vector>

#include "coverage_bits.h"
#include "local_space_map.h"
#include "span_list.h"
#include "uv_raster.h"

namespace txc {

class SpanRaster {
public:
    /// Makes frames and overlap counts in `map`; counts its own memory with `scratch`. All must outlive it.
    SpanRaster(const Mesh& mesh, LocalSpaceMap& map, BudgetShare& scratch);

    /// BAD_UVS where a triangle repeats the texture too often to be drawn.
    static TxcStatus check(const Mesh& mesh, const MapKey& key);

    /// Bytes that the raster of a map of this size holds, without its spans.
    static std::uint64_t byte_count(const MapKey& key);

    /// Draws on until `work` texels (about) were visited, which it counts down.
    TxcStatus step(std::int64_t& work);

    bool done() const { return next_triangle_ == material_.triangles.size() && rows_.first >= rows_.last; }
    /// 0 to 1.
    float progress() const;

    const CoverageBits& covered() const { return map_.key.is_window() ? window_covered_ : covered_; }
    const SpanList& spans() const { return spans_; }
    /// Per tile of the grid: runs into which the spans fall there.
    const std::vector<std::uint32_t>& tile_run_counts() const { return tile_run_counts_; }
    void release_spans() { spans_.clear(); }

private:
    /// One repeat of the triangle under way, and its frame.
    struct OpenFrame {
        std::int64_t repeat_x;
        std::int64_t repeat_y;
        std::uint32_t frame;
    };

    void open_triangle(std::uint32_t triangle);
    bool is_steep(Double2 size) const;
    TxcStatus draw_rows(std::int64_t& work);
    TxcStatus draw_wrapped_rows(std::int64_t& work);
    TxcStatus claim(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                    std::int64_t repeat_y);
    TxcStatus claim_free_texels(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                                std::int64_t repeat_y);
    TxcStatus keep_span(std::uint32_t row, std::uint32_t first, std::uint32_t count, std::int64_t repeat_x,
                        std::int64_t repeat_y);
    TxcStatus add_span(std::uint32_t frame, std::uint32_t row, std::uint32_t first, std::uint32_t count);
    TxcStatus add_window_span(std::uint32_t frame, std::uint32_t row, std::uint32_t first, std::uint32_t count);
    TxcStatus frame_for(const RepeatedTexel& at, std::uint32_t& out_frame);
    bool is_settled(std::uint32_t row, std::uint32_t first, std::uint32_t count) const;
    TxcStatus count_overlap(std::uint32_t x, std::uint32_t y);

    const Mesh& mesh_;
    const Material& material_;
    LocalSpaceMap& map_;
    // Of a window, too, the whole texture is drawn, and what lies outside dropped: each frame then begins at the texel at which it
    // begins in the whole, and comes out the same to the last bit.
    CoverageBits covered_;  // of the whole texture
    CoverageBits window_covered_;
    // Claims of these change nothing any more: they are taken, and counted as far as counting goes. Made with the first overlap.
    // Without them 20,000 triangles that each cover half of 1024 x 1024 texels bake for 26 times as long.
    CoverageBits settled_;
    BudgetShare& scratch_;
    SpanList spans_;
    std::vector<std::uint32_t> tile_run_counts_;
    std::size_t next_triangle_ = 0;  // in the material's list

    // The triangle under way.
    std::uint32_t triangle_ = 0;
    TexelTriangle texels_{};
    TriangleRaster raster_;
    TexelRange rows_{0, 0};         // still to be drawn
    bool wraps_ = false;            // leaves the texture's first repeat
    bool overlaps_itself_ = false;  // spans more than one repeat
    bool is_steep_ = false;         // each of its spans has a frame of its own
    CoverageBits claimed_;          // for such a triangle: each texel counts once
    std::vector<OpenFrame> open_frames_;
};

}  // namespace txc
