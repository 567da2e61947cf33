// Vectors for large data, on large pages where the system has them. The
// first touch of a page costs as much as filling it several times, so fewer
// pages are faster. Random reads need fewer entries of the processor's TLB.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace raytracer {

// The memory is aligned to at least `alignment`. Throws std::bad_alloc.
void* allocateOnLargePages(std::size_t bytes, std::size_t alignment);
void freeLargePages(void* memory, std::size_t bytes, std::size_t alignment);

// For code in C: like malloc, null if there is no memory, and
// freed with std::free. Each platform has its own version.
void* mallocOnLargePages(std::size_t bytes);

template <class T>
struct LargePages {
    using value_type = T;
    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}
    T* allocate(std::size_t count) {
        return static_cast<T*>(allocateOnLargePages(count * sizeof(T), alignof(T)));
    }
    void deallocate(T* p, std::size_t count) { freeLargePages(p, count * sizeof(T), alignof(T)); }
    // Default-initialises instead of value-initialising: resize() does not clear numbers.
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) == 0) ::new (static_cast<void*>(place)) U;
        else ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
    bool operator==(const LargePages&) const { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace raytracer
