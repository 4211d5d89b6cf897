// Arguments out of range are refused by name and value, and change nothing (texelcast.h).
#include <doctest/doctest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/one_of_each.h"

using namespace support;

namespace {

std::string detail() { return txc_error_detail(); }

}  // namespace

TEST_CASE("Sides of 0 and above 8192 are refused for targets, images and bases") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    const std::uint8_t pixel[4] = {0, 0, 0, 0};
    const std::uint32_t sizes[][2] = {{0, 16},    {16, 0},          {0, 0},        {8193, 16},
                                      {16, 8193}, {0xffffffffu, 1}, {65536, 65536}};
    for (const auto& size : sizes) {
        CAPTURE(size[0]);
        CAPTURE(size[1]);
        TxcTargetDef def;
        txc_target_def_default(&def);
        def.width = size[0];
        def.height = size[1];
        TxcTarget created = 0;
        CHECK(txc_target_create(session.id(), &def, &created) == TXC_STATUS_BAD_SIZE);
        CHECK(detail().find(std::to_string(size[0]) + " x " + std::to_string(size[1])) != std::string::npos);
        TxcImage image = 0;
        CHECK(txc_image_create(session.id(), size[0], size[1], pixel, &image) == TXC_STATUS_BAD_SIZE);
        CHECK(txc_target_set_base(session.id(), target, size[0], size[1], pixel, 0) == TXC_STATUS_BAD_SIZE);
    }
}

TEST_CASE("The largest and the smallest side work") {
    TestSession session(make_plane());
    const TxcTarget wide = session.target(8192, 1);
    CHECK(session.paint(wide).width == 8192);
    const TxcTarget tall = session.target(1, 8192, 0, 0);
    CHECK(session.paint(tall).height == 8192);
    CHECK(session.map_info(tall).mip_levels == 14);
    CHECK(session.image(Picture(8192, 2)) != 0);
}

