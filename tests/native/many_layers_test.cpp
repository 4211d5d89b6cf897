// The recipe of tests/golden/README.md: the same bytes here, in WebAssembly, in Node and in Chromium.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "texelcast.h"

namespace {

constexpr const char* kManyLayersHash =
#include "../golden/many_layers.hash"
    ;

constexpr uint32_t kSide = 17;
constexpr uint32_t kSize = 512;

void add_patch(TxcSession session, int p) {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<float> uvs;
    std::vector<uint32_t> indices;
    for (uint32_t j = 0; j < kSide; ++j) {
        for (uint32_t i = 0; i < kSide; ++i) {
            const auto x = static_cast<float>(i);
            const auto z = static_cast<float>(j);
            const auto height = static_cast<float>((7 * i + 13 * j + 5 * static_cast<uint32_t>(p)) % 8);
            positions.insert(positions.end(), {x / 16, height / 64 + static_cast<float>(p) / 2, z / 16});
            normals.insert(normals.end(), {x - 8, 32, z - 8});
            uvs.insert(uvs.end(), {(x / 16 * 7 + static_cast<float>(p) * 8 + 0.5f) / 16, (z / 16 * 15 + 0.5f) / 16});
            if (i + 1 == kSide || j + 1 == kSide) continue;
            const uint32_t a = j * kSide + i;
            indices.insert(indices.end(), {a, a + kSide, a + 1, a + 1, a + kSide, a + kSide + 1});
        }
    }
    TxcMeshDef def;
    txc_mesh_def_default(&def);
    def.vertex_count = kSide * kSide;
    def.index_count = static_cast<uint32_t>(indices.size());
    REQUIRE(txc_model_add_mesh(session, &def, positions.data(), p == 1 ? normals.data() : nullptr, uvs.data(),
                               indices.data()) == TXC_STATUS_OK);
}

TxcImage add_picture(TxcSession session, uint32_t k) {
    std::vector<uint8_t> rgba;
    for (uint32_t y = 0; y < 16; ++y) {
        for (uint32_t x = 0; x < 24; ++x) {
            rgba.push_back(static_cast<uint8_t>((16 * x + 3 * y + 40 * k) % 256));
            rgba.push_back(static_cast<uint8_t>((7 * x + 11 * y + 90 * k) % 256));
            rgba.push_back(static_cast<uint8_t>((x ^ y) * 8 % 256));
            rgba.push_back((x + y + k) % 3 == 0 ? uint8_t{255} : static_cast<uint8_t>((9 * x + 14 * y) % 256));
        }
    }
    TxcImage image = 0;
    REQUIRE(txc_image_create(session, 24, 16, rgba.data(), &image) == TXC_STATUS_OK);
    return image;
}

TxcLayerDef decal(int k, const TxcImage (&pictures)[3]) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.image = pictures[k % 3];
    def.opacity = static_cast<float>(16 - k) / 16;
    def.filter = k % 4 == 3 ? TXC_FILTER_NEAREST : TXC_FILTER_LINEAR;
    def.wrap = k % 6 == 5 ? TXC_WRAP_REPEAT : TXC_WRAP_NONE;
    def.flip_x = k % 5 == 4 ? 1 : 0;
    def.occlusion = k % 2 == 1 ? TXC_OCCLUSION_NONE : TXC_OCCLUSION_SELF;
    if (k % 3 == 1) {
        def.angle_fade_start = 30;
        def.angle_fade_end = 75;
    }
    def.position_model[0] = static_cast<float>(5 * k % 16) / 16;
    def.position_model[1] = static_cast<float>(k % 4) / 8;
    def.position_model[2] = static_cast<float>(11 * k % 16) / 16;
    def.rotation[0] = -4;
    def.rotation[1] = static_cast<float>(k % 3 - 1);
    def.rotation[2] = static_cast<float>(k % 5 - 2);
    def.rotation[3] = 4;
    def.size[0] = static_cast<float>(3 + k % 5) / 8;
    def.size[1] = static_cast<float>(2 + k % 4) / 8;
    def.size[2] = static_cast<float>(1 + k % 2);
    return def;
}

