// Handles and pointers that cross the C ABI: what is stale or null is said to be, and never followed (texelcast.h).
#include <doctest/doctest.h>

#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "support/one_of_each.h"

using namespace support;

namespace {

std::string detail() { return txc_error_detail(); }

/// A call that takes a session, with arguments that are good but for the handles.
struct Call {
    const char* name;
    std::function<TxcStatus(TxcSession)> run;
};

std::vector<Call> calls_on_model() {
    static float floats[4096 * 6];
    static const float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    return {
        {"txc_session_stats",
         [](TxcSession s) {
             TxcSessionStats stats;
             return txc_session_stats(s, &stats);
         }},
        {"txc_model_load_glb",
         [](TxcSession s) {
             const std::uint8_t byte = 0;
             return txc_model_load_glb(s, &byte, 1);
         }},
        {"txc_model_add_mesh",
         [](TxcSession s) {
             const TxcMeshDef def{3, 0, 0};
             return txc_model_add_mesh(s, &def, triangle, nullptr, nullptr, nullptr);
         }},
        {"txc_model_info",
         [](TxcSession s) {
             TxcModelInfo info;
             return txc_model_info(s, &info);
         }},
        {"txc_material_info",
         [](TxcSession s) {
             TxcMaterialInfo info;
             return txc_material_info(s, 0, &info);
         }},
        {"txc_material_uvs", [](TxcSession s) { return txc_material_uvs(s, 0, floats, 4096); }},
        {"txc_target_create",
         [](TxcSession s) {
             TxcTargetDef def;
             txc_target_def_default(&def);
             TxcTarget target;
             return txc_target_create(s, &def, &target);
         }},
        {"txc_image_create",
         [](TxcSession s) {
             const std::uint8_t pixel[4] = {1, 2, 3, 4};
             TxcImage image;
             return txc_image_create(s, 1, 1, pixel, &image);
         }},
    };
}

std::vector<Call> calls_on_target(TxcTarget target) {
    static std::vector<float> floats(64 * 64 * 3);
    static std::vector<std::uint8_t> bytes(64 * 64 * 4);
    return {
        {"txc_target_bake", [=](TxcSession s) { return txc_target_bake(s, target, 1, nullptr); }},
        {"txc_map_info",
         [=](TxcSession s) {
             TxcMapInfo info;
             return txc_map_info(s, target, &info);
         }},
        {"txc_map_read_positions",
         [=](TxcSession s) { return txc_map_read_positions(s, target, 0, 1, floats.data()); }},
        {"txc_map_read_normals", [=](TxcSession s) { return txc_map_read_normals(s, target, 0, 1, floats.data()); }},
        {"txc_map_read_coverage", [=](TxcSession s) { return txc_map_read_coverage(s, target, 0, 1, bytes.data()); }},
        {"txc_map_read_overlap", [=](TxcSession s) { return txc_map_read_overlap(s, target, 0, 1, bytes.data()); }},
        {"txc_map_view", [=](TxcSession s) { return txc_map_view(s, target, TXC_VIEW_NORMALS, 0, 1, bytes.data()); }},
        {"txc_target_set_base", [=](TxcSession s) { return txc_target_set_base(s, target, 1, 1, bytes.data(), 0); }},
        {"txc_target_set_base_color", [=](TxcSession s) { return txc_target_set_base_color(s, target, 1, 2, 3, 4); }},
        {"txc_layer_create",
         [=](TxcSession s) {
             const TxcLayerDef def = fill_def(1, 1, 1);
             TxcLayer layer;
             return txc_layer_create(s, target, &def, &layer);
         }},
        {"txc_target_update",
         [=](TxcSession s) {
             TxcUpdate update;
             return txc_target_update(s, target, TXC_NONE, &update);
         }},
        {"txc_target_read", [=](TxcSession s) { return txc_target_read(s, target, 0, 0, 0, 1, 1, bytes.data()); }},
        {"txc_target_read_bled", [=](TxcSession s) { return txc_target_read_bled(s, target, 0, 1, bytes.data()); }},
        {"txc_target_hash",
         [=](TxcSession s) {
             std::uint32_t hash[2];
             return txc_target_hash(s, target, 0, 0, 1, 1, hash);
         }},
        {"txc_zone_mask", [=](TxcSession s) { return txc_zone_mask(s, target, TXC_NONE, 0, 1, bytes.data()); }},
        {"txc_zone_surface",
         [=](TxcSession s) {
             TxcZoneSurface surface;
             return txc_zone_surface(s, target, TXC_NONE, &surface);
         }},
        {"txc_target_destroy", [=](TxcSession s) { return txc_target_destroy(s, target); }},
    };
}

std::vector<Call> calls_on_layer(TxcLayer layer) {
    return {
        {"txc_layer_def",
         [=](TxcSession s) {
             TxcLayerDef def;
             return txc_layer_def(s, layer, &def);
         }},
        {"txc_layer_update",
         [=](TxcSession s) {
             const TxcLayerDef def = fill_def(0, 1, 0);
             return txc_layer_update(s, layer, &def);
         }},
        {"txc_layer_move", [=](TxcSession s) { return txc_layer_move(s, layer, 0); }},
        {"txc_fill_set_gradient", [=](TxcSession s) { return txc_fill_set_gradient(s, layer, nullptr); }},
        {"txc_fill_set_triangles", [=](TxcSession s) { return txc_fill_set_triangles(s, layer, nullptr, 0); }},
        {"txc_stroke_add_dabs",
         [=](TxcSession s) {
             TxcDab dab;
             txc_dab_default(&dab);
             return txc_stroke_add_dabs(s, layer, &dab, 1);
         }},
        {"txc_stroke_clear", [=](TxcSession s) { return txc_stroke_clear(s, layer); }},
        {"txc_stroke_dab_count",
         [=](TxcSession s) {
             std::uint32_t count;
             return txc_stroke_dab_count(s, layer, &count);
         }},
        {"txc_stroke_dabs",
         [=](TxcSession s) {
             TxcDab dab;
             return txc_stroke_dabs(s, layer, 0, 0, &dab);
         }},
        {"txc_layer_metrics",
         [=](TxcSession s) {
             TxcLayerMetrics metrics;
             return txc_layer_metrics(s, &layer, 1, &metrics, nullptr);
         }},
        {"txc_layer_print_map",
         [=](TxcSession s) {
             float row[64];
             return txc_layer_print_map(s, layer, TXC_PRINT_MAP_TEXELS, 0, 1, row);
         }},
        {"txc_layer_destroy", [=](TxcSession s) { return txc_layer_destroy(s, layer); }},
    };
}

void check_stale(const std::vector<Call>& calls, TxcSession session) {
    for (const Call& call : calls) {
        CAPTURE(std::string(call.name));
        CHECK(call.run(session) == TXC_STATUS_STALE_HANDLE);
        CHECK_FALSE(detail().empty());
    }
}

}  // namespace

