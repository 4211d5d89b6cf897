// The C ABI's functions for targets: what they are made of, and what comes out.
#include <cstring>

#include "abi_door.h"
#include "map_view.h"

namespace {

using txc::fail;
using txc::in_session;
using txc::Session;
using txc::Target;

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

}  // namespace

extern "C" {

// ---- Target and bake --------------------------------------------------------------------------------------------------

void txc_target_def_default(TxcTargetDef* def) {
    if (def != nullptr) *def = TxcTargetDef{0, 1024, 1024, TXC_NONE, 1, 0, 0, 0, 0};
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
        txc::copy_point(map.origin, map.bounds.min, out_info->bounds_min_model);
        txc::copy_point(map.origin, map.bounds.max, out_info->bounds_max_model);
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

// ---- Update and read --------------------------------------------------------------------------------------------------

TxcStatus txc_target_update(TxcSession session, TxcTarget target, uint32_t work_limit, TxcUpdate* out_update) {
    return in_session(session, out_update, "out_update",
                      [&](Session& s) { return s.update_target(target, work_limit, *out_update); });
}

const TxcRect* txc_target_update_rects(TxcSession session, TxcTarget id) {
    Target* target = nullptr;
    const TxcStatus status = in_session(session, [&](Session& s) { return s.find_target(id, target); });
    return status == TXC_STATUS_OK && !target->rects.empty() ? target->rects.data() : nullptr;
}

const uint8_t* txc_target_level(TxcSession session, TxcTarget id, uint32_t level) {
    Target* target = nullptr;
    const TxcStatus status = in_session(session, [&](Session& s) { return s.find_target(id, target); });
    return status == TXC_STATUS_OK && level < target->output.levels.size() ? target->output.levels[level].rgba.data()
                                                                           : nullptr;
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