TxcLayerDef other_projector(int j, const TxcImage (&pictures)[3]) {
    const auto f = static_cast<float>(j);
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.image = pictures[j % 3];
    def.opacity = (10 - f) / 16;
    def.wrap = j % 2 == 1 ? TXC_WRAP_REPEAT : TXC_WRAP_NONE;
    def.flip_y = j % 3 == 1 ? 1 : 0;
    def.occlusion = j % 4 == 1 ? TXC_OCCLUSION_NONE : TXC_OCCLUSION_SELF;
    const auto pose = [&def](float x, float y, float z, float qx, float qy, float qz) {
        const float position[3] = {x, y, z};
        const float rotation[4] = {qx, qy, qz, 4};
        for (int c = 0; c < 3; ++c) def.position_model[c] = position[c];
        for (int c = 0; c < 4; ++c) def.rotation[c] = rotation[c];
    };
    if (j < 2) {
        def.projector = TXC_PROJECTOR_PERSPECTIVE;
        pose(0.25f + f / 2, 2, 0.75f, -4, 1 - 2 * f, f);
        def.fov_degrees = 40 + 16 * f;
        def.aspect = (5 - 2 * f) / 4;
        def.near_distance = 0.5f;
        def.far_distance = 3;
    } else if (j < 4) {
        def.projector = TXC_PROJECTOR_CYLINDRICAL;
        if (j == 2) pose(0.5f, -0.5f, 0.5f, 4, 0, 1);
        if (j == 3) pose(0.5f, -0.5f, 0.5f, -4, 1, 0);
        def.radius = 1;
        def.height = 0.625f;
        def.arc_degrees = j == 2 ? 360.0f : 50.0f;
        def.depth = 0.75f;
    } else {
        def.projector = TXC_PROJECTOR_UV;
        def.uv_center[0] = (2 * f - 5) / 8;
        def.uv_center[1] = (11 - f) / 16;
        def.uv_size[0] = 0.5f;
        def.uv_size[1] = 0.375f;
        def.uv_angle_degrees = j == 4 ? 30.0f : -100.0f;
    }
    return def;
}

TxcLayerDef blend_mode(int m, const TxcImage (&pictures)[3]) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.image = pictures[m % 3];
    def.opacity = 0.75f;
    def.blend = static_cast<std::uint32_t>(m);
    def.blend_space = m % 3 == 2 ? TXC_BLEND_SPACE_LINEAR : TXC_BLEND_SPACE_SRGB;
    def.projector = TXC_PROJECTOR_UV;
    def.uv_center[0] = static_cast<float>(2 * (m % 4) + 1) / 8;
    def.uv_center[1] = static_cast<float>(2 * (m / 4) + 1) / 16;
    def.uv_size[0] = 0.3125f;
    def.uv_size[1] = 0.1875f;
    return def;
}

/// A layer's projector as a dab's.
TxcDab dab_of(const TxcLayerDef& def, float flow) {
    TxcDab dab;
    txc_dab_default(&dab);
    dab.flow = flow;
    dab.projector = def.projector;
    for (int c = 0; c < 3; ++c) dab.position_model[c] = def.position_model[c];
    for (int c = 0; c < 4; ++c) dab.rotation[c] = def.rotation[c];
    for (int c = 0; c < 3; ++c) dab.size[c] = def.size[c];
    dab.fov_degrees = def.fov_degrees;
    dab.aspect = def.aspect;
    dab.near_distance = def.near_distance;
    dab.far_distance = def.far_distance;
    dab.radius = def.radius;
    dab.height = def.height;
    dab.arc_degrees = def.arc_degrees;
    dab.depth = def.depth;
    for (int c = 0; c < 2; ++c) dab.uv_center[c] = def.uv_center[c];
    for (int c = 0; c < 2; ++c) dab.uv_size[c] = def.uv_size[c];
    dab.uv_angle_degrees = def.uv_angle_degrees;
    return dab;
}

struct Stroke {
    TxcLayerDef def;
    std::vector<TxcDab> dabs;
};

Stroke stroke(int s, const TxcImage (&pictures)[3]) {
    Stroke stroke;
    TxcLayerDef& def = stroke.def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_STROKE;
    if (s == 0) {
        def.hardness = 0.5f;
        def.flow = 0.5f;
        def.opacity = 0.75f;
        def.occlusion = TXC_OCCLUSION_NONE;
        const float color[4] = {0.75f, 0.125f, 0.25f, 1};
        for (int c = 0; c < 4; ++c) def.color[c] = color[c];
        for (int d = 0; d < 24; ++d) {
            TxcDab dab;
            txc_dab_default(&dab);
            dab.flow = static_cast<float>(1 + d % 4) / 4;
            dab.position_model[0] = static_cast<float>(d + 4) / 32;
            dab.position_model[1] = 0.25f;
            dab.position_model[2] = static_cast<float>(7 * d % 32) / 32;
            dab.rotation[0] = -4;
            dab.rotation[3] = 4;
            dab.size[0] = dab.size[1] = static_cast<float>(1 + d % 3) / 16;
            dab.size[2] = 2;
            stroke.dabs.push_back(dab);
        }
    } else if (s == 1) {
        def.tip = TXC_TIP_PICTURE;
        def.image = pictures[1];
        def.flow = 0.75f;
        def.opacity = 0.5f;
        def.blend = TXC_BLEND_MULTIPLY;
        stroke.dabs = {dab_of(decal(7, pictures), 1), dab_of(other_projector(1, pictures), 0.75f),
                       dab_of(other_projector(3, pictures), 0.5f), dab_of(other_projector(5, pictures), 0.25f)};
    } else {
        def.tip = TXC_TIP_MASK;
        def.image = pictures[2];
        def.opacity = 0.5f;
        def.blend = TXC_BLEND_ERASE;
        for (int e = 0; e < 8; ++e) {
            TxcDab dab;
            txc_dab_default(&dab);
            dab.projector = TXC_PROJECTOR_UV;
            dab.uv_center[0] = static_cast<float>(2 * e + 1) / 16;
            dab.uv_center[1] = 0.375f;
            dab.uv_size[0] = dab.uv_size[1] = 0.1875f;
            stroke.dabs.push_back(dab);
        }
    }
    return stroke;
}

