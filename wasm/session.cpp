#include "session.h"

#include <algorithm>
#include <cstring>

#include "exact_math.h"
#include "gltf_reader.h"
#include "gutter.h"

namespace txc {
namespace {

// Maps that no target uses any more but that a user who flips between two sizes will want again.
constexpr std::size_t kSpareMaps = 2;
constexpr std::uint32_t kMaxRawMaterials = 1024;

MapKey key_of(const TxcTargetDef& def) {
    MapKey key{def.material, def.width, def.height, def.gutter};
    if (def.texture_width == def.width && def.texture_height == def.height) return key;
    key.whole_width = def.texture_width;
    key.whole_height = def.texture_height;
    key.origin_x = def.window_x;
    key.origin_y = def.window_y;
    return key;
}

/// Sets the texture's size where it is the target's own. Errors: BAD_SIZE, BAD_ARGUMENT.
TxcStatus complete_window(TxcTargetDef& def) {
    if (def.texture_width == 0 && def.texture_height == 0) {
        def.texture_width = def.width;
        def.texture_height = def.height;
    }
    if (def.texture_width > TXC_MAX_TEXTURE_SIZE || def.texture_height > TXC_MAX_TEXTURE_SIZE) {
        return fail(TXC_STATUS_BAD_SIZE, "the texture is %u x %u; each side must be at most %u", def.texture_width,
                    def.texture_height, TXC_MAX_TEXTURE_SIZE);
    }
    if (def.window_x % kTileSize != 0 || def.window_y % kTileSize != 0) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "the window begins at %u, %u; both must be multiples of %u", def.window_x,
                    def.window_y, kTileSize);
    }
    if (def.window_x > def.texture_width || def.width > def.texture_width - def.window_x ||
        def.window_y > def.texture_height || def.height > def.texture_height - def.window_y) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "the window of %u x %u at %u, %u reaches beyond the texture's %u x %u",
                    def.width, def.height, def.window_x, def.window_y, def.texture_width, def.texture_height);
    }
    const bool is_whole = def.width == def.texture_width && def.height == def.texture_height;
    if (!is_whole && def.mip_levels != 1)
        return fail(TXC_STATUS_BAD_ARGUMENT, "mip_levels is %u; a window of a texture has 1", def.mip_levels);
    return TXC_STATUS_OK;
}

TxcStatus check_size(std::uint32_t width, std::uint32_t height) {
    if (width >= 1 && width <= TXC_MAX_SIZE && height >= 1 && height <= TXC_MAX_SIZE) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_SIZE, "the size is %u x %u; each side must be from 1 to %u", width, height,
                TXC_MAX_SIZE);
}

}  // namespace

Session::Session(const TxcSessionDef& def)
    : budget_(static_cast<std::uint64_t>(def.memory_budget_mib) << 20), mesh_share_(budget_) {
    nothing_.def.visible = 1;
    nothing_.def.opacity = 1.0f;
    budget_.on_shortage([this] { give_back(); });
}

void Session::give_back() {
    occluders_.reset();
    targets_.for_each([](TxcTarget, Target& target) { target.backdrops.forget(); });
    layers_.for_each([](TxcLayer, Layer& layer) {
        // One whose texels are to be made anew has none, or the very ones for which there is no room.
        if (layer.def.visible != 0 || layer.needs_projection || layer.tiles.indices.empty()) return;
        release_tiles(layer.tiles);
        layer.needs_projection = true;
    });
}

TxcSessionStats Session::stats() const {
    TxcSessionStats stats{};
    stats.bake_count = bake_count_;
    stats.projection_count = projection_count_;
    stats.projected_texels = projected_texels_;
    stats.composited_texels = composited_texels_;
    stats.memory_used_kib = static_cast<std::uint32_t>(budget_.used() >> 10);
    stats.memory_peak_kib = static_cast<std::uint32_t>(budget_.peak() >> 10);
    stats.memory_budget_kib = static_cast<std::uint32_t>(std::min<std::uint64_t>(budget_.limit() >> 10, 0xffffffffu));
    return stats;
}

