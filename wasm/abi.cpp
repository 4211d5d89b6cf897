// The C ABI's functions: thin doors that find the session, check the pointers, and hand on.
#include <cstdlib>
#include <cstring>

#include "map_view.h"
#include "session.h"
#include "texelcast.h"

namespace {

using txc::fail;
using txc::Session;
using txc::Target;

txc::IdTable<Session>& sessions() {
    static txc::IdTable<Session> table;
    return table;
}

/// Empties the error detail, finds the session and runs `work` on it.
template <typename Work>
TxcStatus in_session(TxcSession id, Work&& work) {
    txc::error_detail().clear();
    Session* session = sessions().find(id);
    if (session == nullptr) return fail(TXC_STATUS_STALE_HANDLE, "there is no session %u", id);
    return work(*session);
}

/// The same for a call that needs a pointer of the caller's; `name` says which one is null.
template <typename Work>
TxcStatus in_session(TxcSession id, const void* pointer, const char* name, Work&& work) {
    return in_session(id, [&](Session& session) {
        if (pointer == nullptr) return fail(TXC_STATUS_BAD_ARGUMENT, "%s is null", name);
        return work(session);
    });
}

/// Runs `read(map)` for rows that lie inside a baked map.
template <typename Read>
TxcStatus read_map(TxcSession session, TxcTarget target_id, std::uint32_t row, std::uint32_t row_count, const void* out,
                   Read&& read) {
    return in_session(session, out, "out", [&](Session& s) {
        Target* target = nullptr;
        if (const TxcStatus status = s.find_baked(target_id, target); status != TXC_STATUS_OK) return status;
        const std::uint32_t height = target->def.height;
        if (row > height || row_count > height - row) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "rows %u to %u lie outside the map's %u", row, row + row_count,
                        height);
        }
        read(*target->map);
        return TXC_STATUS_OK;
    });
}

/// The level that a rectangle lies in, once an update has made it.
TxcStatus find_region(Session& session, TxcTarget id, std::uint32_t level, std::uint32_t x, std::uint32_t y,
                      std::uint32_t width, std::uint32_t height, const txc::MipLevel*& out_level) {
    Target* target = nullptr;
    if (const TxcStatus status = session.find_baked(id, target); status != TXC_STATUS_OK) return status;
    if (level >= target->output.levels.size()) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "level is %u; after an update the target has %zu", level,
                    target->output.levels.size());
    }
    const txc::MipLevel& mip = target->output.levels[level];
    if (x > mip.width || width > mip.width - x || y > mip.height || height > mip.height - y) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "the region %u, %u, %u x %u lies outside the level's %u x %u", x, y, width,
                    height, mip.width, mip.height);
    }
    out_level = &mip;
    return TXC_STATUS_OK;
}

void copy_vec3(const glm::vec3& from, float (&to)[3]) {
    for (int c = 0; c < 3; ++c) to[c] = from[c];
}

}  // namespace

extern "C" {

uint32_t txc_abi_version(void) { return TXC_ABI_VERSION; }
uint32_t txc_status_count(void) { return TXC_STATUS_COUNT; }

const char* txc_status_name(uint32_t status) {
    static const char* const names[] = {
#define TXC_STATUS_NAME(name, message) #name,
        TXC_STATUS_LIST(TXC_STATUS_NAME)
#undef TXC_STATUS_NAME
    };
    return status < TXC_STATUS_COUNT ? names[status] : "UNKNOWN";
}

const char* txc_status_message(uint32_t status) {
    static const char* const messages[] = {
#define TXC_STATUS_MESSAGE(name, message) message,
        TXC_STATUS_LIST(TXC_STATUS_MESSAGE)
#undef TXC_STATUS_MESSAGE
    };
    return status < TXC_STATUS_COUNT ? messages[status] : "UNKNOWN";
}

const char* txc_error_detail(void) { return txc::error_detail().c_str(); }

void* txc_alloc(uint32_t byte_count) { return std::malloc(byte_count > 0 ? byte_count : 1); }
void txc_free(void* memory) { std::free(memory); }

// ---- Session ----------------------------------------------------------------------------------------------------------

void txc_session_def_default(TxcSessionDef* def) {
    if (def != nullptr) *def = TxcSessionDef{1024};
}

TxcStatus txc_session_create(const TxcSessionDef* def, TxcSession* out_session) {
    txc::error_detail().clear();
    if (def == nullptr || out_session == nullptr) return fail(TXC_STATUS_BAD_ARGUMENT, "def or out_session is null");
    if (def->memory_budget_mib == 0 || def->memory_budget_mib > 65536) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "memory_budget_mib is %u; it must be from 1 to 65536",
                    def->memory_budget_mib);
    }
    *out_session = sessions().add(std::make_unique<Session>(*def));
    return *out_session != 0 ? TXC_STATUS_OK : fail(TXC_STATUS_BAD_ARGUMENT, "there are too many sessions");
}

