#include "session.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "compositor.h"
#include "exact_math.h"
#include "gltf_reader.h"
#include "gutter.h"
#include "occluder_grid.h"

namespace txc {
namespace {

// Maps that no target uses any more but that a user who flips between two sizes will want again.
constexpr std::size_t kSpareMaps = 2;
constexpr std::uint32_t kMaxRawMaterials = 1024;

MapKey key_of(const TxcTargetDef& def) { return {def.material, def.width, def.height, def.gutter}; }

TxcStatus check_flag(std::uint32_t value, std::uint32_t count, const char* field) {
    if (value < count) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "%s is %u; it must be below %u", field, value, count);
}

TxcStatus check_size(std::uint32_t width, std::uint32_t height) {
    if (width >= 1 && width <= TXC_MAX_SIZE && height >= 1 && height <= TXC_MAX_SIZE) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_SIZE, "the size is %u x %u; each side must be from 1 to %u", width, height,
                TXC_MAX_SIZE);
}

/// The fields of all projectors stand in one piece.
bool same_projector_fields(const TxcLayerDef& a, const TxcLayerDef& b) {
    constexpr std::size_t kFirst = offsetof(TxcLayerDef, position_model);
    constexpr std::size_t kEnd = offsetof(TxcLayerDef, color);
    return std::memcmp(reinterpret_cast<const char*>(&a) + kFirst, reinterpret_cast<const char*>(&b) + kFirst,
                       kEnd - kFirst) == 0;
}

/// Fields that change what a decal paints, as against how its paint is laid on.
bool same_projection(const TxcLayerDef& a, const TxcLayerDef& b) {
    return a.kind == b.kind && a.image == b.image && a.filter == b.filter && a.wrap == b.wrap && a.flip_x == b.flip_x &&
           a.flip_y == b.flip_y && a.backfaces == b.backfaces && a.angle_fade_start == b.angle_fade_start &&
           a.angle_fade_end == b.angle_fade_end && a.occlusion == b.occlusion && a.projector == b.projector &&
           same_projector_fields(a, b);
}

}  // namespace

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
    occlusion_.reset();
}

TxcStatus Session::load_glb(const std::uint8_t* bytes, std::uint32_t byte_count) {
    auto mesh = std::make_unique<Mesh>();
    if (const TxcStatus status = read_gltf(bytes, byte_count, budget_, *mesh); status != TXC_STATUS_OK) return status;
    BudgetShare share(budget_);
    if (const TxcStatus status = share.resize(mesh->byte_count(), "the model"); status != TXC_STATUS_OK) return status;
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
    const std::uint64_t before = mesh_ != nullptr ? mesh_->byte_count() : 0;
    BudgetShare share(budget_);
    if (const TxcStatus status = share.resize(before + mesh_byte_count(def.vertex_count, corner_count / 3), "the mesh");
        status != TXC_STATUS_OK)
        return status;
    auto mesh = mesh_ != nullptr ? std::make_unique<Mesh>(*mesh_) : std::make_unique<Mesh>();
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
    if (const TxcStatus status = append_primitive(*mesh, arrays, "the mesh"); status != TXC_STATUS_OK) return status;
    mesh->summarise();
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
    if (def.gutter == TXC_NONE) def.gutter = default_gutter(def.width, def.height);
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
    for (const TxcLayer layer : target->order) layers_.remove(layer);
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
    resample_rgba(rgba, width, height, nearest, target->def.width, target->def.height, target->base.rgba.data());
    target->mark_all_dirty();
    return TXC_STATUS_OK;
}

TxcStatus Session::set_base_color(TxcTarget id, const std::uint8_t (&rgba)[4]) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(id, target); status != TXC_STATUS_OK) return status;
    target->base.rgba = {};
    target->base_share.release();
    std::memcpy(target->base.color, rgba, 4);
    target->mark_all_dirty();
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

// ---- Layers -----------------------------------------------------------------------------------------------------------