// ---- Model ------------------------------------------------------------------------------------------------------------

void Session::forget_model() {
    targets_.clear();
    layers_.clear();
    maps_.clear();
    occluders_.reset();
    occlusion_.reset();
}

TxcStatus Session::load_glb(const std::uint8_t* bytes, std::uint32_t byte_count) {
    auto mesh = std::make_unique<Mesh>();
    if (const TxcStatus status = read_gltf(bytes, byte_count, budget_, *mesh); status != TXC_STATUS_OK) return status;
    BudgetShare share(budget_);
    if (const TxcStatus status = share.resize(mesh->size().byte_count(), "the model"); status != TXC_STATUS_OK)
        return status;
    forget_model();
    mesh_ = std::move(mesh);
    mesh_share_ = std::move(share);
    return TXC_STATUS_OK;
}

TxcStatus Session::add_mesh(const TxcMeshDef& def, const float* positions, const float* normals, const float* uvs,
                            const std::uint32_t* indices) {
    if (positions == nullptr || def.vertex_count == 0)
        return fail(TXC_STATUS_BAD_ARGUMENT, "the mesh has no positions");
    if (def.index_count > 0 && indices == nullptr)
        return fail(TXC_STATUS_BAD_ARGUMENT, "index_count is %u, but there are no indices", def.index_count);
    const std::uint32_t corner_count = def.index_count > 0 ? def.index_count : def.vertex_count;
    if (corner_count % 3 != 0)
        return fail(TXC_STATUS_BAD_ARGUMENT, "%u corners do not make whole triangles", corner_count);
    if (def.material >= kMaxRawMaterials)
        return fail(TXC_STATUS_BAD_ARGUMENT, "material is %u; it must be below %u", def.material, kMaxRawMaterials);
    MeshSize filled = mesh_ != nullptr ? mesh_->size() : MeshSize{};
    const MeshSize size{filled.vertices + def.vertex_count, filled.triangles + corner_count / 3};
    BudgetShare share(budget_);
    if (const TxcStatus status = share.resize(size.byte_count(), "the mesh"); status != TXC_STATUS_OK) return status;
    auto mesh = mesh_ != nullptr ? std::make_unique<Mesh>(*mesh_) : std::make_unique<Mesh>();
    mesh->resize(size);
    std::vector<std::uint32_t> in_order;
    if (def.index_count == 0) {
        in_order.resize(corner_count);
        for (std::uint32_t i = 0; i < corner_count; ++i) in_order[i] = i;
        indices = in_order.data();
    }
    PrimitiveArrays arrays;
    arrays.positions = reinterpret_cast<const glm::vec3*>(positions);
    arrays.normals = reinterpret_cast<const glm::vec3*>(normals);
    arrays.uvs = reinterpret_cast<const glm::vec2*>(uvs);
    arrays.vertex_count = def.vertex_count;
    arrays.indices = indices;
    arrays.index_count = corner_count;
    arrays.material = def.material;
    if (mesh->materials.size() <= def.material) mesh->materials.resize(def.material + 1);
    const MeshSize before = filled;
    do {
        filled = before;
        arrays.origin = mesh->origin;
        if (const TxcStatus status = place_primitive(*mesh, filled, arrays, "the mesh"); status != TXC_STATUS_OK)
            return status;
        mesh->summarise();
        // The first mesh's origin serves for those that come to it: from anywhere in a model, floats are fine steps of it.
    } while (before.vertices == 0 && mesh->come_near());
    forget_model();
    mesh_ = std::move(mesh);
    mesh_share_ = std::move(share);
    return TXC_STATUS_OK;
}

TxcStatus Session::find_material(std::uint32_t material, const Material*& out_material) const {
    if (mesh_ == nullptr) return fail(TXC_STATUS_NO_MODEL, "load a model first");
    if (material >= mesh_->materials.size()) {
        return fail(TXC_STATUS_NO_MATERIAL, "material is %u; the model has %zu, counted from 0", material,
                    mesh_->materials.size());
    }
    out_material = &mesh_->materials[material];
    return TXC_STATUS_OK;
}

