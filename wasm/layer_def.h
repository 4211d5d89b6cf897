// What an ABI layer's fields may hold, and which of them change what it paints.
#pragma once

#include "picture_cast.h"

namespace txc {

/// Reads a layer's cast from its fields. BAD_ARGUMENT names the field at fault. The cast of fills and groups, and a stroke's
/// projector, stay as they were.
TxcStatus read_layer_def(const TxcLayerDef& def, PictureCast& out);

/// True where two layers paint the same texels in the same colours, as against how their paint is laid on.
bool same_projection(const TxcLayerDef& a, const TxcLayerDef& b);

}  // namespace txc