TxcStatus Session::check_layer_def(const TxcLayerDef& def, DecalSettings& out_settings,
                                   CurvedProjector& out_curved) const {
    const struct {
        std::uint32_t value;
        std::uint32_t count;
        const char* field;
    } choices[] = {
        {def.kind, TXC_LAYER_KIND_COUNT, "kind"},
        {def.visible, 2, "visible"},
        {def.blend, TXC_BLEND_COUNT, "blend"},
        {def.blend_space, TXC_BLEND_SPACE_COUNT, "blend_space"},
        {def.lock_alpha, 2, "lock_alpha"},
        {def.filter, TXC_FILTER_COUNT, "filter"},
        {def.wrap, TXC_WRAP_COUNT, "wrap"},
        {def.flip_x, 2, "flip_x"},
        {def.flip_y, 2, "flip_y"},
        {def.backfaces, 2, "backfaces"},
        {def.occlusion, TXC_OCCLUSION_COUNT, "occlusion"},
        {def.projector, TXC_PROJECTOR_COUNT, "projector"},
    };
    for (const auto& choice : choices) {
        if (const TxcStatus status = check_flag(choice.value, choice.count, choice.field); status != TXC_STATUS_OK)
            return status;
    }
    if (!(def.opacity >= 0.0f && def.opacity <= 1.0f)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "opacity is %g; it must be from 0 to 1", static_cast<double>(def.opacity));
    }
    for (int c = 0; c < 4; ++c) {
        if (!(def.color[c] >= 0.0f && def.color[c] <= 1.0f)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "color[%d] is %g; it must be from 0 to 1", c,
                        static_cast<double>(def.color[c]));
        }
    }
    if (def.kind == TXC_LAYER_FILL) return TXC_STATUS_OK;
    if (!(def.angle_fade_start >= 0.0f && def.angle_fade_start <= def.angle_fade_end && def.angle_fade_end <= 90.0f)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "angle_fade is %g to %g degrees; it must rise within 0 to 90",
                    static_cast<double>(def.angle_fade_start), static_cast<double>(def.angle_fade_end));
    }
    out_settings.nearest = def.filter == TXC_FILTER_NEAREST;
    out_settings.repeat = def.wrap == TXC_WRAP_REPEAT;
    out_settings.flip_x = def.flip_x != 0;
    out_settings.flip_y = def.flip_y != 0;
    out_settings.backfaces = def.backfaces != 0;
    out_settings.fade_start_cosine = static_cast<float>(exact_cos_degrees(static_cast<double>(def.angle_fade_start)));
    out_settings.fade_end_cosine = static_cast<float>(exact_cos_degrees(static_cast<double>(def.angle_fade_end)));
    if (def.projector != TXC_PROJECTOR_PLANAR) return read_curved_projector(def, out_curved);
    return PlanarProjector::from_def(def, out_settings.projector);
}

TxcStatus Session::check_image(TxcImage id) const {
    if (id == 0 || images_.find(id) != nullptr) return TXC_STATUS_OK;
    return fail(TXC_STATUS_STALE_HANDLE, "there is no image %u", id);
}

TxcStatus Session::create_layer(TxcTarget target_id, const TxcLayerDef& def, TxcLayer& out_layer) {
    Target* target = nullptr;
    if (const TxcStatus status = find_target(target_id, target); status != TXC_STATUS_OK) return status;
    auto layer = std::make_unique<Layer>(budget_);
    if (const TxcStatus status = check_layer_def(def, layer->settings, layer->curved); status != TXC_STATUS_OK)
        return status;
    if (const TxcStatus status = check_image(def.image); status != TXC_STATUS_OK) return status;
    layer->target = target_id;
    layer->def = def;
    layer->needs_projection = true;
    target->mark_dirty(*layer);
    out_layer = layers_.add(std::move(layer));
    if (out_layer == 0) return fail(TXC_STATUS_BAD_ARGUMENT, "there are too many layers");
    target->order.push_back(out_layer);
    return TXC_STATUS_OK;
}

TxcStatus Session::update_layer(TxcLayer id, const TxcLayerDef& def) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    DecalSettings settings{};
    CurvedProjector curved;
    if (const TxcStatus status = check_layer_def(def, settings, curved); status != TXC_STATUS_OK) return status;
    // An image that was destroyed under the layer may stay named: the layer is transparent until it gets another.
    if (def.image != layer->def.image) {
        if (const TxcStatus status = check_image(def.image); status != TXC_STATUS_OK) return status;
    }
    if (std::memcmp(&layer->def, &def, sizeof def) == 0) return TXC_STATUS_OK;
    Target& target = *targets_.find(layer->target);
    // Where it was: its old tiles. Where it will be: the projection marks those.
    target.mark_dirty(*layer);
    if (!same_projection(layer->def, def)) layer->needs_projection = true;
    layer->def = def;
    layer->settings = settings;
    layer->curved = curved;
    if (def.kind == TXC_LAYER_FILL) target.mark_all_dirty();
    return TXC_STATUS_OK;
}

TxcStatus Session::move_layer(TxcLayer id, std::uint32_t index) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    Target& target = *targets_.find(layer->target);
    const auto from = std::find(target.order.begin(), target.order.end(), id);
    const std::size_t to = std::min<std::size_t>(index, target.order.size() - 1);
    if (static_cast<std::size_t>(from - target.order.begin()) == to) return TXC_STATUS_OK;
    target.order.erase(from);
    target.order.insert(target.order.begin() + static_cast<std::ptrdiff_t>(to), id);
    target.mark_dirty(*layer);
    return TXC_STATUS_OK;
}

