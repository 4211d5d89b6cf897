// One sort for all: std::sort is compiled anew for every type and order, 3 to 8 kB each of a module that is downloaded.
#pragma once

#include <cstdint>
#include <vector>

namespace txc {

/// Sorts ascending. What is to be ordered stands in the upper bits, and below it what tells equals apart and where to find
/// the rest: so every library sorts alike.
void sort_keys(std::vector<std::uint64_t>& keys);

}  // namespace txc
