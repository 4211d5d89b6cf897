// How the core reports failure: a status from the ABI's one list, and a sentence that names field and value.
#pragma once

#include <cstdarg>
#include <string>

#include "texelcast.h"

namespace txc {

/// Keeps `detail` (write_words' format) for txc_error_detail and returns `status`, so that `return fail(...)` is one line.
TxcStatus fail(TxcStatus status, const char* detail_format, ...) __attribute__((format(printf, 2, 3)));

/// The newest failure's detail; emptied at the start of each ABI call.
std::string& error_detail();

}  // namespace txc
