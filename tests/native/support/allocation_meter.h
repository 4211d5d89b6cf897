// What the program really allocates with `new`, to hold against what a session counts.
#pragma once

#include <cstdint>

// Under AddressSanitizer its own operator new stays, for it finds more.
#if defined(__SANITIZE_ADDRESS__)
#define SUPPORT_METERS_ALLOCATIONS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SUPPORT_METERS_ALLOCATIONS 0
#endif
#endif
#if !defined(SUPPORT_METERS_ALLOCATIONS)
#define SUPPORT_METERS_ALLOCATIONS 1
#endif

namespace support {

/// Where false, the two below stay 0.
inline constexpr bool kMetersAllocations = SUPPORT_METERS_ALLOCATIONS != 0;

/// Bytes allocated now.
std::uint64_t allocated_bytes();
/// The most bytes allocated at once since the call before.
std::uint64_t take_allocation_peak();

}  // namespace support