TxcLayerDef fill() {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_FILL;
    def.lock_alpha = 1;
    const float color[4] = {0.25f, 0.5f, 0.75f, 0.125f};
    for (int c = 0; c < 4; ++c) def.color[c] = color[c];
    return def;
}

/// Layers of the recipe once more, in and around each other.
class Tree {
public:
    Tree(TxcSession session, TxcTarget target, const TxcImage (&pictures)[3])
        : session_(session), target_(target), pictures_(pictures) {}

    void add() {
        TxcLayerDef def = group(0.75f, TXC_BLEND_SPACE_LINEAR);
        TxcLayer parent = make(def);
        make(decal(2, pictures_), parent);
        make(decal(3, pictures_), parent);

        def = group(0.5f, TXC_BLEND_SPACE_LINEAR);
        def.isolated = 1;
        def.blend = TXC_BLEND_MULTIPLY;
        parent = make(def);
        paint(stroke(0, pictures_), parent);
        make(blend_mode(16, pictures_), parent);
        TxcLayerDef part = blend_mode(5, pictures_);
        part.blend = TXC_BLEND_ERASE;
        make(part, parent, TXC_ROLE_MASK);
        Stroke shown = stroke(2, pictures_);
        shown.def.blend = TXC_BLEND_NORMAL;
        paint(shown, parent, TXC_ROLE_MASK);

        add_fills();

        Stroke twice;
        txc_layer_def_default(&twice.def);
        twice.def.kind = TXC_LAYER_STROKE;
        twice.def.tip = TXC_TIP_PICTURE;
        twice.def.image = pictures_[0];
        for (std::uint32_t d = 0; d < 2; ++d) {
            TxcDab dab;
            txc_dab_default(&dab);
            dab.flip_x = d;
            dab.projector = TXC_PROJECTOR_UV;
            dab.uv_center[0] = d == 0 ? 0.25f : 0.75f;
            dab.uv_center[1] = 0.75f;
            dab.uv_size[0] = dab.uv_size[1] = 0.25f;
            twice.dabs.push_back(dab);
        }
        paint(twice);
    }

private:
    static TxcLayerDef group(float opacity, std::uint32_t blend_space) {
        TxcLayerDef def;
        txc_layer_def_default(&def);
        def.kind = TXC_LAYER_GROUP;
        def.opacity = opacity;
        def.blend_space = blend_space;
        return def;
    }

    static TxcLayerDef black() {
        TxcLayerDef def;
        txc_layer_def_default(&def);
        def.kind = TXC_LAYER_FILL;
        return def;
    }

    void add_fills() {
        TxcLayerDef def = black();
        def.opacity = 0.5f;
        def.blend_space = TXC_BLEND_SPACE_LINEAR;
        def.invert_mask = 1;
        TxcLayer layer = make(def);
        TxcGradient gradient;
        txc_gradient_default(&gradient);
        const float to[3] = {1, 0.5f, 1};
        for (int c = 0; c < 3; ++c) gradient.to_model[c] = to[c];
        set_stop(gradient, 0, 0, {1, 0, 0, 1});
        set_stop(gradient, 1, 0.5f, {0.25f, 0.75f, 0.5f, 0.25f});
        set_stop(gradient, 2, 1, {0, 0, 1, 0.75f});
        REQUIRE(txc_fill_set_gradient(session_, layer, &gradient) == TXC_STATUS_OK);
        std::vector<uint32_t> triangles;
        for (uint32_t t = 0; t < 1024; t += 3) triangles.push_back(t);
        REQUIRE(txc_fill_set_triangles(session_, layer, triangles.data(), static_cast<uint32_t>(triangles.size())) ==
                TXC_STATUS_OK);
        TxcLayerDef part = blend_mode(9, pictures_);
        part.blend = TXC_BLEND_NORMAL;
        make(part, layer, TXC_ROLE_MASK);

        def = black();
        def.lock_alpha = 1;
        layer = make(def);
        txc_gradient_default(&gradient);
        gradient.kind = TXC_GRADIENT_RADIAL;
        const float center[3] = {0.5f, 0.25f, 0.5f};
        for (int c = 0; c < 3; ++c) gradient.from_model[c] = center[c];
        gradient.radius = 0.75f;
        set_stop(gradient, 0, 0, {1, 1, 0, 0.5f});
        set_stop(gradient, 1, 1, {0, 1, 1, 0});
        REQUIRE(txc_fill_set_gradient(session_, layer, &gradient) == TXC_STATUS_OK);
    }

