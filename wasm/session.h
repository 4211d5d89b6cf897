// A session: one model and what is painted on it, within one memory budget. The ABI's functions are thin doors to it.
#pragma once

#include <memory>
#include <vector>

#include "id_table.h"
#include "image_pyramid.h"
#include "mesh.h"
#include "occlusion.h"
#include "print_zone.h"
#include "tile_compositor.h"

namespace txc {

class Session {
public:
    explicit Session(const TxcSessionDef& def);

    TxcSessionStats stats() const;

    TxcStatus load_glb(const std::uint8_t* bytes, std::uint32_t byte_count);
    TxcStatus add_mesh(const TxcMeshDef& def, const float* positions, const float* normals, const float* uvs,
                       const std::uint32_t* indices);
    TxcStatus find_material(std::uint32_t material, const Material*& out_material) const;
    /// Null before a model was loaded.
    const Mesh* mesh() const { return mesh_.get(); }

    TxcStatus create_target(const TxcTargetDef& def, TxcTarget& out_target);
    TxcStatus bake(TxcTarget target, std::uint32_t work_limit, float& out_progress);
    TxcStatus destroy_target(TxcTarget target);
    TxcStatus find_target(TxcTarget id, Target*& out_target) const;
    /// Like find_target, and NOT_BAKED before its map is ready.
    TxcStatus find_baked(TxcTarget id, Target*& out_target) const;
    /// The target with its bled texels known.
    TxcStatus find_bleed(TxcTarget id, Target*& out_target);
    TxcStatus set_base(TxcTarget target, std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba,
                       bool nearest);
    TxcStatus set_base_color(TxcTarget target, const std::uint8_t (&rgba)[4]);

    TxcStatus create_image(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba, TxcImage& out_image);
    TxcStatus destroy_image(TxcImage image);

    TxcStatus create_layer(TxcTarget target, const TxcLayerDef& def, TxcLayer& out_layer);
    TxcStatus update_layer(TxcLayer layer, const TxcLayerDef& def);
    TxcStatus move_layer(TxcLayer layer, std::uint32_t index);
    TxcStatus destroy_layer(TxcLayer layer);
    TxcStatus find_layer(TxcLayer id, Layer*& out_layer) const;

    TxcStatus set_gradient(TxcLayer layer, const TxcGradient* gradient);
    TxcStatus set_triangles(TxcLayer layer, const std::uint32_t* triangles, std::uint32_t count);
    TxcStatus add_dabs(TxcLayer layer, const TxcDab* dabs, std::uint32_t count);
    TxcStatus clear_dabs(TxcLayer layer);
    /// Like find_layer, and BAD_ARGUMENT for a layer of another kind.
    TxcStatus find_stroke(TxcLayer id, Layer*& out_layer) const;

    TxcStatus set_zones(const TxcZone* zones, std::uint32_t zone_count, const float* corners,
                        std::uint32_t corner_count);
    const std::vector<PrintZone>& zones() const { return zones_; }
    /// Null for TXC_NONE.
    TxcStatus find_zone(std::uint32_t index, const PrintZone*& out_zone) const;
    /// A layer on its target, ready to be measured. BAD_ARGUMENT for a group, and for one that waits for an update.
    TxcStatus find_measured(TxcLayer id, const LocalSpaceMap*& out_map, const Layer*& out_layer,
                            const ImagePyramid*& out_image) const;

    TxcStatus update_target(TxcTarget target, std::uint32_t work_limit, TxcUpdate& out_update);
    TxcStatus prepare_layer(TxcLayer layer, bool inside, std::uint32_t first_tile, std::uint32_t tile_count,
                            std::uint32_t& out_next_tile);
    TxcStatus draw_layer_miniature(TxcLayer layer, bool of_mask, std::uint32_t side, std::uint8_t* out_rgba) const;

private:
    /// Where room is short: what can be made again. What hidden layers paint is kept until then, so that one who shows
    /// them again, or steps back and forth through a history, need not wait.
    void give_back();
    TxcStatus begin_map(Target& target);
    std::shared_ptr<LocalSpaceMap> cached_map(const MapKey& key) const;
    /// Drops the oldest of the maps that no target uses, but for `keep`; false where there was none to drop.
    bool drop_unused_maps(std::size_t keep);
    void forget_model();
    TxcStatus check_image(TxcImage id) const;
    std::uint32_t depth_below(const Layer& layer) const;
    TxcStatus check_parent(TxcTarget target, TxcLayer id, const TxcLayerDef& def) const;
    std::vector<TxcLayer>& siblings(Target& target, const TxcLayerDef& def);
    /// With all that is in them; the list that they stand in keeps their ids.
    void remove_layers(const std::vector<TxcLayer>& ids);
    void mark_dirty(Target& target, const Layer& layer);
    void note_move(Target& target, Layer& layer);
    TxcStatus find_fill(TxcLayer id, Layer*& out_layer) const;
    void change_fill(Target& target, Layer& layer);
    /// Projects what is shown and behind, in groups and masks too, as long as there is work left to do.
    TxcStatus project_layers(Target& target, const std::vector<TxcLayer>& ids, TxcUpdate& update);
    /// `split`: of the backdrops; where it is the end of a group, that stands there as a layer which paints nothing.
    std::vector<LayerNode> nodes_of(const std::vector<TxcLayer>& ids, TxcLayer split) const;
    /// Whether the mask of a layer hides anything, so that it is composited by itself.
    bool shows_by_mask(const Layer& layer) const;
    /// The tiles where the layer, or what is in it, paints.
    void note_tiles(const Layer& layer, std::vector<std::uint8_t>& tiles) const;
    /// Whether the target's picture shows all that its layers were told.
    bool is_settled(const Target& target) const;
    /// Shown, as far as that is the layer's and its parents' to say.
    bool is_shown(const Layer& layer) const;
    /// Whether any of a mask's layers, or of their masks', changed; forgets that it did.
    bool takes_changes(const std::vector<TxcLayer>& ids);
    void follow_changes(Target& target);
    /// Brings the layer's tiles up to date and marks those that change.
    TxcStatus project_layer(Target& target, Layer& layer, TxcUpdate& update);
    TxcStatus project_stroke(Target& target, Layer& layer, TxcUpdate& update);
    /// The tips of the layer's brush, shared with other strokes of its hardness.
    RoundTips& round_tips_of(Layer& layer);
    TxcStatus ensure_occlusion_tree();

    // The budget outlives everything that holds a share of it.
    MemoryBudget budget_;
    Layer nothing_{budget_};  // what stands at the end of a group; shown, and without paint
    std::unique_ptr<Mesh> mesh_;
    BudgetShare mesh_share_;
    std::unique_ptr<OcclusionTree> occlusion_;
    std::unique_ptr<OccluderGrid> occluders_;  // of the newest decal: that of the next target is mostly the same
    std::vector<std::shared_ptr<LocalSpaceMap>> maps_;  // oldest first; those that no target uses may be dropped
    IdTable<ImagePyramid> images_;
    std::vector<PrintZone> zones_;
    std::vector<std::weak_ptr<RoundTips>> round_tips_;  // those that strokes use
    IdTable<Layer> layers_;
    IdTable<Target> targets_;
    std::uint32_t bake_count_ = 0;
    std::uint32_t projection_count_ = 0;
    std::uint32_t projected_texels_ = 0;
    std::uint32_t composited_texels_ = 0;
    WorkLeft work_left_;  // of the update under way
};

}  // namespace txc
