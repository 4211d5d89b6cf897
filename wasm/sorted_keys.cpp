#include "sorted_keys.h"

#include <algorithm>

namespace txc {

void sort_keys(std::vector<std::uint64_t>& keys) { std::sort(keys.begin(), keys.end()); }

}  // namespace txc