    static void set_stop(TxcGradient& gradient, uint32_t stop, float offset, const float (&rgba)[4]) {
        gradient.stop_count = std::max(gradient.stop_count, stop + 1);
        gradient.offsets[stop] = offset;
        for (uint32_t c = 0; c < 4; ++c) gradient.colors[stop * 4 + c] = rgba[c];
    }

    TxcLayer make(TxcLayerDef def, TxcLayer parent = 0, std::uint32_t role = TXC_ROLE_CONTENT) {
        def.parent = parent;
        def.role = role;
        TxcLayer layer = 0;
        REQUIRE(txc_layer_create(session_, target_, &def, &layer) == TXC_STATUS_OK);
        return layer;
    }
    void paint(const Stroke& painted, TxcLayer parent = 0, std::uint32_t role = TXC_ROLE_CONTENT) {
        const auto count = static_cast<uint32_t>(painted.dabs.size());
        REQUIRE(txc_stroke_add_dabs(session_, make(painted.def, parent, role), painted.dabs.data(), count) ==
                TXC_STATUS_OK);
    }

    TxcSession session_;
    TxcTarget target_;
    const TxcImage (&pictures_)[3];
};

std::string paint_many_layers() {
    TxcSessionDef session_def;
    txc_session_def_default(&session_def);
    TxcSession session = 0;
    REQUIRE(txc_session_create(&session_def, &session) == TXC_STATUS_OK);
    add_patch(session, 0);
    add_patch(session, 1);
    const TxcImage pictures[3] = {add_picture(session, 0), add_picture(session, 1), add_picture(session, 2)};
    TxcTargetDef target_def;
    txc_target_def_default(&target_def);
    target_def.width = target_def.height = kSize;
    TxcTarget target = 0;
    REQUIRE(txc_target_create(session, &target_def, &target) == TXC_STATUS_OK);
    while (txc_target_bake(session, target, 1u << 20, nullptr) == TXC_STATUS_PENDING) {
    }
    REQUIRE(txc_target_set_base_color(session, target, 255, 255, 255, 255) == TXC_STATUS_OK);
    TxcLayer layer = 0;
    for (int k = 0; k < 12; ++k) {
        const TxcLayerDef def = decal(k, pictures);
        REQUIRE(txc_layer_create(session, target, &def, &layer) == TXC_STATUS_OK);
        if (k != 5) continue;
        const TxcLayerDef over = fill();
        REQUIRE(txc_layer_create(session, target, &over, &layer) == TXC_STATUS_OK);
    }
    for (int j = 0; j < 6; ++j) {
        const TxcLayerDef def = other_projector(j, pictures);
        REQUIRE(txc_layer_create(session, target, &def, &layer) == TXC_STATUS_OK);
    }
    for (int m = 0; m < TXC_BLEND_COUNT; ++m) {
        const TxcLayerDef def = blend_mode(m, pictures);
        REQUIRE(txc_layer_create(session, target, &def, &layer) == TXC_STATUS_OK);
    }
    for (int s = 0; s < 3; ++s) {
        const Stroke painted = stroke(s, pictures);
        REQUIRE(txc_layer_create(session, target, &painted.def, &layer) == TXC_STATUS_OK);
        REQUIRE(txc_stroke_add_dabs(session, layer, painted.dabs.data(), static_cast<uint32_t>(painted.dabs.size())) ==
                TXC_STATUS_OK);
    }
    Tree(session, target, pictures).add();
    TxcUpdate update;
    REQUIRE(txc_target_update(session, target, TXC_NONE, &update) == TXC_STATUS_OK);
    REQUIRE(update.projected_layers == 48);
    uint32_t hash[2] = {0, 0};
    REQUIRE(txc_target_hash(session, target, 0, 0, kSize, kSize, hash) == TXC_STATUS_OK);
    REQUIRE(txc_session_destroy(session) == TXC_STATUS_OK);
    char digits[17];
    std::snprintf(digits, sizeof digits, "%08x%08x", hash[1], hash[0]);
    return digits;
}

}  // namespace

TEST_CASE("Many layers give the one hash that every machine must give") {
    CHECK(paint_many_layers() == std::string(kManyLayersHash));
}
