// The C ABI's own promises: statuses, defaults, what is read back, and the hash (texelcast.h).
#include "texelcast.h"

#include <doctest/doctest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "support/test_session.h"

using namespace support;

namespace {

std::string detail() { return txc_error_detail(); }

}  // namespace

TEST_CASE("The version is the header's") { CHECK(txc_abi_version() == TXC_ABI_VERSION); }

TEST_CASE("Every status has a name and a message of its own") {
    std::set<std::string> names;
    std::set<std::string> messages;
    CHECK(txc_status_count() == TXC_STATUS_COUNT);
    for (std::uint32_t status = 0; status < txc_status_count(); ++status) {
        const std::string name = txc_status_name(status);
        CHECK_FALSE(name.empty());
        CHECK(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == std::string::npos);
        CHECK(std::strlen(txc_status_message(status)) > 3);
        names.insert(name);
        messages.insert(txc_status_message(status));
    }
    CHECK(names.size() == TXC_STATUS_COUNT);
    CHECK(messages.size() == TXC_STATUS_COUNT);
    CHECK(std::string(txc_status_name(TXC_STATUS_OK)) == "OK");
    CHECK(std::string(txc_status_name(TXC_STATUS_NO_UVS)) == "NO_UVS");
    for (const std::uint32_t unknown : {static_cast<std::uint32_t>(TXC_STATUS_COUNT), 1000u, 0xffffffffu}) {
        CHECK(std::string(txc_status_name(unknown)) == "UNKNOWN");
        CHECK(std::string(txc_status_message(unknown)) == "UNKNOWN");
    }
}

TEST_CASE("The defaults are those that the header and spec section 8 name") {
    TxcSessionDef session;
    std::memset(&session, 0xcd, sizeof session);
    txc_session_def_default(&session);
    CHECK(session.memory_budget_mib == 1024);

    TxcTargetDef target;
    std::memset(&target, 0xcd, sizeof target);
    txc_target_def_default(&target);
    CHECK(target.material == 0);
    CHECK(target.width == 1024);
    CHECK(target.height == 1024);
    CHECK(target.gutter == TXC_NONE);
    CHECK(target.mip_levels == 1);
    CHECK(target.texture_width == 0);
    CHECK(target.texture_height == 0);
    CHECK(target.window_x == 0);
    CHECK(target.window_y == 0);

    TxcZone zone;
    std::memset(&zone, 0xcd, sizeof zone);
    txc_zone_default(&zone);
    CHECK(zone.kind == TXC_ZONE_UV);
    CHECK(zone.material == 0);
    CHECK(zone.rotation[3] == 1.0f);
    CHECK(zone.size[2] == 1.0f);
    CHECK(zone.safe == 0.0f);
    CHECK(zone.bleed == 0.0f);

    TxcMeshDef mesh;
    std::memset(&mesh, 0xcd, sizeof mesh);
    txc_mesh_def_default(&mesh);
    CHECK(mesh.vertex_count == 0);
    CHECK(mesh.index_count == 0);
    CHECK(mesh.material == 0);

    TxcLayerDef layer;
    std::memset(&layer, 0xcd, sizeof layer);
    txc_layer_def_default(&layer);
    CHECK(layer.kind == TXC_LAYER_DECAL);
    CHECK(layer.image == 0);
    CHECK(layer.visible == 1);
    CHECK(layer.opacity == 1.0f);
    CHECK(layer.blend == TXC_BLEND_NORMAL);
    CHECK(layer.blend_space == TXC_BLEND_SPACE_SRGB);
    CHECK(layer.lock_alpha == 0);
    CHECK(layer.filter == TXC_FILTER_LINEAR);
    CHECK(layer.wrap == TXC_WRAP_NONE);
    CHECK(layer.flip_x == 0);
    CHECK(layer.flip_y == 0);
    CHECK(layer.backfaces == 0);
    CHECK(layer.angle_fade_start == 70.0f);
    CHECK(layer.angle_fade_end == 90.0f);
    CHECK(layer.occlusion == TXC_OCCLUSION_SELF);
    CHECK(layer.projector == TXC_PROJECTOR_PLANAR);
    for (int c = 0; c < 3; ++c) {
        CHECK(layer.position_model[c] == 0.0f);
        CHECK(layer.rotation[c] == 0.0f);
        CHECK(layer.size[c] == 1.0f);
    }
    CHECK(layer.fov_degrees == 45.0f);
    CHECK(layer.aspect == 1.0f);
    CHECK(layer.near_distance == 0.1f);
    CHECK(layer.far_distance == 100.0f);
    CHECK(layer.radius == 0.5f);
    CHECK(layer.height == 1.0f);
    CHECK(layer.arc_degrees == 180.0f);
    CHECK(layer.depth == 0.1f);
    for (int c = 0; c < 2; ++c) {
        CHECK(layer.uv_center[c] == 0.5f);
        CHECK(layer.uv_size[c] == 1.0f);
    }
    CHECK(layer.uv_angle_degrees == 0.0f);
    CHECK(layer.rotation[3] == 1.0f);
    CHECK(layer.color[3] == 1.0f);
    CHECK(layer.parent == 0);
    CHECK(layer.role == TXC_ROLE_CONTENT);
    CHECK(layer.isolated == 0);
    CHECK(layer.invert_mask == 0);

    TxcGradient gradient;
    std::memset(&gradient, 0xcd, sizeof gradient);
    txc_gradient_default(&gradient);
    CHECK(gradient.kind == TXC_GRADIENT_LINEAR);
    CHECK(gradient.to_model[1] == 1.0f);
    CHECK(gradient.radius == 1.0f);
    CHECK(gradient.stop_count == 2);
    CHECK(gradient.offsets[1] == 1.0f);
    CHECK(gradient.colors[3] == 1.0f);
    CHECK(gradient.colors[4] == 1.0f);
    CHECK(sizeof(TxcGradient) == 89 * 4);

    txc_session_def_default(nullptr);
    txc_target_def_default(nullptr);
    txc_mesh_def_default(nullptr);
    txc_layer_def_default(nullptr);
    txc_gradient_default(nullptr);
}

