#include "raytracer/util/large_vector.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace raytracer {
namespace {

constexpr std::size_t largePage = std::size_t{1} << 21;  // x86's and most ARM's

bool isWorthPages(std::size_t bytes) { return bytes >= largePage / 2; }

// A part of a page is not a large one.
std::size_t wholePages(std::size_t bytes) { return (bytes + largePage - 1) / largePage * largePage; }

}  // namespace

void* allocateOnLargePages(std::size_t bytes, std::size_t alignment) {
    if (!isWorthPages(bytes)) return ::operator new (bytes, std::align_val_t{alignment});
    void* const memory = ::operator new (wholePages(bytes), std::align_val_t{largePage});
#if defined(__linux__)
    madvise(memory, wholePages(bytes), MADV_HUGEPAGE);
#endif
    return memory;
}

void freeLargePages(void* memory, std::size_t bytes, std::size_t alignment) {
    ::operator delete (memory, std::align_val_t{isWorthPages(bytes) ? largePage : alignment});
}

void* mallocOnLargePages(std::size_t bytes) {
#if defined(__linux__)
    if (isWorthPages(bytes)) {
        void* const memory = std::aligned_alloc(largePage, wholePages(bytes));
        if (memory) madvise(memory, wholePages(bytes), MADV_HUGEPAGE);
        return memory;
    }
#endif
    return std::malloc(bytes);
}

}  // namespace raytracer
