#include "surface_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <variant>

namespace txc {
namespace {

/// Of kFullScale: below half of the angle fade a texel does not count for the least and greatest, as it hardly shows.
constexpr float kCountedWeight = 0.5f;

/// A texel as the picture is cast at it.
struct CastTexel {
    PictureSight sight;
    float weight = 0.0f;  // by the angle; 0 where it faces away
};

/// One frame, and what its texels share.
struct MetricFrame {
    std::uint32_t frame = 0xffffffffu;
    TexelMetric metric;
    bool is_mirrored = false;

    void look_at(const LocalSpaceMap& map, const TexelRun& run, std::uint32_t x, std::uint32_t y) {
        if (run.frame == frame) return;
        frame = run.frame;
        const TexelFrame& at = map.frames[frame];
        metric = TexelMetric::of(at);
        const glm::vec3 dx = TexelFrame::part(at.position, &TexelFrame::Coordinate::dx);
        const glm::vec3 dy = TexelFrame::part(at.position, &TexelFrame::Coordinate::dy);
        const glm::vec3 normal = map.unit_normal(run, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
        // v runs down: right times down looks into the surface where the texture is the right way round.
        is_mirrored = glm::dot(glm::cross(glm::dvec3(dx), glm::dvec3(dy)), glm::dvec3(normal)) > 0.0;
    }
};

float facing_weight(const DecalSettings& settings, double facing) {
    if (settings.backfaces) facing = std::fabs(facing);
    if (!(facing > 0.0)) return 0.0f;
    return settings.fade_start_cosine <= 0.0f ? 1.0f : settings.fade_weight(static_cast<float>(facing));
}

/// Tests 1 to 3 of spec section 4 on a texel's centre, in double and one by one.
class CastLooker {
public:
    CastLooker(const LocalSpaceMap& map, const PictureCast& cast) : map_(map), cast_(cast) {}

    bool look(const TexelRun& run, std::uint32_t x, std::uint32_t y, CastTexel& out) const {
        const auto column = static_cast<std::int32_t>(x);
        const auto row = static_cast<std::int32_t>(y);
        if (cast_.projector == TXC_PROJECTOR_PLANAR) return look_planar(run, column, row, out);
        if (const auto* uv = std::get_if<UvProjector>(&cast_.curved)) {
            const MapKey& key = map_.key;
            out.sight = uv->look(x + key.origin_x, y + key.origin_y, key.texture_width(), key.texture_height());
            out.weight = 1.0f;
            return true;
        }
        if (const auto* perspective = std::get_if<PerspectiveProjector>(&cast_.curved))
            return look_curved(*perspective, run, column, row, out);
        return look_curved(*std::get_if<CylindricalProjector>(&cast_.curved), run, column, row, out);
    }

private:
    struct Place {
        glm::dvec3 position, across, down, normal;
    };

    Place place_of(const TexelRun& run, std::int32_t x, std::int32_t y) const {
        const TexelFrame& frame = map_.frames[run.frame];
        return {glm::dvec3(frame.position_at(x, y)),
                glm::dvec3(TexelFrame::part(frame.position, &TexelFrame::Coordinate::dx)),
                glm::dvec3(TexelFrame::part(frame.position, &TexelFrame::Coordinate::dy)),
                glm::dvec3(map_.unit_normal(run, x, y))};
    }

    bool look_planar(const TexelRun& run, std::int32_t x, std::int32_t y, CastTexel& out) const {
        const PlanarProjector& projector = cast_.settings.projector;
        const Place place = place_of(run, x, y);
        const glm::dvec3 at = projector.to_decal.apply(place.position);
        if (!(std::fabs(at.z) <= 0.5)) return false;
        const glm::dvec3 across = projector.to_decal.matrix * place.across;
        const glm::dvec3 down = projector.to_decal.matrix * place.down;
        out.sight = {at.x, at.y, across.x, across.y, down.x, down.y};
        out.weight = facing_weight(cast_.settings, glm::dot(place.normal, projector.towards_viewer));
        return true;
    }

    template <typename Projector>
    bool look_curved(const Projector& projector, const TexelRun& run, std::int32_t x, std::int32_t y,
                     CastTexel& out) const {
        const ProjectorPose& pose = projector.pose;
        const Place place = place_of(run, x, y);
        TexelSight sight;
        if (!projector.look(
                {pose.to_view(place.position), pose.turn_to_view(place.across), pose.turn_to_view(place.down)}, sight))
            return false;
        out.sight = sight.picture;
        out.weight = facing_weight(cast_.settings, glm::dot(pose.turn_to_view(place.normal), sight.ray));
        return true;
    }

