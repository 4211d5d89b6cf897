// A session of the core as tests use it: through the C ABI alone, every call checked, destroyed at the end.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "picture.h"
#include "random.h"
#include "shapes.h"
#include "texelcast.h"

namespace support {

/// Fails the test, with the core's own words, unless the call was well.
inline void must(TxcStatus status) {
    const std::string detail = txc_error_detail();
    INFO(txc_status_name(status), ": ", detail);
    REQUIRE(status == TXC_STATUS_OK);
}

/// What the bake made, read back through the ABI.
struct MapArrays {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> positions;  // 3 a texel
    std::vector<float> normals;    // 3 a texel
    std::vector<std::uint8_t> coverage;
    std::vector<std::uint8_t> overlap;

    bool operator==(const MapArrays& other) const = default;
    const float* position(std::uint32_t x, std::uint32_t y) const { return positions.data() + (y * width + x) * 3; }
    const float* normal(std::uint32_t x, std::uint32_t y) const { return normals.data() + (y * width + x) * 3; }
    std::uint8_t coverage_at(std::uint32_t x, std::uint32_t y) const { return coverage[y * width + x]; }
    std::uint8_t overlap_at(std::uint32_t x, std::uint32_t y) const { return overlap[y * width + x]; }
};

/// The newest update's rectangles and bytes, copied.
struct UpdateReport {
    TxcUpdate update{};
    std::vector<TxcRect> rects;
    std::vector<std::uint8_t> bytes;
};

class TestSession {
public:
    explicit TestSession(std::uint32_t memory_budget_mib = 512) {
        TxcSessionDef def;
        txc_session_def_default(&def);
        def.memory_budget_mib = memory_budget_mib;
        must(txc_session_create(&def, &id_));
    }
    explicit TestSession(const Shape& shape) : TestSession() { add(shape); }
    ~TestSession() { txc_session_destroy(id_); }
    TestSession(const TestSession&) = delete;
    TestSession& operator=(const TestSession&) = delete;

    TxcSession id() const { return id_; }

    TxcStatus try_add(const Shape& shape, std::uint32_t material = 0) {
        TxcMeshDef def;
        txc_mesh_def_default(&def);
        def.vertex_count = shape.vertex_count();
        def.index_count = static_cast<std::uint32_t>(shape.indices.size());
        def.material = material;
        return txc_model_add_mesh(id_, &def, shape.positions.data(),
                                  shape.normals.empty() ? nullptr : shape.normals.data(),
                                  shape.uvs.empty() ? nullptr : shape.uvs.data(), shape.indices.data());
    }
    void add(const Shape& shape, std::uint32_t material = 0) { must(try_add(shape, material)); }
    TxcStatus try_load(const std::vector<std::uint8_t>& glb) {
        return txc_model_load_glb(id_, glb.data(), static_cast<std::uint32_t>(glb.size()));
    }
    void load(const std::vector<std::uint8_t>& glb) { must(try_load(glb)); }

    /// A target of the first material, not baked yet.
    TxcTarget open_target(std::uint32_t width, std::uint32_t height, std::uint32_t gutter = TXC_NONE,
                          std::uint32_t mip_levels = 1, std::uint32_t material = 0) {
        TxcTargetDef def;
        txc_target_def_default(&def);
        def.material = material;
        def.width = width;
        def.height = height;
        def.gutter = gutter;
        def.mip_levels = mip_levels;
        TxcTarget target = 0;
        must(txc_target_create(id_, &def, &target));
        return target;
    }
    void bake(TxcTarget target, std::uint32_t work_limit = 1u << 30) {
        TxcStatus status = TXC_STATUS_PENDING;
        while (status == TXC_STATUS_PENDING) status = txc_target_bake(id_, target, work_limit, nullptr);
        must(status);
    }
    /// A baked target of the first material.
    TxcTarget target(std::uint32_t width, std::uint32_t height, std::uint32_t gutter = TXC_NONE,
                     std::uint32_t mip_levels = 1, std::uint32_t material = 0) {
        const TxcTarget target = open_target(width, height, gutter, mip_levels, material);
        bake(target);
        return target;
    }
    MapArrays map(TxcTarget target) const {
        MapArrays map;
        const TxcMapInfo info = map_info(target);
        map.width = info.width;
        map.height = info.height;
        const std::size_t texels = static_cast<std::size_t>(info.width) * info.height;
        map.positions.resize(texels * 3);
        map.normals.resize(texels * 3);
        map.coverage.resize(texels);
        map.overlap.resize(texels);
        must(txc_map_read_positions(id_, target, 0, info.height, map.positions.data()));
        must(txc_map_read_normals(id_, target, 0, info.height, map.normals.data()));
        must(txc_map_read_coverage(id_, target, 0, info.height, map.coverage.data()));
        must(txc_map_read_overlap(id_, target, 0, info.height, map.overlap.data()));
        return map;
    }
    TxcMapInfo map_info(TxcTarget target) const {
        TxcMapInfo info{};
        must(txc_map_info(id_, target, &info));
        return info;
    }
    TxcMaterialInfo material_info(std::uint32_t material = 0) const {
        TxcMaterialInfo info{};
        must(txc_material_info(id_, material, &info));
        return info;
    }
    TxcModelInfo model_info() const {
        TxcModelInfo info{};
        must(txc_model_info(id_, &info));
        return info;
    }
    TxcSessionStats stats() const {
        TxcSessionStats stats{};
        must(txc_session_stats(id_, &stats));
        return stats;
    }

