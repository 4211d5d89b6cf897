// The map as pictures for people, as the paper's figure shows it.
#pragma once

#include <cstdint>

#include "local_space_map.h"

namespace txc {

/// Rows [row, row + row_count) as RGBA; `view` is a TxcMapView. Empty texels are transparent black.
void draw_map_view(const LocalSpaceMap& map, std::uint32_t view, std::uint32_t row, std::uint32_t row_count,
                   std::uint8_t* out_rgba);

}  // namespace txc
