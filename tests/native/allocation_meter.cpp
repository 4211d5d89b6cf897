// Counts every `new` of the test program. Each block carries its size before it, in as many bytes as keep its alignment.
#include "support/allocation_meter.h"

#include <cstdlib>
#include <new>

namespace {
std::uint64_t allocated = 0;
std::uint64_t peak = 0;
}  // namespace

namespace support {

std::uint64_t allocated_bytes() { return allocated; }

std::uint64_t take_allocation_peak() {
    const std::uint64_t most = peak;
    peak = allocated;
    return most;
}

}  // namespace support

#if SUPPORT_METERS_ALLOCATIONS

namespace {

constexpr std::size_t kHeader = 16;

void* allocate(std::size_t size) {
    void* block = std::malloc(size + kHeader);
    if (block == nullptr) std::abort();
    *static_cast<std::size_t*>(block) = size;
    allocated += size;
    if (allocated > peak) peak = allocated;
    return static_cast<char*>(block) + kHeader;
}

void release(void* memory) {
    if (memory == nullptr) return;
    void* block = static_cast<char*>(memory) - kHeader;
    allocated -= *static_cast<std::size_t*>(block);
    std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

#endif