TEST_CASE("Null and destroyed sessions are stale everywhere") {
    TxcSessionDef def;
    txc_session_def_default(&def);
    TxcSession gone = 0;
    must(txc_session_create(&def, &gone));
    must(txc_session_destroy(gone));
    CHECK(txc_session_destroy(gone) == TXC_STATUS_STALE_HANDLE);
    for (const TxcSession session : {TxcSession{0}, gone, TxcSession{0xffffffffu}}) {
        check_stale(calls_on_model(), session);
        check_stale(calls_on_target(1), session);
        check_stale(calls_on_layer(1), session);
        CHECK(txc_image_destroy(session, 1) == TXC_STATUS_STALE_HANDLE);
        CHECK(txc_target_update_rects(session, 1) == nullptr);
        CHECK(txc_target_level(session, 1, 0) == nullptr);
    }
}

TEST_CASE("Targets, images and layers are stale once destroyed, and when the model changes") {
    TestSession session(make_plane());
    OneOfEach handles = make_one_of_each(session);
    must(txc_layer_destroy(session.id(), handles.layer));
    check_stale(calls_on_layer(handles.layer), session.id());
    must(txc_image_destroy(session.id(), handles.image));
    CHECK(txc_image_destroy(session.id(), handles.image) == TXC_STATUS_STALE_HANDLE);
    must(txc_target_destroy(session.id(), handles.target));
    check_stale(calls_on_target(handles.target), session.id());
    CHECK(txc_target_update_rects(session.id(), handles.target) == nullptr);

    // A target takes its layers with it.
    handles = make_one_of_each(session);
    must(txc_target_destroy(session.id(), handles.target));
    check_stale(calls_on_layer(handles.layer), session.id());

    // Another model takes both; images stay.
    handles = make_one_of_each(session);
    session.add(make_plane(1.0, 1.0));
    check_stale(calls_on_target(handles.target), session.id());
    check_stale(calls_on_layer(handles.layer), session.id());
    const TxcTarget target = session.target(16, 16);
    CHECK(session.layer(target, decal_def(handles.image)) != 0);
}

