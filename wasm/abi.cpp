// The C ABI's functions: thin doors that find the session, check the pointers, and hand on. Here: the module, sessions and
// models.
#include <cstdlib>

#include "abi_door.h"

txc::IdTable<txc::Session>& txc::abi_sessions() {
    static IdTable<Session> table;
    return table;
}

namespace {

using txc::fail;
using txc::in_session;
using txc::Session;

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
    *out_session = txc::abi_sessions().add(std::make_unique<Session>(*def));
    return *out_session != 0 ? TXC_STATUS_OK : fail(TXC_STATUS_BAD_ARGUMENT, "there are too many sessions");
}

TxcStatus txc_session_destroy(TxcSession session) {
    return in_session(session, [&](Session&) {
        txc::abi_sessions().remove(session);
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
        txc::copy_point(mesh->origin, mesh->bounds.min, out_info->bounds_min_model);
        txc::copy_point(mesh->origin, mesh->bounds.max, out_info->bounds_max_model);
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
        txc::copy_point(s.mesh()->origin, material->bounds.min, out_info->bounds_min_model);
        txc::copy_point(s.mesh()->origin, material->bounds.max, out_info->bounds_max_model);
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

}  // extern "C"
