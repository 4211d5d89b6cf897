#include "fill_paint.h"

#include <algorithm>
#include <cmath>

#include "image_pyramid.h"
#include "srgb_curve.h"

namespace txc {
namespace {

/// Premultiplied, in the space that colours are mixed in.
struct Stop {
    float offset;
    Float4 color;
};

Float4 premultiplied(Float4 straight) {
    Float4 color = straight * splat(straight[3]);
    color[3] = straight[3];
    return color;
}

/// The colour at each place of the model, as layer tiles hold it.
class GradientColors {
public:
    /// `origin`: of the positions.
    GradientColors(const TxcGradient& gradient, const glm::vec3& origin, bool linear) : is_linear_(linear) {
        is_radial_ = gradient.kind == TXC_GRADIENT_RADIAL;
        double square = 0.0;
        for (int c = 0; c < 3; ++c) {
            const auto from = static_cast<double>(gradient.from_model[c]);
            from_[c] = static_cast<double>(gradient.from_model[c] - origin[c]);
            along_[c] = static_cast<double>(gradient.to_model[c]) - from;
            square += along_[c] * along_[c];
        }
        scale_ = is_radial_ ? 1.0 / static_cast<double>(gradient.radius) : 1.0 / square;
        for (std::uint32_t s = 0; s < gradient.stop_count; ++s) {
            const float* rgba = gradient.colors + s * 4;
            Float4 color{rgba[0], rgba[1], rgba[2], rgba[3]};
            if (linear) {
                color = srgb_to_linear(color);
                color[3] = rgba[3];
            }
            stops_.push_back({gradient.offsets[s], premultiplied(color)});
        }
    }

    Float4 at(const glm::vec3& position) const {
        const double offset = std::min(std::max(offset_of(position), -1.0), 2.0);
        Float4 color = mixed(static_cast<float>(offset));
        const float alpha = color[3];
        if (is_linear_ && alpha > 0.0f) {
            color = linear_to_srgb(lesser(color * splat(1.0f / alpha), splat(1.0f)));
            color[3] = alpha;
            color = premultiplied(color);
        }
        return color * splat(kFullScale);
    }

private:
    double offset_of(const glm::vec3& position) const {
        const double d[3] = {static_cast<double>(position.x) - from_[0], static_cast<double>(position.y) - from_[1],
                             static_cast<double>(position.z) - from_[2]};
        if (is_radial_) return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) * scale_;
        return (d[0] * along_[0] + d[1] * along_[1] + d[2] * along_[2]) * scale_;
    }

    Float4 mixed(float offset) const {
        // Not "from the first above": of stops that share an offset the last one holds there.
        std::size_t above = 0;
        while (above < stops_.size() && stops_[above].offset <= offset) ++above;
        if (above == 0) return stops_.front().color;
        if (above == stops_.size()) return stops_.back().color;
        const Stop& low = stops_[above - 1];
        const Stop& high = stops_[above];
        const float share = (offset - low.offset) / (high.offset - low.offset);
        return low.color + (high.color - low.color) * splat(share);
    }

    bool is_linear_;
    bool is_radial_;
    double from_[3];
    double along_[3];
    double scale_;
    std::vector<Stop> stops_;
};

/// Paints the runs of one tile after the other.
class FillPainter final : public LayerPainter {
public:
    FillPainter(const LocalSpaceMap& map, const FillShape& shape, const TxcLayerDef& def,
                const std::vector<std::uint8_t>& chosen)
        : map_(map),
          chosen_(chosen),
          color_(premultiplied(Float4{def.color[0], def.color[1], def.color[2], def.color[3]})) {
        color_ = color_ * splat(kFullScale);
        if (shape.has_gradient)
            gradient_ =
                std::make_unique<GradientColors>(shape.gradient, map.origin, def.blend_space == TXC_BLEND_SPACE_LINEAR);
    }

    bool reaches(const MapTile& tile) const {
        bool any = false;
        map_.for_each_run_of(tile, [&](const TexelRun& run) { any = any || is_chosen(run); });
        return any;
    }