TEST_CASE("A layer's every field is kept apart and read back as it was given") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    TxcLayerDef def;
    std::memset(&def, 0, sizeof def);
    def.kind = TXC_LAYER_DECAL;
    def.image = session.image(Picture(1, 1));
    def.visible = 0;
    def.opacity = 0.125f;
    def.lock_alpha = 1;
    def.filter = TXC_FILTER_NEAREST;
    def.wrap = TXC_WRAP_REPEAT;
    def.flip_x = 1;
    def.flip_y = 0;
    def.backfaces = 1;
    def.angle_fade_start = 11.0f;
    def.angle_fade_end = 12.0f;
    def.occlusion = TXC_OCCLUSION_NONE;
    place(def, 21, 22, 23);
    for (int c = 0; c < 4; ++c) def.rotation[c] = 31.0f + static_cast<float>(c);
    resize(def, 41, 42, 43);
    float number = 51.0f;
    for (float* field : {&def.fov_degrees, &def.aspect, &def.near_distance, &def.far_distance, &def.radius, &def.height,
                         &def.arc_degrees, &def.depth, &def.uv_center[0], &def.uv_center[1], &def.uv_size[0],
                         &def.uv_size[1], &def.uv_angle_degrees})
        *field = number++;
    for (int c = 0; c < 4; ++c) def.color[c] = 0.0625f * static_cast<float>(c + 1);
    TxcLayerDef group_def;
    txc_layer_def_default(&group_def);
    group_def.kind = TXC_LAYER_GROUP;
    def.parent = session.layer(target, group_def);
    def.role = TXC_ROLE_MASK;
    def.isolated = 1;
    def.invert_mask = 1;
    const TxcLayer layer = session.layer(target, def);
    TxcLayerDef back;
    std::memset(&back, 0xcd, sizeof back);
    must(txc_layer_def(session.id(), layer, &back));
    CHECK(std::memcmp(&def, &back, sizeof def) == 0);
    CHECK(sizeof(TxcLayerDef) == 50 * 4);
    def.flip_x = 0;
    def.flip_y = 1;
    session.change(layer, def);
    const TxcLayerDef again = session.layer_def(layer);
    CHECK(std::memcmp(&def, &again, sizeof def) == 0);
}

TEST_CASE("The detail is empty after a call that succeeded") {
    TestSession session(make_plane());
    TxcModelInfo info;
    CHECK(txc_model_info(0, &info) == TXC_STATUS_STALE_HANDLE);
    CHECK_FALSE(detail().empty());
    CHECK(txc_model_info(session.id(), &info) == TXC_STATUS_OK);
    CHECK(detail().empty());
}

TEST_CASE("A session without a model says so") {
    TestSession session;
    TxcModelInfo info;
    TxcMaterialInfo material;
    CHECK(txc_model_info(session.id(), &info) == TXC_STATUS_NO_MODEL);
    CHECK(txc_material_info(session.id(), 0, &material) == TXC_STATUS_NO_MODEL);
    TxcTargetDef def;
    txc_target_def_default(&def);
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_NO_MODEL);
}

TEST_CASE("Raw arrays: without UVs the material cannot be painted, and materials count up to the highest used") {
    TestSession session;
    Shape bare = make_plane();
    bare.uvs.clear();
    session.add(bare, 3);
    session.add(make_plane(), 1);
    CHECK(session.model_info().material_count == 4);
    CHECK(session.material_info(3).paint_status == TXC_STATUS_NO_UVS);
    CHECK(session.material_info(1).paint_status == TXC_STATUS_OK);
    CHECK(session.material_info(0).paint_status == TXC_STATUS_NO_TRIANGLES);
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.material = 3;
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_NO_UVS);
}

TEST_CASE("The hash is FNV-1a of the bytes that reading gives") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(20, 12);
    session.set_base(target, make_noise(20, 12, 130));
    const Picture picture = session.paint(target);
    const auto fnv = [](const std::vector<std::uint8_t>& bytes) {
        std::uint64_t hash = 0xcbf29ce484222325ull;
        for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ull;
        return hash;
    };
    CHECK(session.hash(target) == fnv(picture.rgba));
    std::vector<std::uint8_t> part(5 * 4 * 4);
    must(txc_target_read(session.id(), target, 0, 3, 2, 5, 4, part.data()));
    std::uint32_t halves[2];
    must(txc_target_hash(session.id(), target, 3, 2, 5, 4, halves));
    CHECK((static_cast<std::uint64_t>(halves[1]) << 32 | halves[0]) == fnv(part));
    must(txc_target_hash(session.id(), target, 3, 2, 0, 0, halves));
    CHECK((static_cast<std::uint64_t>(halves[1]) << 32 | halves[0]) == fnv({}));
}

TEST_CASE("Scratch memory can be asked for in any size, none included") {
    for (const std::uint32_t size : {0u, 1u, 100000u}) {
        void* memory = txc_alloc(size);
        REQUIRE(memory != nullptr);
        std::memset(memory, 1, size);
        txc_free(memory);
    }
    txc_free(nullptr);
}
