// A vector whose new elements are whatever stood there: for arrays that are written whole after they are made larger.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace txc {

template <typename T>
struct RawAllocator : std::allocator<T> {
    template <typename Other>
    struct rebind {
        using other = RawAllocator<Other>;
    };
    template <typename Element>
    void construct(Element* place) {
        ::new (static_cast<void*>(place)) Element;
    }
    template <typename Element, typename... Arguments>
    void construct(Element* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Element(std::forward<Arguments>(arguments)...);
    }
};

/// `resize` leaves numbers unset. (A drag spent a thirtieth of its time on zeros that nothing read.)
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace txc
