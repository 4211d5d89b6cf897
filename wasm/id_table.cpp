#include "id_table.h"

namespace txc {

std::uint32_t next_object_id() {
    static std::uint32_t last = 0;
    if (last == 0xffffffffu) return 0;
    return ++last;
}

}  // namespace txc