    const LocalSpaceMap& map_;
    const PictureCast& cast_;
};

/// Whether the texel's footprint and the picture's rectangle may share a point.
bool meets_picture(const PictureSight& sight) {
    return std::fabs(sight.x) <= 0.5 + 0.5 * (std::fabs(sight.across_x) + std::fabs(sight.down_x)) &&
           std::fabs(sight.y) <= 0.5 + 0.5 * (std::fabs(sight.across_y) + std::fabs(sight.down_y));
}

/// How the picture's pixels lie on the surface. False where the texel sees the picture from the side.
bool pixel_metric(const ImagePyramid& image, const PictureSight& sight, const TexelMetric& texel, TexelMetric& out) {
    const auto width = static_cast<double>(image.levels[0].width);
    const auto height = static_cast<double>(image.levels[0].height);
    return texel.in_units_of({sight.across_x * width, sight.across_y * height},
                             {sight.down_x * width, sight.down_y * height}, out);
}

/// Places (in LocalSpaceMap::tiles) of the tiles that a layer may paint, or whose texels its picture is cast at.
std::vector<std::uint32_t> tiles_of(const MeasuredLayer& measured) {
    const LocalSpaceMap& map = measured.map;
    if (measured.image != nullptr) return find_candidates(map, measured.layer.cast, *measured.image);
    std::vector<std::uint32_t> places;
    for (std::uint32_t place = 0; place < map.tiles.size(); ++place) {
        if (measured.layer.is_everywhere() || measured.layer.tiles.find(map.tiles[place].index) != nullptr)
            places.push_back(place);
    }
    return places;
}

/// Calls visit(run, x, y, alpha) for the texels of a tile, alpha 0 to 1 as the layer paints it.
template <typename Visit>
void for_each_texel(const MeasuredLayer& measured, const MapTile& tile, bool with_gutter, Visit&& visit) {
    const LocalSpaceMap& map = measured.map;
    const std::uint32_t tile_x = tile.index % map.tile_columns() * kTileSize;
    const std::uint32_t tile_y = tile.index / map.tile_columns() * kTileSize;
    const std::uint16_t* texels = measured.layer.tiles.find(tile.index);
    const double everywhere = measured.layer.is_everywhere() ? static_cast<double>(measured.layer.def.color[3]) : 0.0;
    map.for_each_run_of(tile, [&](const TexelRun& run) {
        if (!with_gutter && (run.flags & kRunGutter) != 0) return;
        for (std::uint32_t x = run.x; x < std::uint32_t{run.x} + run.length; ++x) {
            const double alpha = texels != nullptr
                                     ? texels[(run.y * kTileSize + x) * 4 + 3] / static_cast<double>(kFullScale)
                                     : everywhere;
            visit(run, tile_x + x, tile_y + run.y, alpha);
        }
    });
}

bool overlaps(const LocalSpaceMap& map, std::uint32_t x, std::uint32_t y) {
    if (map.overlap_tiles.empty()) return false;
    const auto& claims = map.overlap_tiles[y / kTileSize * map.tile_columns() + x / kTileSize];
    return claims != nullptr && claims[y % kTileSize * kTileSize + x % kTileSize] > 1;
}

double period_of(const PictureCast& cast) {
    const auto* cylindrical =
        cast.projector == TXC_PROJECTOR_PLANAR ? nullptr : std::get_if<CylindricalProjector>(&cast.curved);
    return cylindrical != nullptr ? cylindrical->period : 0.0;
}

void keep_least(double& least, double value) {
    if (least < 0.0 || value < least) least = value;
}

}  // namespace

void LayerMeter::add(const MeasuredLayer& measured) {
    const LocalSpaceMap& map = measured.map;
    const ImagePyramid* image = measured.image;
    if (image != nullptr && landing_ == nullptr)
        landing_ =
            std::make_unique<PictureLanding>(*image, measured.layer.cast.settings, period_of(measured.layer.cast));
    const CastLooker looker(map, measured.layer.cast);
    MetricFrame frame;
    for (const std::uint32_t place : tiles_of(measured)) {
        for_each_texel(
            measured, map.tiles[place], false,
            [&](const TexelRun& run, std::uint32_t x, std::uint32_t y, double alpha) {
                CastTexel cast;
                const bool is_painted = alpha > 0.0;
                const bool is_met = image != nullptr && looker.look(run, x, y, cast) && meets_picture(cast.sight);
                if (is_met) {
                    // A texel that looks at the picture and has taken nothing of it lies behind something.
                    const bool is_kept = is_painted || (cast.weight > 0.0f && landing_->is_clear_at(cast.sight));
                    landing_->mark(cast.sight, is_kept ? PictureLanding::kKept : PictureLanding::kHidden);
                }
                if (!is_painted) return;
                frame.look_at(map, run, x, y);
                const double area = frame.metric.area() * alpha;
                area_ += area;
                ++painted_;
                if (overlaps(map, x, y)) ++overlapping_;
                if (frame.is_mirrored) ++mirrored_;
                const double longest = frame.metric.longest();
                if (longest > 0.0) {
                    keep_least(least_texels_, 1.0 / longest);
                    texels_ += area / longest;
                }
                TexelMetric pixel;
                if (is_met && pixel_metric(*image, cast.sight, frame.metric, pixel) && pixel.longest() > 0.0) {
                    const double stretch = pixel.shortest() > 0.0 ? pixel.longest() / pixel.shortest() - 1.0 : 0.0;
                    picture_area_ += area;
                    pixels_ += area / pixel.longest();
                    stretch_ += area * stretch;
                    if (cast.weight >= kCountedWeight) {
                        keep_least(least_pixels_, 1.0 / pixel.longest());
                        greatest_stretch_ = std::max(greatest_stretch_, stretch);
                    }
                }
                if (!zones_.empty()) add_zones(measured, run, x, y, frame.metric, area);
            });
    }
}

void LayerMeter::add_zones(const MeasuredLayer& measured, const TexelRun& run, std::uint32_t x, std::uint32_t y,
                           const TexelMetric& metric, double area) {
    const ZoneTexel texel = zone_texel(measured.map, run, x, y, metric, has_box_);
    bool is_inside = false;
    bool is_safe = false;
    for (std::size_t z = 0; z < zones_.size(); ++z) {
        const PrintZone& zone = zones_[z].zone();
        if (zone.material != measured.map.key.material) continue;
        const double inset = zones_[z].inset(texel);
        if (inset + zone.bleed < 0.0) continue;
        zone_areas_[z] += area;
        is_inside = true;
        is_safe = is_safe || inset >= zone.safe;
    }
    if (!is_inside) outside_ += area;
    if (is_inside && !is_safe) in_safe_margin_ += area;
}

TxcLayerMetrics LayerMeter::result() const {
    const auto mean = [](double sum, double weight) { return static_cast<float>(weight > 0.0 ? sum / weight : 0.0); };
    TxcLayerMetrics out{};
    out.least_pixels_per_metre = static_cast<float>(std::max(least_pixels_, 0.0));
    out.mean_pixels_per_metre = mean(pixels_, picture_area_);
    out.least_texels_per_metre = static_cast<float>(std::max(least_texels_, 0.0));
    out.mean_texels_per_metre = mean(texels_, area_);
    out.greatest_stretch = static_cast<float>(greatest_stretch_);
    out.mean_stretch = mean(stretch_, picture_area_);
    out.clipped = landing_ != nullptr ? static_cast<float>(landing_->clipped()) : 0.0f;
    out.hidden = landing_ != nullptr ? static_cast<float>(landing_->hidden()) : 0.0f;
    out.outside_zones = mean(outside_, area_);
    out.in_safe_margin = mean(in_safe_margin_, area_);
    out.painted_texels = painted_;
    out.overlapping_texels = overlapping_;
    out.mirrored_texels = mirrored_;
    out.area = static_cast<float>(area_);
    return out;
}

void draw_print_map(const MeasuredLayer& measured, std::uint32_t kind, std::uint32_t row, std::uint32_t row_count,
                    float* out) {
    const LocalSpaceMap& map = measured.map;
    std::memset(out, 0, static_cast<std::size_t>(row_count) * map.key.width * sizeof *out);
    const CastLooker looker(map, measured.layer.cast);
    MetricFrame frame;
    for (const std::uint32_t place : tiles_of(measured)) {
        const std::uint32_t tile_row = map.tiles[place].index / map.tile_columns() * kTileSize;
        if (tile_row + kTileSize <= row || tile_row >= row + row_count) continue;
        for_each_texel(measured, map.tiles[place], true,
                       [&](const TexelRun& run, std::uint32_t x, std::uint32_t y, double alpha) {
                           if (!(alpha > 0.0) || y < row || y >= row + row_count) return;
                           frame.look_at(map, run, x, y);
                           TexelMetric unit = frame.metric;
                           CastTexel cast;
                           const bool wants_picture = kind != TXC_PRINT_MAP_TEXELS;
                           if (wants_picture && (measured.image == nullptr || !looker.look(run, x, y, cast) ||
                                                 !pixel_metric(*measured.image, cast.sight, frame.metric, unit)))
                               return;
                           const double longest = unit.longest();
                           const double shortest = unit.shortest();
                           if (!(longest > 0.0) || !(shortest > 0.0)) return;
                           out[static_cast<std::size_t>(y - row) * map.key.width + x] =
                               static_cast<float>(kind == TXC_PRINT_MAP_STRETCH ? longest / shortest : 1.0 / longest);
                       });
    }
}

void draw_zone_mask(const LocalSpaceMap& map, const std::vector<PrintZone>& zones, const PrintZone* zone,
                    std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) {
    std::memset(out, 0, static_cast<std::size_t>(row_count) * map.key.width);
    std::vector<ZoneLook> looks;
    for (const PrintZone& one : zones) {
        if (zone != nullptr ? &one == zone : one.material == map.key.material) looks.emplace_back(one);
    }
    const bool has_box = any_is_box(looks);
    MetricFrame frame;
    map.for_each_run(row, row_count, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        const double gutter = (run.flags & kRunGutter) != 0 ? map.key.gutter : 0.0;
        for (std::uint32_t x = tile_x + run.x; x < tile_x + run.x + run.length; ++x) {
            frame.look_at(map, run, x, y);
            const ZoneTexel texel = zone_texel(map, run, x, y, frame.metric, has_box);
            double most = 0.0;
            for (ZoneLook& look : looks) most = std::max(most, look.cover(texel, gutter));
            out[static_cast<std::size_t>(y - row) * map.key.width + x] = static_cast<std::uint8_t>(most * 255.0 + 0.5);
        }
    });
}

TxcZoneSurface measure_zone(const LocalSpaceMap& map, const PrintZone* zone) {
    TxcZoneSurface out{};
    double area = 0.0;
    double metric[3] = {0.0, 0.0, 0.0};
    double up[2] = {0.0, 0.0};
    double mirrored = 0.0;
    std::optional<ZoneLook> look;
    if (zone != nullptr) look.emplace(*zone);
    MetricFrame frame;
    map.for_each_run(0, map.key.height, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        if ((run.flags & kRunGutter) != 0) return;
        for (std::uint32_t x = tile_x + run.x; x < tile_x + run.x + run.length; ++x) {
            frame.look_at(map, run, x, y);
            const TexelMetric& m = frame.metric;
            if (look.has_value() && look->inset(zone_texel(map, run, x, y, m, zone->is_box)) + zone->bleed < 0.0)
                continue;
            const double texel_area = m.area();
            if (!(texel_area > 0.0)) continue;
            if (out.texels == 0) {
                out.first_x = x;
                out.first_y = y;
            }
            ++out.texels;
            out.first_x = std::min(out.first_x, x);
            out.end_x = std::max(out.end_x, x + 1);
            out.first_y = std::min(out.first_y, y);
            out.end_y = std::max(out.end_y, y + 1);
            area += texel_area;
            metric[0] += texel_area * m.across;
            metric[1] += texel_area * m.skew;
            metric[2] += texel_area * m.down;
            if (frame.is_mirrored) mirrored += texel_area;
            // The way on the surface that rises fastest, in texels: the gradient of the height, its index raised.
            const TexelFrame& at = map.frames[run.frame];
            const auto rise_x = static_cast<double>(at.position[1].dx);
            const auto rise_y = static_cast<double>(at.position[1].dy);
            const double det = m.determinant();
            up[0] += texel_area * (m.down * rise_x - m.skew * rise_y) / det;
            up[1] += texel_area * (m.across * rise_y - m.skew * rise_x) / det;
        }
    });
    out.area = static_cast<float>(area);
    for (int c = 0; c < 3; ++c) out.metric[c] = static_cast<float>(area > 0.0 ? metric[c] / area : 0.0);
    for (int c = 0; c < 2; ++c) out.up[c] = static_cast<float>(area > 0.0 ? up[c] / area : 0.0);
    out.mirrored = static_cast<float>(area > 0.0 ? mirrored / area : 0.0);
    return out;
}

}  // namespace txc