TxcStatus txc_session_destroy(TxcSession session) {
    return in_session(session, [&](Session&) {
        sessions().remove(session);
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_session_stats(TxcSession session, TxcSessionStats* out_stats) {
    return in_session(session, out_stats, "out_stats", [&](Session& s) {
        *out_stats = s.stats();
        return TXC_STATUS_OK;
    });
}

// ---- Model ------------------------------------------------------------------------------------------------------------

TxcStatus txc_model_load_glb(TxcSession session, const uint8_t* bytes, uint32_t byte_count) {
    return in_session(session, bytes, "bytes", [&](Session& s) { return s.load_glb(bytes, byte_count); });
}

void txc_mesh_def_default(TxcMeshDef* def) {
    if (def != nullptr) *def = TxcMeshDef{};
}

TxcStatus txc_model_add_mesh(TxcSession session, const TxcMeshDef* def, const float* positions_model,
                             const float* normals_model, const float* uvs, const uint32_t* indices) {
    return in_session(session, def, "def",
                      [&](Session& s) { return s.add_mesh(*def, positions_model, normals_model, uvs, indices); });
}

TxcStatus txc_model_info(TxcSession session, TxcModelInfo* out_info) {
    return in_session(session, out_info, "out_info", [&](Session& s) {
        const txc::Mesh* mesh = s.mesh();
        if (mesh == nullptr) return fail(TXC_STATUS_NO_MODEL, "load a model first");
        out_info->material_count = static_cast<uint32_t>(mesh->materials.size());
        out_info->triangle_count = static_cast<uint32_t>(mesh->triangles.size());
        out_info->vertex_count = static_cast<uint32_t>(mesh->positions.size());
        out_info->has_default_material = mesh->has_default_material ? 1 : 0;
        copy_vec3(mesh->bounds.min, out_info->bounds_min_model);
        copy_vec3(mesh->bounds.max, out_info->bounds_max_model);
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_material_info(TxcSession session, uint32_t index, TxcMaterialInfo* out_info) {
    return in_session(session, out_info, "out_info", [&](Session& s) {
        const txc::Material* material = nullptr;
        if (const TxcStatus status = s.find_material(index, material); status != TXC_STATUS_OK) return status;
        // The reason itself is part of the answer, its detail stays readable by txc_error_detail.
        out_info->paint_status = material->paint_status(index);
        out_info->triangle_count = static_cast<uint32_t>(material->triangles.size());
        out_info->degenerate_uv_triangles = material->degenerate_uv_triangles;
        out_info->out_of_range_uv_triangles = material->out_of_range_uv_triangles;
        out_info->tex_coord = material->tex_coord;
        out_info->image = material->image;
        out_info->nearest_filter = material->nearest_filter ? 1 : 0;
        for (int c = 0; c < 4; ++c) out_info->base_color_factor[c] = material->base_color_factor[c];
        for (int c = 0; c < 2; ++c) {
            out_info->uv_min[c] = material->uv_min[c];
            out_info->uv_max[c] = material->uv_max[c];
        }
        copy_vec3(material->bounds.min, out_info->bounds_min_model);
        copy_vec3(material->bounds.max, out_info->bounds_max_model);
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_material_uvs(TxcSession session, uint32_t index, float* out_uvs, uint32_t capacity) {
    return in_session(session, out_uvs, "out_uvs", [&](Session& s) {
        const txc::Material* material = nullptr;
        if (const TxcStatus status = s.find_material(index, material); status != TXC_STATUS_OK) return status;
        if (capacity < material->triangles.size()) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "capacity is %u; the material has %zu triangles", capacity,
                        material->triangles.size());
        }
        for (const uint32_t triangle : material->triangles) {
            for (const uint32_t vertex : s.mesh()->triangles[triangle].vertex) {
                *out_uvs++ = s.mesh()->uvs[vertex].x;
                *out_uvs++ = s.mesh()->uvs[vertex].y;
            }
        }
        return TXC_STATUS_OK;
    });
}

// ---- Target and bake --------------------------------------------------------------------------------------------------

void txc_target_def_default(TxcTargetDef* def) {
    if (def != nullptr) *def = TxcTargetDef{0, 1024, 1024, TXC_NONE, 1};
}

TxcStatus txc_target_create(TxcSession session, const TxcTargetDef* def, TxcTarget* out_target) {
    return in_session(session, def != nullptr ? out_target : nullptr, "def or out_target",
                      [&](Session& s) { return s.create_target(*def, *out_target); });
}

TxcStatus txc_target_bake(TxcSession session, TxcTarget target, uint32_t work_limit, float* out_progress) {
    return in_session(session, [&](Session& s) {
        float progress = 0.0f;
        const TxcStatus status = s.bake(target, work_limit, progress);
        if (out_progress != nullptr) *out_progress = progress;
        return status;
    });
}

TxcStatus txc_target_destroy(TxcSession session, TxcTarget target) {
    return in_session(session, [&](Session& s) { return s.destroy_target(target); });
}

TxcStatus txc_map_info(TxcSession session, TxcTarget id, TxcMapInfo* out_info) {
    return in_session(session, out_info, "out_info", [&](Session& s) {
        Target* target = nullptr;
        if (const TxcStatus status = s.find_baked(id, target); status != TXC_STATUS_OK) return status;
        const txc::LocalSpaceMap& map = *target->map;
        out_info->width = map.key.width;
        out_info->height = map.key.height;
        out_info->gutter = map.key.gutter;
        out_info->covered_texels = map.covered_texels;
        out_info->gutter_texels = map.gutter_texels;
        out_info->overlapping_texels = map.overlapping_texels;
        out_info->byte_count = static_cast<uint32_t>(map.byte_count());
        out_info->mip_levels = target->def.mip_levels;
        copy_vec3(map.bounds.min, out_info->bounds_min_model);
        copy_vec3(map.bounds.max, out_info->bounds_max_model);
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_map_read_positions(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count, float* out) {
    return read_map(session, target, row, row_count, out,
                    [&](const txc::LocalSpaceMap& map) { map.read_positions(row, row_count, out); });
}

TxcStatus txc_map_read_normals(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count, float* out) {
    return read_map(session, target, row, row_count, out,
                    [&](const txc::LocalSpaceMap& map) { map.read_normals(row, row_count, out); });
}

TxcStatus txc_map_read_coverage(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count, uint8_t* out) {
    return read_map(session, target, row, row_count, out,
                    [&](const txc::LocalSpaceMap& map) { map.read_coverage(row, row_count, out); });
}

TxcStatus txc_map_read_overlap(TxcSession session, TxcTarget target, uint32_t row, uint32_t row_count, uint8_t* out) {
    return read_map(session, target, row, row_count, out,
                    [&](const txc::LocalSpaceMap& map) { map.read_overlap(row, row_count, out); });
}

TxcStatus txc_map_view(TxcSession session, TxcTarget target, uint32_t view, uint32_t row, uint32_t row_count,
                       uint8_t* out_rgba) {
    if (view >= TXC_VIEW_COUNT) return fail(TXC_STATUS_BAD_ARGUMENT, "view is %u; there are %d", view, TXC_VIEW_COUNT);
    return read_map(session, target, row, row_count, out_rgba,
                    [&](const txc::LocalSpaceMap& map) { txc::draw_map_view(map, view, row, row_count, out_rgba); });
}

// ---- Base and images --------------------------------------------------------------------------------------------------

TxcStatus txc_target_set_base(TxcSession session, TxcTarget target, uint32_t width, uint32_t height,
                              const uint8_t* rgba, uint32_t filter) {
    return in_session(session, [&](Session& s) {
        if (filter >= TXC_FILTER_COUNT)
            return fail(TXC_STATUS_BAD_ARGUMENT, "filter is %u; there are %d", filter, TXC_FILTER_COUNT);
        return s.set_base(target, width, height, rgba, filter == TXC_FILTER_NEAREST);
    });
}

TxcStatus txc_target_set_base_color(TxcSession session, TxcTarget target, uint32_t red, uint32_t green, uint32_t blue,
                                    uint32_t alpha) {
    return in_session(session, [&](Session& s) {
        const uint32_t channels[4] = {red, green, blue, alpha};
        uint8_t rgba[4];
        for (int c = 0; c < 4; ++c) {
            if (channels[c] > 255)
                return fail(TXC_STATUS_BAD_ARGUMENT, "channel %d is %u; it must be at most 255", c, channels[c]);
            rgba[c] = static_cast<uint8_t>(channels[c]);
        }
        return s.set_base_color(target, rgba);
    });
}

TxcStatus txc_image_create(TxcSession session, uint32_t width, uint32_t height, const uint8_t* rgba,
                           TxcImage* out_image) {
    return in_session(session, out_image, "out_image",
                      [&](Session& s) { return s.create_image(width, height, rgba, *out_image); });
}

TxcStatus txc_image_destroy(TxcSession session, TxcImage image) {
    return in_session(session, [&](Session& s) { return s.destroy_image(image); });
}

// ---- Layers -----------------------------------------------------------------------------------------------------------

void txc_layer_def_default(TxcLayerDef* def) {
    if (def == nullptr) return;
    *def = TxcLayerDef{};
    def->kind = TXC_LAYER_DECAL;
    def->visible = 1;
    def->opacity = 1.0f;
    def->angle_fade_start = 70.0f;
    def->angle_fade_end = 90.0f;
    def->occlusion = TXC_OCCLUSION_SELF;
    def->rotation[3] = 1.0f;
    for (float& extent : def->size) extent = 1.0f;
    def->fov_degrees = 45.0f;
    def->aspect = 1.0f;
    def->near_distance = 0.1f;
    def->far_distance = 100.0f;
    def->radius = 0.5f;
    def->height = 1.0f;
    def->arc_degrees = 180.0f;
    def->depth = 0.1f;
    for (float& coordinate : def->uv_center) coordinate = 0.5f;
    for (float& extent : def->uv_size) extent = 1.0f;
    def->color[3] = 1.0f;
    def->hardness = 1.0f;
    def->flow = 1.0f;
}

TxcStatus txc_layer_create(TxcSession session, TxcTarget target, const TxcLayerDef* def, TxcLayer* out_layer) {
    return in_session(session, def != nullptr ? out_layer : nullptr, "def or out_layer",
                      [&](Session& s) { return s.create_layer(target, *def, *out_layer); });
}

TxcStatus txc_layer_update(TxcSession session, TxcLayer layer, const TxcLayerDef* def) {
    return in_session(session, def, "def", [&](Session& s) { return s.update_layer(layer, *def); });
}

TxcStatus txc_layer_move(TxcSession session, TxcLayer layer, uint32_t index) {
    return in_session(session, [&](Session& s) { return s.move_layer(layer, index); });
}

TxcStatus txc_layer_destroy(TxcSession session, TxcLayer layer) {
    return in_session(session, [&](Session& s) { return s.destroy_layer(layer); });
}

TxcStatus txc_layer_def(TxcSession session, TxcLayer id, TxcLayerDef* out_def) {
    return in_session(session, out_def, "out_def", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_layer(id, layer); status != TXC_STATUS_OK) return status;
        *out_def = layer->def;
        return TXC_STATUS_OK;
    });
}

// ---- Fills ------------------------------------------------------------------------------------------------------------

void txc_gradient_default(TxcGradient* gradient) {
    if (gradient == nullptr) return;
    *gradient = TxcGradient{};
    gradient->to_model[1] = 1.0f;
    gradient->radius = 1.0f;
    gradient->stop_count = 2;
    gradient->offsets[1] = 1.0f;
    gradient->colors[3] = 1.0f;
    for (int c = 4; c < 8; ++c) gradient->colors[c] = 1.0f;
}

TxcStatus txc_fill_set_gradient(TxcSession session, TxcLayer layer, const TxcGradient* gradient) {
    return in_session(session, [&](Session& s) { return s.set_gradient(layer, gradient); });
}

TxcStatus txc_fill_set_triangles(TxcSession session, TxcLayer layer, const uint32_t* triangles,
                                 uint32_t triangle_count) {
    return in_session(session, [&](Session& s) { return s.set_triangles(layer, triangles, triangle_count); });
}

// ---- Strokes ----------------------------------------------------------------------------------------------------------

void txc_dab_default(TxcDab* dab) {
    if (dab == nullptr) return;
    TxcLayerDef def;
    txc_layer_def_default(&def);
    *dab = txc::dab_from_def(def);
}

TxcStatus txc_stroke_add_dabs(TxcSession session, TxcLayer layer, const TxcDab* dabs, uint32_t dab_count) {
    return in_session(session, dabs, "dabs", [&](Session& s) { return s.add_dabs(layer, dabs, dab_count); });
}

TxcStatus txc_stroke_clear(TxcSession session, TxcLayer layer) {
    return in_session(session, [&](Session& s) { return s.clear_dabs(layer); });
}

TxcStatus txc_stroke_dab_count(TxcSession session, TxcLayer id, uint32_t* out_count) {
    return in_session(session, out_count, "out_count", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_stroke(id, layer); status != TXC_STATUS_OK) return status;
        *out_count = static_cast<uint32_t>(layer->stroke.dabs.size());
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_stroke_dabs(TxcSession session, TxcLayer id, uint32_t first, uint32_t dab_count, TxcDab* out_dabs) {
    return in_session(session, out_dabs, "out_dabs", [&](Session& s) {
        txc::Layer* layer = nullptr;
        if (const TxcStatus status = s.find_stroke(id, layer); status != TXC_STATUS_OK) return status;
        const std::vector<TxcDab>& dabs = layer->stroke.dabs;
        if (first > dabs.size() || dab_count > dabs.size() - first) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "dabs %u and %u more: the stroke has %zu", first, dab_count,
                        dabs.size());
        }
        for (uint32_t i = 0; i < dab_count; ++i) out_dabs[i] = dabs[first + i];
        return TXC_STATUS_OK;
    });
}

// ---- Update and read --------------------------------------------------------------------------------------------------

TxcStatus txc_target_update(TxcSession session, TxcTarget target, TxcUpdate* out_update) {
    return in_session(session, out_update, "out_update",
                      [&](Session& s) { return s.update_target(target, *out_update); });
}

const TxcRect* txc_target_update_rects(TxcSession session, TxcTarget id) {
    Target* target = nullptr;
    const TxcStatus status = in_session(session, [&](Session& s) { return s.find_target(id, target); });
    return status == TXC_STATUS_OK && !target->rects.empty() ? target->rects.data() : nullptr;
}

const uint8_t* txc_target_update_bytes(TxcSession session, TxcTarget id) {
    Target* target = nullptr;
    const TxcStatus status = in_session(session, [&](Session& s) { return s.find_target(id, target); });
    return status == TXC_STATUS_OK && !target->packed.empty() ? target->packed.data() : nullptr;
}

TxcStatus txc_target_read(TxcSession session, TxcTarget target, uint32_t level, uint32_t x, uint32_t y, uint32_t width,
                          uint32_t height, uint8_t* out_rgba) {
    return in_session(session, out_rgba, "out_rgba", [&](Session& s) {
        const txc::MipLevel* mip = nullptr;
        if (const TxcStatus status = find_region(s, target, level, x, y, width, height, mip); status != TXC_STATUS_OK)
            return status;
        for (uint32_t row = 0; row < height; ++row) {
            std::memcpy(out_rgba + static_cast<std::size_t>(row) * width * 4,
                        mip->rgba.data() + (static_cast<std::size_t>(y + row) * mip->width + x) * 4,
                        static_cast<std::size_t>(width) * 4);
        }
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_target_read_bled(TxcSession session, TxcTarget id, uint32_t row, uint32_t row_count, uint8_t* out_rgba) {
    return in_session(session, out_rgba, "out_rgba", [&](Session& s) {
        const txc::MipLevel* mip = nullptr;
        if (const TxcStatus status = find_region(s, id, 0, 0, row, 0, row_count, mip); status != TXC_STATUS_OK)
            return status;
        Target* target = nullptr;
        if (const TxcStatus status = s.find_bleed(id, target); status != TXC_STATUS_OK) return status;
        txc::read_bled_rows(*target, row, row_count, out_rgba);
        return TXC_STATUS_OK;
    });
}

TxcStatus txc_target_hash(TxcSession session, TxcTarget target, uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                          uint32_t* out_hash) {
    return in_session(session, out_hash, "out_hash", [&](Session& s) {
        const txc::MipLevel* mip = nullptr;
        if (const TxcStatus status = find_region(s, target, 0, x, y, width, height, mip); status != TXC_STATUS_OK)
            return status;
        uint64_t hash = 14695981039346656037ull;  // FNV-1a (Fowler, Noll, Vo)
        for (uint32_t row = y; row < y + height; ++row) {
            const uint8_t* at = mip->rgba.data() + (static_cast<std::size_t>(row) * mip->width + x) * 4;
            for (std::size_t i = 0; i < static_cast<std::size_t>(width) * 4; ++i)
                hash = (hash ^ at[i]) * 1099511628211ull;
        }
        out_hash[0] = static_cast<uint32_t>(hash);
        out_hash[1] = static_cast<uint32_t>(hash >> 32);
        return TXC_STATUS_OK;
    });
}

}  // extern "C"
