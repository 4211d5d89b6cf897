#include "target.h"

namespace txc {

void Target::mark_dirty(const Layer& layer) {
    if (layer.def.kind == TXC_LAYER_FILL) {
        all_dirty = true;
        return;
    }
    if (dirty_tiles.empty()) dirty_tiles.assign(tile_count(), 0);
    for (const std::uint32_t tile : layer.tiles.indices) dirty_tiles[tile] = 1;
}

}  // namespace txc
