#include "raytracer/util/large_vector.h"

#include <algorithm>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace raytracer {

void* allocateOnLargePages(std::size_t bytes, std::size_t alignment) {
    constexpr std::size_t page = std::size_t{1} << 21;  // x86's and most ARM's
    alignment = bytes >= 2 * page ? page : std::max(alignment, sizeof(void*));
    void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!memory) throw std::bad_alloc();
#if defined(__linux__)
    if (bytes >= 2 * page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return memory;
}

}  // namespace raytracer