TEST_CASE("A bad field of a layer is named with its value, and changes nothing") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    const TxcLayerDef good = session.layer_def(handles.layer);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    struct Case {
        std::function<void(TxcLayerDef&)> spoil;
        const char* said;
    };
    const Case cases[] = {
        {[](TxcLayerDef& d) { d.kind = 4; }, "kind is 4"},
        {[](TxcLayerDef& d) { d.role = 2; }, "role is 2"},
        {[](TxcLayerDef& d) { d.isolated = 2; }, "isolated is 2"},
        {[](TxcLayerDef& d) { d.invert_mask = 2; }, "invert_mask is 2"},
        {[](TxcLayerDef& d) { d.visible = 7; }, "visible is 7"},
        {[](TxcLayerDef& d) { d.opacity = 1.5f; }, "opacity is 1.5"},
        {[](TxcLayerDef& d) { d.opacity = -0.25f; }, "opacity is -0.25"},
        {[=](TxcLayerDef& d) { d.opacity = nan; }, "opacity is "},
        {[](TxcLayerDef& d) { d.blend = 17; }, "blend is 17"},
        {[](TxcLayerDef& d) { d.blend_space = 2; }, "blend_space is 2"},
        {[](TxcLayerDef& d) { d.lock_alpha = 2; }, "lock_alpha is 2"},
        {[](TxcLayerDef& d) { d.filter = 9; }, "filter is 9"},
        {[](TxcLayerDef& d) { d.wrap = 3; }, "wrap is 3"},
        {[](TxcLayerDef& d) { d.flip_x = 2; }, "flip_x is 2"},
        {[](TxcLayerDef& d) { d.flip_y = 0xffffffffu; }, "flip_y is 4294967295"},
        {[](TxcLayerDef& d) { d.backfaces = 2; }, "backfaces is 2"},
        {[](TxcLayerDef& d) { d.occlusion = 5; }, "occlusion is 5"},
        {[](TxcLayerDef& d) { d.projector = 4; }, "projector is 4"},
        {[](TxcLayerDef& d) {
             d.angle_fade_start = 80;
             d.angle_fade_end = 60;
         },
         "angle_fade is 80 to 60"},
        {[](TxcLayerDef& d) { d.angle_fade_end = 91; }, "angle_fade is 70 to 91"},
        {[](TxcLayerDef& d) { d.angle_fade_start = -1; }, "angle_fade is -1"},
        {[=](TxcLayerDef& d) { d.angle_fade_start = nan; }, "angle_fade is "},
        {[=](TxcLayerDef& d) { d.position_model[1] = infinity; }, "position[1] is inf"},
        {[=](TxcLayerDef& d) { d.position_model[2] = nan; }, "position[2] is "},
        {[](TxcLayerDef& d) {
             for (float& part : d.rotation) part = 0;
         },
         "rotation (0, 0, 0, 0)"},
        {[=](TxcLayerDef& d) { d.rotation[0] = nan; }, "rotation ("},
        {[=](TxcLayerDef& d) { d.rotation[3] = infinity; }, "rotation ("},
        {[](TxcLayerDef& d) { d.size[0] = 0; }, "size[0] is 0"},
        {[](TxcLayerDef& d) { d.size[1] = -2; }, "size[1] is -2"},
        {[=](TxcLayerDef& d) { d.size[2] = infinity; }, "size[2] is inf"},
        {[](TxcLayerDef& d) { d.size[1] = 1e-45f; }, "size[1] is 1.4013e-45; it must be from 1e-12 to 1e+12"},
        {[=](TxcLayerDef& d) { d.size[2] = nan; }, "size[2] is "},
        {[](TxcLayerDef& d) { d.color[1] = 1.25f; }, "color[1] is 1.25"},
        {[=](TxcLayerDef& d) { d.color[3] = nan; }, "color[3] is "},
    };
    for (const Case& c : cases) {
        CAPTURE(std::string(c.said));
        TxcLayerDef def = good;
        c.spoil(def);
        CHECK(txc_layer_update(session.id(), handles.layer, &def) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(detail().find(c.said) != std::string::npos);
        TxcLayer layer = 0;
        CHECK(txc_layer_create(session.id(), handles.target, &def, &layer) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(layer == 0);
        const TxcLayerDef kept = session.layer_def(handles.layer);
        CHECK(std::memcmp(&kept, &good, sizeof good) == 0);
    }
    CHECK(session.update(handles.target).rect_count == 0);
}

TEST_CASE("A projector's own fields are checked, and no other's") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    const TxcLayerDef good = session.layer_def(handles.layer);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    struct Case {
        std::uint32_t projector;
        std::function<void(TxcLayerDef&)> spoil;
        const char* said;
    };
    const std::uint32_t slide = TXC_PROJECTOR_PERSPECTIVE;
    const std::uint32_t label = TXC_PROJECTOR_CYLINDRICAL;
    const std::uint32_t stamp = TXC_PROJECTOR_UV;
    const Case cases[] = {
        {slide, [=](TxcLayerDef& d) { d.position_model[0] = nan; }, "position[0] is "},
        {slide, [](TxcLayerDef& d) { d.rotation[3] = 0; }, "rotation (0, 0, 0, 0)"},
        {slide, [](TxcLayerDef& d) { d.fov_degrees = 0; }, "fov_degrees is 0"},
        {slide, [](TxcLayerDef& d) { d.fov_degrees = 180; }, "fov_degrees is 180"},
        {slide, [=](TxcLayerDef& d) { d.fov_degrees = nan; }, "fov_degrees is "},
        {slide, [](TxcLayerDef& d) { d.aspect = -1; }, "aspect is -1"},
        {slide, [=](TxcLayerDef& d) { d.aspect = infinity; }, "aspect is inf"},
        {slide, [](TxcLayerDef& d) { d.near_distance = 0; }, "near_distance is 0"},
        {slide, [=](TxcLayerDef& d) { d.near_distance = nan; }, "near_distance is "},
        {slide, [=](TxcLayerDef& d) { d.far_distance = infinity; }, "far_distance is inf"},
        {slide, [](TxcLayerDef& d) { d.far_distance = 0.0625f; },
         "far_distance is 0.0625; it must not be below near_distance, 0.1"},
        {label, [=](TxcLayerDef& d) { d.position_model[2] = infinity; }, "position[2] is inf"},
        {label, [=](TxcLayerDef& d) { d.rotation[1] = nan; }, "rotation ("},
        {label, [](TxcLayerDef& d) { d.radius = 0; }, "radius is 0"},
        {label, [=](TxcLayerDef& d) { d.radius = nan; }, "radius is "},
        {label, [](TxcLayerDef& d) { d.height = -3; }, "height is -3"},
        {label, [](TxcLayerDef& d) { d.arc_degrees = 0; }, "arc_degrees is 0"},
        {label, [](TxcLayerDef& d) { d.arc_degrees = 361; }, "arc_degrees is 361"},
        {label, [=](TxcLayerDef& d) { d.arc_degrees = nan; }, "arc_degrees is "},
        {label, [](TxcLayerDef& d) { d.depth = 0; }, "depth is 0"},
        {label, [=](TxcLayerDef& d) { d.depth = infinity; }, "depth is inf"},
        {stamp, [=](TxcLayerDef& d) { d.uv_center[1] = nan; }, "uv_center[1] is "},
        {stamp, [](TxcLayerDef& d) { d.uv_size[0] = 0; }, "uv_size[0] is 0"},
        {stamp, [](TxcLayerDef& d) { d.uv_size[1] = -2; }, "uv_size[1] is -2"},
        {stamp, [](TxcLayerDef& d) { d.uv_size[0] = 1e-13f; }, "uv_size[0] is 1e-13"},
        {stamp, [=](TxcLayerDef& d) { d.uv_angle_degrees = infinity; }, "uv_angle_degrees is inf"},
    };
    for (const Case& c : cases) {
        CAPTURE(std::string(c.said));
        TxcLayerDef def = good;
        def.projector = c.projector;
        c.spoil(def);
        CHECK(txc_layer_update(session.id(), handles.layer, &def) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(detail().find(c.said) != std::string::npos);
        const TxcLayerDef kept = session.layer_def(handles.layer);
        CHECK(std::memcmp(&kept, &good, sizeof good) == 0);
        // In a projector that does not read the field the value does no harm; position and rotation the stamp alone
        // does not read.
        for (const std::uint32_t other : {slide, label, stamp}) {
            const std::string said = c.said;
            const bool is_pose = said.find("position") == 0 || said.find("rotation") == 0;
            if (other == c.projector || (is_pose && other != stamp)) continue;
            def.projector = other;
            CHECK(txc_layer_update(session.id(), handles.layer, &def) == TXC_STATUS_OK);
            must(txc_layer_update(session.id(), handles.layer, &good));
        }
    }
    // What a planar box needs, the others do not.
    TxcLayerDef def = good;
    def.size[0] = -1;
    for (const std::uint32_t other : {slide, label, stamp}) {
        def.projector = other;
        CHECK(txc_layer_update(session.id(), handles.layer, &def) == TXC_STATUS_OK);
    }
}

TEST_CASE("Bad arguments of the other calls are named with their values") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    const TxcSession s = session.id();
    std::vector<std::uint8_t> bytes(16 * 16 * 4);
    std::vector<float> floats(16 * 16 * 3);
    TxcSessionDef session_def{0};
    TxcSession out = 0;
    const auto check = [](TxcStatus status, TxcStatus expected, const char* said) {
        const std::string text = detail();
        CAPTURE(std::string(said));
        CHECK(status == expected);
        CHECK(text.find(said) != std::string::npos);
    };
    check(txc_session_create(&session_def, &out), TXC_STATUS_BAD_ARGUMENT, "memory_budget_mib is 0");
    session_def.memory_budget_mib = 65537;
    check(txc_session_create(&session_def, &out), TXC_STATUS_BAD_ARGUMENT, "memory_budget_mib is 65537");
    TxcMaterialInfo info;
    check(txc_material_info(s, 1, &info), TXC_STATUS_NO_MATERIAL, "material is 1");
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.material = 9;
    TxcTarget target = 0;
    check(txc_target_create(s, &def, &target), TXC_STATUS_NO_MATERIAL, "material is 9");
    txc_target_def_default(&def);
    def.width = def.height = 64;
    def.mip_levels = 8;
    check(txc_target_create(s, &def, &target), TXC_STATUS_BAD_ARGUMENT, "mip_levels is 8; this size has at most 7");
    check(txc_map_read_positions(s, handles.target, 16, 1, floats.data()), TXC_STATUS_BAD_ARGUMENT, "rows 16 to 17");
    check(txc_map_read_coverage(s, handles.target, 0, 17, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "rows 0 to 17");
    check(txc_map_read_overlap(s, handles.target, 0xffffffffu, 2, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "rows");
    check(txc_map_view(s, handles.target, TXC_VIEW_COUNT, 0, 1, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "view is 4");
    check(txc_target_set_base(s, handles.target, 1, 1, bytes.data(), 2), TXC_STATUS_BAD_ARGUMENT, "filter is 2");
    check(txc_target_set_base_color(s, handles.target, 1, 256, 3, 4), TXC_STATUS_BAD_ARGUMENT, "channel 1 is 256");
    check(txc_target_read(s, handles.target, 1, 0, 0, 1, 1, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "level is 1");
    check(txc_target_read(s, handles.target, 0, 10, 0, 7, 1, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "10, 0, 7 x 1");
    check(txc_target_read(s, handles.target, 0, 0xffffffffu, 0, 2, 1, bytes.data()), TXC_STATUS_BAD_ARGUMENT, "region");
    std::uint32_t hash[2];
    check(txc_target_hash(s, handles.target, 0, 16, 1, 1, hash), TXC_STATUS_BAD_ARGUMENT, "region");
    const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const std::uint32_t indices[3] = {0, 1, 4};
    TxcMeshDef mesh{0, 0, 0};
    check(txc_model_add_mesh(s, &mesh, positions, nullptr, nullptr, nullptr), TXC_STATUS_BAD_ARGUMENT, "no positions");
    mesh = {4, 0, 0};
    check(txc_model_add_mesh(s, &mesh, positions, nullptr, nullptr, nullptr), TXC_STATUS_BAD_ARGUMENT, "4 corners");
    mesh = {4, 3, 1024};
    check(txc_model_add_mesh(s, &mesh, positions, nullptr, nullptr, indices), TXC_STATUS_BAD_ARGUMENT,
          "material is 1024");
    mesh = {4, 3, 0};
    check(txc_model_add_mesh(s, &mesh, positions, nullptr, nullptr, indices), TXC_STATUS_BAD_GEOMETRY, "index 2 is 4");
    // None of it touched the model.
    CHECK(session.map_info(handles.target).covered_texels == 256);
}
