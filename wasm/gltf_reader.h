// Binary glTF 2.0 to a mesh at rest (spec section 1). The only user of tinygltf is behind this header.
#pragma once

#include <cstdint>

#include "mesh.h"

namespace txc {

/// Reads a GLB (or a self-contained glTF JSON) into `out_mesh`, summarised. Draco and meshopt must be undone before.
/// Counts what it needs against `budget` first. Errors: BAD_MODEL, UNSUPPORTED_MODEL, BAD_GEOMETRY, NO_TRIANGLES,
/// OUT_OF_BUDGET; `out_mesh` is then unspecified.
TxcStatus read_gltf(const std::uint8_t* bytes, std::uint32_t byte_count, MemoryBudget& budget, Mesh& out_mesh);

}  // namespace txc
