// Print truth: what becomes of a layer on the surface, measured texel by texel on the baked map (docs/print-truth.md).
#pragma once

#include <memory>
#include <vector>

#include "picture_landing.h"
#include "print_zone.h"
#include "target.h"

namespace txc {

/// A layer on one of its targets.
struct MeasuredLayer {
    const LocalSpaceMap& map;
    const Layer& layer;         // its tiles are up to date
    const ImagePyramid* image;  // of a decal; null for other kinds, and without a picture
};

/// Adds up what a layer prints, over all targets that it paints.
class LayerMeter {
public:
    explicit LayerMeter(const std::vector<PrintZone>& zones)
        : zones_(looks_at(zones)), has_box_(any_is_box(zones_)), zone_areas_(zones.size(), 0.0) {}

    void add(const MeasuredLayer& measured);

    TxcLayerMetrics result() const;
    /// Of the printed area, per zone.
    double zone_share(std::size_t zone) const { return area_ > 0.0 ? zone_areas_[zone] / area_ : 0.0; }

private:
    void add_zones(const MeasuredLayer& measured, const TexelRun& run, std::uint32_t x, std::uint32_t y,
                   const TexelMetric& metric, double area);

    std::vector<ZoneLook> zones_;
    bool has_box_;
    std::vector<double> zone_areas_;
    std::unique_ptr<PictureLanding> landing_;
    double area_ = 0.0;           // printed, by alpha
    double picture_area_ = 0.0;   // of that: where the picture's density is known
    double least_pixels_ = -1.0;  // a metre; below 0: none seen yet
    double pixels_ = 0.0;         // times area
    double least_texels_ = -1.0;
    double texels_ = 0.0;
    double greatest_stretch_ = 0.0;
    double stretch_ = 0.0;
    double outside_ = 0.0;
    double in_safe_margin_ = 0.0;
    std::uint32_t painted_ = 0;
    std::uint32_t overlapping_ = 0;
    std::uint32_t mirrored_ = 0;
};

/// Rows of a TxcPrintMap of the layer, gutters included; 0 where it paints nothing.
void draw_print_map(const MeasuredLayer& measured, std::uint32_t kind, std::uint32_t row, std::uint32_t row_count,
                    float* out);

/// Rows of a zone's cover, or of all the material's (`zone` null), 0 to 255.
void draw_zone_mask(const LocalSpaceMap& map, const std::vector<PrintZone>& zones, const PrintZone* zone,
                    std::uint32_t row, std::uint32_t row_count, std::uint8_t* out);

/// What a zone, or all the material's surface (`zone` null), is like.
TxcZoneSurface measure_zone(const LocalSpaceMap& map, const PrintZone* zone);

}  // namespace txc
