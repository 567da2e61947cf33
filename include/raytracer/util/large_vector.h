// Vectors of what there is much of, on large pages where the system has them: the first touch of a page costs
// as much as to fill it several times, and what is read here and there needs fewer entries of the processor's
// table of pages.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace raytracer {

// At least aligned to this. Throws std::bad_alloc.
void* allocateOnLargePages(std::size_t bytes, std::size_t alignment);
void freeLargePages(void* memory, std::size_t bytes, std::size_t alignment);

// Of the platform: for what is written in C; null where there is no memory; freed with std::free.
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
    // What resize() adds has no value yet where T has no constructor of its own.
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