TEST_CASE("Handles of another session, and of another kind, are stale") {
    TestSession mine(make_plane());
    TestSession other(make_plane());
    const OneOfEach handles = make_one_of_each(other);
    make_one_of_each(mine);
    check_stale(calls_on_target(handles.target), mine.id());
    check_stale(calls_on_layer(handles.layer), mine.id());
    CHECK(txc_image_destroy(mine.id(), handles.image) == TXC_STATUS_STALE_HANDLE);
    check_stale(calls_on_target(handles.layer), other.id());
    check_stale(calls_on_layer(handles.target), other.id());
    // And they all still work where they belong.
    CHECK(other.paint(handles.target).width == 16);
}

TEST_CASE("A layer may not name a picture that is not there") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    TxcLayerDef def = decal_def(0xfffffff0u);
    TxcLayer layer = 0;
    CHECK(txc_layer_create(session.id(), handles.target, &def, &layer) == TXC_STATUS_STALE_HANDLE);
    CHECK(txc_layer_update(session.id(), handles.layer, &def) == TXC_STATUS_STALE_HANDLE);
    CHECK(session.layer_def(handles.layer).image == handles.image);
}

TEST_CASE("Null pointers are refused, not followed") {
    TestSession session(make_plane());
    const OneOfEach handles = make_one_of_each(session);
    const TxcSession s = session.id();
    TxcSession out_session = 0;
    TxcSessionDef session_def;
    txc_session_def_default(&session_def);
    TxcTargetDef target_def;
    txc_target_def_default(&target_def);
    const TxcMeshDef mesh_def{3, 0, 0};
    const TxcMeshDef indexed_def{3, 3, 0};
    const TxcLayerDef layer_def = fill_def(1, 1, 1);
    const float floats[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint8_t pixel[4] = {0, 0, 0, 0};
    std::uint32_t id = 0;
    const TxcStatus statuses[] = {
        txc_session_create(nullptr, &out_session),
        txc_session_create(&session_def, nullptr),
        txc_session_stats(s, nullptr),
        txc_model_load_glb(s, nullptr, 10),
        txc_model_add_mesh(s, nullptr, floats, nullptr, nullptr, nullptr),
        txc_model_add_mesh(s, &mesh_def, nullptr, nullptr, nullptr, nullptr),
        txc_model_add_mesh(s, &indexed_def, floats, nullptr, nullptr, nullptr),
        txc_model_info(s, nullptr),
        txc_material_info(s, 0, nullptr),
        txc_material_uvs(s, 0, nullptr, 10),
        txc_target_create(s, nullptr, &id),
        txc_target_create(s, &target_def, nullptr),
        txc_map_info(s, handles.target, nullptr),
        txc_map_read_positions(s, handles.target, 0, 1, nullptr),
        txc_map_read_normals(s, handles.target, 0, 1, nullptr),
        txc_map_read_coverage(s, handles.target, 0, 1, nullptr),
        txc_map_read_overlap(s, handles.target, 0, 1, nullptr),
        txc_map_view(s, handles.target, TXC_VIEW_POSITIONS, 0, 1, nullptr),
        txc_target_set_base(s, handles.target, 1, 1, nullptr, TXC_FILTER_LINEAR),
        txc_image_create(s, 1, 1, nullptr, &id),
        txc_image_create(s, 1, 1, pixel, nullptr),
        txc_layer_create(s, handles.target, nullptr, &id),
        txc_layer_create(s, handles.target, &layer_def, nullptr),
        txc_layer_update(s, handles.layer, nullptr),
        txc_layer_def(s, handles.layer, nullptr),
        txc_stroke_add_dabs(s, handles.layer, nullptr, 0),
        txc_stroke_dab_count(s, handles.layer, nullptr),
        txc_stroke_dabs(s, handles.layer, 0, 0, nullptr),
        txc_target_update(s, handles.target, TXC_NONE, nullptr),
        txc_target_read(s, handles.target, 0, 0, 0, 1, 1, nullptr),
        txc_target_read_bled(s, handles.target, 0, 1, nullptr),
        txc_target_hash(s, handles.target, 0, 0, 1, 1, nullptr),
        txc_session_set_zones(s, nullptr, 1, floats, 3),
        txc_zone_mask(s, handles.target, TXC_NONE, 0, 1, nullptr),
        txc_zone_surface(s, handles.target, TXC_NONE, nullptr),
        txc_layer_metrics(s, nullptr, 1, nullptr, nullptr),
        txc_layer_metrics(s, &handles.layer, 1, nullptr, nullptr),
        txc_layer_print_map(s, handles.layer, TXC_PRINT_MAP_TEXELS, 0, 1, nullptr),
    };
    for (std::size_t place_in_list = 0; place_in_list < std::size(statuses); ++place_in_list) {
        CAPTURE(place_in_list);
        CHECK(statuses[place_in_list] == TXC_STATUS_BAD_ARGUMENT);
    }
}
