// The outer form of a glTF file, its chunks and its JSON text, checked before tinygltf sees it: tinygltf trusts a few
// numbers that a file may make up, and here neither it nor its JSON parser can throw, so that what they do not check ends
// the program.
#pragma once

#include <cstdint>

#include "memory_budget.h"
#include "status.h"

namespace txc {

/// True for a GLB, false for anything else (a self-contained glTF JSON, perhaps).
bool is_glb(const std::uint8_t* bytes, std::uint32_t byte_count);

/// Checks that the chunks lie inside the file, that the JSON text is well formed and not nested without end, and the
/// sizes of buffers. Makes `share` as large as all that tinygltf will hold of the file. Errors: BAD_MODEL, OUT_OF_BUDGET.
TxcStatus check_gltf_container(const std::uint8_t* bytes, std::uint32_t byte_count, BudgetShare& share);

}  // namespace txc
