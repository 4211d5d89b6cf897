#include "layer_def.h"

#include <cstddef>
#include <cstring>

namespace txc {
namespace {

TxcStatus check_choice(std::uint32_t value, std::uint32_t count, const char* field) {
    if (value < count) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "%s is %u; it must be below %u", field, value, count);
}

TxcStatus check_share(float value, const char* field) {
    if (value >= 0.0f && value <= 1.0f) return TXC_STATUS_OK;
    return fail(TXC_STATUS_BAD_ARGUMENT, "%s is %g; it must be from 0 to 1", field, static_cast<double>(value));
}

/// The fields of all projectors stand in one piece.
bool same_projector_fields(const TxcLayerDef& a, const TxcLayerDef& b) {
    constexpr std::size_t kFirst = offsetof(TxcLayerDef, position_model);
    constexpr std::size_t kEnd = offsetof(TxcLayerDef, color);
    return std::memcmp(reinterpret_cast<const char*>(&a) + kFirst, reinterpret_cast<const char*>(&b) + kFirst,
                       kEnd - kFirst) == 0;
}

bool same_brush(const TxcLayerDef& a, const TxcLayerDef& b) {
    return a.tip == b.tip && a.hardness == b.hardness && a.flow == b.flow &&
           std::memcmp(a.color, b.color, sizeof a.color) == 0;
}

}  // namespace

TxcStatus read_layer_def(const TxcLayerDef& def, PictureCast& out) {
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
        {def.tip, TXC_TIP_COUNT, "tip"},
        {def.role, TXC_ROLE_COUNT, "role"},
        {def.isolated, 2, "isolated"},
        {def.invert_mask, 2, "invert_mask"},
    };
    for (const auto& choice : choices) {
        if (const TxcStatus status = check_choice(choice.value, choice.count, choice.field); status != TXC_STATUS_OK)
            return status;
    }
    const struct {
        float value;
        const char* field;
    } shares[] = {
        {def.opacity, "opacity"},   {def.color[0], "color[0]"}, {def.color[1], "color[1]"}, {def.color[2], "color[2]"},
        {def.color[3], "color[3]"}, {def.hardness, "hardness"}, {def.flow, "flow"},
    };
    for (const auto& share : shares) {
        if (const TxcStatus status = check_share(share.value, share.field); status != TXC_STATUS_OK) return status;
    }
    if (def.kind == TXC_LAYER_FILL || def.kind == TXC_LAYER_GROUP) return TXC_STATUS_OK;
    if (!(def.angle_fade_start >= 0.0f && def.angle_fade_start <= def.angle_fade_end && def.angle_fade_end <= 90.0f)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "angle_fade is %g to %g degrees; it must rise within 0 to 90",
                    static_cast<double>(def.angle_fade_start), static_cast<double>(def.angle_fade_end));
    }
    out.read_settings(def);
    return def.kind == TXC_LAYER_STROKE ? TXC_STATUS_OK : out.read_projector(def);
}

bool same_projection(const TxcLayerDef& a, const TxcLayerDef& b) {
    // Of a fill's tiles the blend space is a part: gradients are mixed in it.
    if (a.kind == TXC_LAYER_FILL && b.kind == TXC_LAYER_FILL)
        return a.blend_space == b.blend_space && std::memcmp(a.color, b.color, sizeof a.color) == 0;
    const bool same_reach = a.kind == b.kind && a.image == b.image && a.filter == b.filter && a.wrap == b.wrap &&
                            a.flip_x == b.flip_x && a.flip_y == b.flip_y && a.backfaces == b.backfaces &&
                            a.angle_fade_start == b.angle_fade_start && a.angle_fade_end == b.angle_fade_end &&
                            a.occlusion == b.occlusion;
    if (!same_reach) return false;
    if (a.kind == TXC_LAYER_STROKE) return same_brush(a, b);
    return a.projector == b.projector && same_projector_fields(a, b);
}

}  // namespace txc
