#include "target.h"

namespace txc {

void Target::mark_dirty(const Layer& layer) {
    if (layer.def.kind == TXC_LAYER_FILL) {
        all_dirty = true;
        return;
    }
    ensure_tile_marks();
    for (const std::uint32_t tile : layer.tiles.indices) dirty_tiles[tile] = 1;
}

}  // namespace txc