    void set_base(TxcTarget target, const Picture& base, std::uint32_t filter = TXC_FILTER_LINEAR) {
        must(txc_target_set_base(id_, target, base.width, base.height, base.rgba.data(), filter));
    }
    void set_base(TxcTarget target, Color color) {
        must(txc_target_set_base_color(id_, target, color.red, color.green, color.blue, color.alpha));
    }
    TxcImage image(const Picture& picture) {
        TxcImage image = 0;
        must(txc_image_create(id_, picture.width, picture.height, picture.rgba.data(), &image));
        return image;
    }
    TxcLayer layer(TxcTarget target, const TxcLayerDef& def) {
        TxcLayer layer = 0;
        must(txc_layer_create(id_, target, &def, &layer));
        return layer;
    }
    TxcLayerDef layer_def(TxcLayer layer) const {
        TxcLayerDef def{};
        must(txc_layer_def(id_, layer, &def));
        return def;
    }
    void change(TxcLayer layer, const TxcLayerDef& def) { must(txc_layer_update(id_, layer, &def)); }

    TxcUpdate update(TxcTarget target) {
        TxcUpdate update{};
        must(txc_target_update(id_, target, TXC_NONE, &update));
        return update;
    }
    UpdateReport report(TxcTarget target) {
        UpdateReport report;
        report.update = update(target);
        const TxcRect* rects = txc_target_update_rects(id_, target);
        if (rects != nullptr) report.rects.assign(rects, rects + report.update.rect_count);
        report.bytes.resize(report.update.byte_count);
        const std::uint32_t width = map_info(target).width;
        for (const TxcRect& rect : report.rects) {
            const std::uint8_t* level = txc_target_level(id_, target, rect.level);
            const std::size_t stride = std::size_t{std::max(1u, width >> rect.level)} * 4;
            for (std::size_t y = 0; y < rect.height; ++y) {
                std::copy_n(level + (rect.y + y) * stride + std::size_t{rect.x} * 4, std::size_t{rect.width} * 4,
                            report.bytes.begin() + static_cast<std::ptrdiff_t>(rect.byte_offset + y * rect.width * 4));
            }
        }
        return report;
    }
    /// The texture as of the newest update.
    Picture read(TxcTarget target, std::uint32_t level = 0) const {
        const TxcMapInfo info = map_info(target);
        Picture picture(std::max(1u, info.width >> level), std::max(1u, info.height >> level));
        must(txc_target_read(id_, target, level, 0, 0, picture.width, picture.height, picture.rgba.data()));
        return picture;
    }
    /// Updates and reads.
    Picture paint(TxcTarget target) {
        update(target);
        return read(target);
    }
    std::uint64_t hash(TxcTarget target) const {
        const TxcMapInfo info = map_info(target);
        std::uint32_t halves[2] = {0, 0};
        must(txc_target_hash(id_, target, 0, 0, info.width, info.height, halves));
        return static_cast<std::uint64_t>(halves[1]) << 32 | halves[0];
    }

private:
    TxcSession id_ = 0;
};

/// A decal with the defaults of spec section 8 that paints through, so that a claim about one rule depends on no other.
inline TxcLayerDef decal_def(TxcImage image) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.image = image;
    def.occlusion = TXC_OCCLUSION_NONE;
    return def;
}

inline TxcLayerDef fill_def(float red, float green, float blue, float alpha = 1.0f) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_FILL;
    def.color[0] = red;
    def.color[1] = green;
    def.color[2] = blue;
    def.color[3] = alpha;
    return def;
}

/// Filter, wrap, back faces and occlusion, each either way.
inline void draw_switches(TxcLayerDef& def, Random& random) {
    def.filter = random.below(2);
    def.wrap = random.below(2);
    def.backfaces = random.below(2);
    def.occlusion = random.below(2);
}

inline void place(TxcLayerDef& def, double x, double y, double z) {
    def.position_model[0] = static_cast<float>(x);
    def.position_model[1] = static_cast<float>(y);
    def.position_model[2] = static_cast<float>(z);
}

inline void resize(TxcLayerDef& def, double x, double y, double z) {
    def.size[0] = static_cast<float>(x);
    def.size[1] = static_cast<float>(y);
    def.size[2] = static_cast<float>(z);
}

/// Turns the box about a unit axis, right-handed, degrees.
inline void turn(TxcLayerDef& def, double axis_x, double axis_y, double axis_z, double degrees) {
    const double half = degrees * kPi / 360.0;
    def.rotation[0] = static_cast<float>(axis_x * std::sin(half));
    def.rotation[1] = static_cast<float>(axis_y * std::sin(half));
    def.rotation[2] = static_cast<float>(axis_z * std::sin(half));
    def.rotation[3] = static_cast<float>(std::cos(half));
}

}  // namespace support