    bool paint_tile(const MapTile& tile, std::uint16_t* texels) override {
        clear_tile(texels);
        const auto tile_x = static_cast<std::int32_t>(tile.index % map_.tile_columns() * kTileSize);
        const auto tile_y = static_cast<std::int32_t>(tile.index / map_.tile_columns() * kTileSize);
        map_.for_each_run_of(tile, [&](const TexelRun& run) {
            if (!is_chosen(run)) return;
            const TexelFrame& frame = map_.frames[run.frame];
            for (std::uint32_t x = run.x; x < std::uint32_t{run.x} + run.length; ++x) {
                const Float4 color =
                    gradient_ == nullptr
                        ? color_
                        : gradient_->at(frame.position_at(tile_x + static_cast<std::int32_t>(x), tile_y + run.y));
                store_rounded_ushort4(texels + (run.y * kTileSize + x) * 4, color);
            }
        });
        return true;
    }

private:
    bool is_chosen(const TexelRun& run) const {
        return chosen_.empty() || chosen_[map_.frames[run.frame].triangle] != 0;
    }

    const LocalSpaceMap& map_;
    const std::vector<std::uint8_t>& chosen_;  // per triangle of the mesh; empty: all
    Float4 color_;
    std::unique_ptr<GradientColors> gradient_;
};

}  // namespace

void FillShape::clear() {
    has_gradient = has_triangles = false;
    triangles = decltype(triangles)();
    share.release();
}

TxcStatus check_gradient(const TxcGradient& gradient) {
    const auto finite = [](const float(&values)[3], const char* field) {
        for (const float value : values) {
            if (!(std::abs(value) <= kMaxCoordinate))
                return fail(TXC_STATUS_BAD_ARGUMENT, "%s has a coordinate of %g", field, static_cast<double>(value));
        }
        return TXC_STATUS_OK;
    };
    if (gradient.kind >= TXC_GRADIENT_KIND_COUNT)
        return fail(TXC_STATUS_BAD_ARGUMENT, "kind is %u; it must be below %d", gradient.kind, TXC_GRADIENT_KIND_COUNT);
    if (const TxcStatus status = finite(gradient.from_model, "from_model"); status != TXC_STATUS_OK) return status;
    if (gradient.kind == TXC_GRADIENT_LINEAR) {
        if (const TxcStatus status = finite(gradient.to_model, "to_model"); status != TXC_STATUS_OK) return status;
        if (std::equal(gradient.from_model, gradient.from_model + 3, gradient.to_model))
            return fail(TXC_STATUS_BAD_ARGUMENT, "to_model is where from_model is");
    } else if (!(gradient.radius > 0.0f && gradient.radius <= kMaxCoordinate)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "radius is %g; it must be above 0", static_cast<double>(gradient.radius));
    }
    if (gradient.stop_count < 2 || gradient.stop_count > TXC_MAX_STOPS) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "stop_count is %u; it must be from 2 to %u", gradient.stop_count,
                    TXC_MAX_STOPS);
    }
    float last = 0.0f;
    for (std::uint32_t s = 0; s < gradient.stop_count; ++s) {
        const float offset = gradient.offsets[s];
        if (!(offset >= last && offset <= 1.0f)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "offsets[%u] is %g; it must be from %g to 1", s,
                        static_cast<double>(offset), static_cast<double>(last));
        }
        last = offset;
    }
    for (std::uint32_t c = 0; c < gradient.stop_count * 4; ++c) {
        const float value = gradient.colors[c];
        if (!(value >= 0.0f && value <= 1.0f)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "colors[%u] is %g; it must be from 0 to 1", c,
                        static_cast<double>(value));
        }
    }
    return TXC_STATUS_OK;
}

TxcStatus paint_fill(const LocalSpaceMap& map, const Mesh& mesh, const FillShape& shape, const TxcLayerDef& def,
                     LayerTiles& out, std::uint32_t& out_texels) {
    std::vector<std::uint8_t> chosen;
    if (shape.has_triangles) {
        chosen.resize(mesh.triangles.size());
        const Material& material = mesh.materials[map.key.material];
        for (const std::uint32_t triangle : shape.triangles) chosen[material.triangles[triangle]] = 1;
    }
    FillPainter painter(map, shape, def, chosen);
    std::vector<std::uint32_t> places;
    for (std::uint32_t place = 0; place < map.tiles.size(); ++place) {
        if (painter.reaches(map.tiles[place])) places.push_back(place);
    }
    return paint_tiles(map, places, painter, out, out_texels);
}

}  // namespace txc
