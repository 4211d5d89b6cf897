// RapidJSON's memory (its "allocator" concept): from `operator new`, which ends the program where there is none, as all of
// the core does. RapidJSON's own takes malloc's null for memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

namespace txc {

struct JsonMemory {
    static constexpr bool kNeedFree = true;

    void* Malloc(std::size_t size) { return size > 0 ? ::operator new(size) : nullptr; }
    void* Realloc(void* block, std::size_t old_size, std::size_t size) {
        void* const grown = Malloc(size);
        if (block != nullptr && grown != nullptr) std::memcpy(grown, block, std::min(old_size, size));
        Free(block);
        return grown;
    }
    static void Free(void* block) { ::operator delete(block); }
};

}  // namespace txc
