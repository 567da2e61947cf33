#include "raytracer/util/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace raytracer {
namespace {

constexpr std::size_t largePage = std::size_t{1} << 21;  // x86's and most ARM's

bool isWorthPages(std::size_t bytes) { return bytes >= 2 * largePage; }

std::align_val_t alignmentFor(std::size_t bytes, std::size_t alignment) {
    return std::align_val_t{isWorthPages(bytes) ? largePage : alignment};
}

}  // namespace

void* allocateOnLargePages(std::size_t bytes, std::size_t alignment) {
    void* const memory = ::operator new(bytes, alignmentFor(bytes, alignment));
#if defined(__linux__)
    if (isWorthPages(bytes)) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeLargePages(void* memory, std::size_t bytes, std::size_t alignment) {
    ::operator delete(memory, alignmentFor(bytes, alignment));
}

}  // namespace raytracer