// ---- Targets ----------------------------------------------------------------------------------------------------------

TxcStatus Session::create_target(const TxcTargetDef& asked, TxcTarget& out_target) {
    TxcTargetDef def = asked;
    const Material* material = nullptr;
    if (const TxcStatus status = find_material(def.material, material); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_size(def.width, def.height); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = complete_window(def); status != TXC_STATUS_OK) return status;
    if (def.gutter == TXC_NONE) def.gutter = default_gutter(def.texture_width, def.texture_height);
    if (def.gutter > kMaxGutter)
        return fail(TXC_STATUS_BAD_ARGUMENT, "gutter is %u; it must be at most %u texels", def.gutter, kMaxGutter);
    const std::uint32_t full_chain = MipChain::full_count(def.width, def.height);
    if (def.mip_levels == 0) def.mip_levels = full_chain;
    if (def.mip_levels > full_chain)
        return fail(TXC_STATUS_BAD_ARGUMENT, "mip_levels is %u; this size has at most %u", def.mip_levels, full_chain);
    if (const TxcStatus status = material->paint_status(def.material); status != TXC_STATUS_OK) return status;

    auto target = std::make_unique<Target>(def, budget_);
    if (const TxcStatus status = begin_map(*target); status != TXC_STATUS_OK) return status;
    for (int c = 0; c < 4; ++c) {
        const auto factor = static_cast<double>(material->base_color_factor[c]);
        target->base.color[c] = to_byte(c < 3 ? linear_to_srgb(factor) : factor);
    }
    out_target = targets_.add(std::move(target));
    return out_target != 0 ? TXC_STATUS_OK : fail(TXC_STATUS_BAD_ARGUMENT, "there are too many targets");
}

TxcStatus Session::begin_map(Target& target) {
    const MapKey key = key_of(target.def);
    target.map = cached_map(key);
    if (target.map != nullptr) return TXC_STATUS_OK;
    TxcStatus status = MapBaker::begin(*mesh_, key, budget_, target.baker);
    if (status == TXC_STATUS_OUT_OF_BUDGET) {
        drop_unused_maps(0);
        status = MapBaker::begin(*mesh_, key, budget_, target.baker);
    }
    if (status == TXC_STATUS_OK) error_detail().clear();
    return status;
}

std::shared_ptr<LocalSpaceMap> Session::cached_map(const MapKey& key) const {
    for (const auto& map : maps_) {
        if (map->key == key) return map;
    }
    return nullptr;
}

bool Session::drop_unused_maps(std::size_t keep) {
    const std::size_t held = maps_.size();
    std::size_t unused = 0;
    for (const auto& map : maps_) unused += map.use_count() == 1 ? 1 : 0;
    for (auto map = maps_.begin(); map != maps_.end() && unused > keep;) {
        if (map->use_count() == 1) {
            map = maps_.erase(map);
            --unused;
        } else {
            ++map;
        }
    }
    return maps_.size() < held;
}

TxcStatus Session::bake(TxcTarget id, std::uint32_t work_limit, float& out_progress) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(id, target); status != TXC_STATUS_OK) return status;
    out_progress = 1.0f;
    if (target->map != nullptr) return TXC_STATUS_OK;
    // Another target of the same key may have finished its bake meanwhile.
    target->map = cached_map(key_of(target->def));
    if (target->map != nullptr) {
        target->baker.reset();
        return TXC_STATUS_OK;
    }
    if (target->baker == nullptr) {
        if (const TxcStatus status = begin_map(*target); status != TXC_STATUS_OK) return status;
    }
    const TxcStatus status = target->baker->step(work_limit);
    out_progress = target->baker->progress();
    if (status == TXC_STATUS_PENDING) return status;
    if (status != TXC_STATUS_OK) {
        // It stopped in mid-row, with texels left out: the next call begins anew.
        target->baker.reset();
        if (status != TXC_STATUS_OUT_OF_BUDGET || !drop_unused_maps(0)) return status;
        // What took its room was kept only in case that it is asked for again.
        out_progress = 0.0f;
        const TxcStatus again = begin_map(*target);
        return again == TXC_STATUS_OK ? TXC_STATUS_PENDING : again;
    }
    target->map = target->baker->take();
    target->baker.reset();
    maps_.push_back(target->map);
    ++bake_count_;
    drop_unused_maps(kSpareMaps);
    return TXC_STATUS_OK;
}

