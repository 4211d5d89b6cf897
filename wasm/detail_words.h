// The words of details. std::vsnprintf does the same and more: with floating point of every width and files to write to it
// takes 8 kB of the module, 3 kB of what is downloaded.
#pragma once

#include <cstdarg>
#include <cstddef>

namespace txc {

/// As std::vsnprintf with %s (%.20s), %c, %d, %u, %zu, %llu, %g and %% alone; what does not fit is left out. A %g is to the
/// nearest sixth digit as far as doubles tell.
void write_words(char* out, std::size_t size, const char* format, std::va_list arguments);

/// As std::snprintf, with the same.
void write_words(char* out, std::size_t size, const char* format, ...) __attribute__((format(printf, 3, 4)));

}  // namespace txc