TxcStatus Session::destroy_layer(TxcLayer id) {
    Layer* layer = nullptr;
    if (const TxcStatus status = find_layer(id, layer); status != TXC_STATUS_OK) return status;
    Target& target = *targets_.find(layer->target);
    target.mark_dirty(*layer);
    target.order.erase(std::find(target.order.begin(), target.order.end(), id));
    layers_.remove(id);
    return TXC_STATUS_OK;
}

TxcStatus Session::find_layer(TxcLayer id, Layer*& out_layer) const {
    out_layer = layers_.find(id);
    return out_layer != nullptr ? TXC_STATUS_OK : fail(TXC_STATUS_STALE_HANDLE, "there is no layer %u", id);
}

// ---- Update -----------------------------------------------------------------------------------------------------------

TxcStatus Session::ensure_occlusion_tree() {
    if (occlusion_ != nullptr) return TXC_STATUS_OK;
    auto tree = std::make_unique<OcclusionTree>(budget_);
    if (const TxcStatus status = tree->build(*mesh_); status != TXC_STATUS_OK) return status;
    occlusion_ = std::move(tree);
    return TXC_STATUS_OK;
}

TxcStatus Session::project_layer(const Target& target, Layer& layer, TxcUpdate& update) {
    const ImagePyramid* image = images_.find(layer.def.image);
    if (layer.def.kind != TXC_LAYER_DECAL || image == nullptr) {
        layer.tiles.indices.clear();
        layer.tiles.texels.clear();
        layer.needs_projection = false;
        return TXC_STATUS_OK;
    }
    std::uint32_t texels = 0;
    if (const TxcStatus status = project(*target.map, *image, layer, texels); status != TXC_STATUS_OK) return status;
    layer.needs_projection = false;
    ++projection_count_;
    ++update.projected_layers;
    update.projected_texels += texels;
    return TXC_STATUS_OK;
}

TxcStatus Session::find_bleed(TxcTarget id, Target*& out_target) {
    if (const TxcStatus status = find_baked(id, out_target); status != TXC_STATUS_OK) return status;
    return txc::find_bleed(*out_target, budget_);
}

TxcStatus Session::project(const LocalSpaceMap& map, const ImagePyramid& image, Layer& layer,
                           std::uint32_t& out_texels) {
    // The flat stamp asks no surface what hides it.
    const bool occludes = layer.def.occlusion == TXC_OCCLUSION_SELF && layer.def.projector != TXC_PROJECTOR_UV;
    if (occludes) {
        if (const TxcStatus status = ensure_occlusion_tree(); status != TXC_STATUS_OK) return status;
    }
    if (layer.def.projector != TXC_PROJECTOR_PLANAR) {
        return project_curved_decal(map, *mesh_, layer.settings, layer.curved, image,
                                    occludes ? occlusion_.get() : nullptr, layer.tiles, out_texels);
    }
    std::unique_ptr<OccluderGrid> occluders;
    if (occludes) {
        occluders = std::make_unique<OccluderGrid>(*mesh_, *occlusion_, layer.settings.projector, budget_);
        if (const TxcStatus status = occluders->build(); status != TXC_STATUS_OK) return status;
    }
    return project_decal(map, *mesh_, layer.settings, image, occluders.get(), layer.tiles, out_texels);
}

TxcStatus Session::update_target(TxcTarget id, TxcUpdate& out_update) {
    Target* target = nullptr;
    if (const TxcStatus status = find_baked(id, target); status != TXC_STATUS_OK) return status;
    TxcUpdate update{};
    std::vector<const Layer*> visible;
    for (const TxcLayer layer_id : target->order) {
        Layer& layer = *layers_.find(layer_id);
        // A hidden layer's projection can wait until it is shown.
        if (layer.def.visible == 0) continue;
        if (layer.needs_projection) {
            target->mark_dirty(layer);
            if (const TxcStatus status = project_layer(*target, layer, update); status != TXC_STATUS_OK) return status;
            target->mark_dirty(layer);
        }
        visible.push_back(&layer);
    }
    target->bleed.forget();
    if (const TxcStatus status = composite_target(*target, visible, update.composited_texels); status != TXC_STATUS_OK)
        return status;
    projected_texels_ = update.projected_texels;
    composited_texels_ = update.composited_texels;
    update.rect_count = static_cast<std::uint32_t>(target->rects.size());
    update.byte_count = static_cast<std::uint32_t>(target->packed.size());
    out_update = update;
    return TXC_STATUS_OK;
}

}  // namespace txc