TxcStatus Session::destroy_target(TxcTarget id) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(id, target); status != TXC_STATUS_OK) return status;
    remove_layers(target->order);
    targets_.remove(id);
    drop_unused_maps(kSpareMaps);
    return TXC_STATUS_OK;
}

TxcStatus Session::find_target(TxcTarget id, Target*& out_target) const {
    out_target = targets_.find(id);
    return out_target != nullptr ? TXC_STATUS_OK : fail(TXC_STATUS_STALE_HANDLE, "there is no target %u", id);
}

TxcStatus Session::find_baked(TxcTarget id, Target*& out_target) const {
    if (const TxcStatus status = find_target(id, out_target); status != TXC_STATUS_OK) return status;
    return out_target->map != nullptr ? TXC_STATUS_OK
                                      : fail(TXC_STATUS_NOT_BAKED, "call txc_target_bake until it says OK");
}

TxcStatus Session::set_base(TxcTarget id, std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba,
                            bool nearest) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(id, target); status != TXC_STATUS_OK) return status;
    if (const TxcStatus status = check_size(width, height); status != TXC_STATUS_OK) return status;
    if (rgba == nullptr) return fail(TXC_STATUS_BAD_ARGUMENT, "rgba is null");
    const std::uint64_t bytes = static_cast<std::uint64_t>(target->def.width) * target->def.height * 4;
    if (const TxcStatus status = target->base_share.resize(bytes, "the base picture"); status != TXC_STATUS_OK)
        return status;
    target->base.rgba.resize(static_cast<std::size_t>(bytes));
    const TxcTargetDef& def = target->def;
    const ResampledWindow window{def.texture_width, def.texture_height, def.window_x,
                                 def.window_y,      def.width,          def.height};
    resample_rgba(rgba, width, height, nearest, window, target->base.rgba.data());
    target->change_base();
    return TXC_STATUS_OK;
}

TxcStatus Session::set_base_color(TxcTarget id, const std::uint8_t (&rgba)[4]) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(id, target); status != TXC_STATUS_OK) return status;
    target->base.rgba = std::vector<std::uint8_t>();  // `= {}` would keep the room
    target->base_share.release();
    std::memcpy(target->base.color, rgba, 4);
    target->change_base();
    return TXC_STATUS_OK;
}

// ---- Images -----------------------------------------------------------------------------------------------------------

TxcStatus Session::create_image(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba,
                                TxcImage& out_image) {
    if (const TxcStatus status = check_size(width, height); status != TXC_STATUS_OK) return status;
    if (rgba == nullptr) return fail(TXC_STATUS_BAD_ARGUMENT, "rgba is null");
    auto image = std::make_unique<ImagePyramid>(budget_);
    if (const TxcStatus status = image->build(width, height, rgba); status != TXC_STATUS_OK) return status;
    out_image = images_.add(std::move(image));
    return out_image != 0 ? TXC_STATUS_OK : fail(TXC_STATUS_BAD_ARGUMENT, "there are too many images");
}

TxcStatus Session::destroy_image(TxcImage id) {
    if (images_.find(id) == nullptr) return fail(TXC_STATUS_STALE_HANDLE, "there is no image %u", id);
    images_.remove(id);
    layers_.for_each([id](TxcLayer, Layer& layer) {
        if (layer.def.image == id) layer.needs_projection = true;
    });
    return TXC_STATUS_OK;
}

}  // namespace txc
