#include "../large_pages.h"

#include <sys/mman.h>

#include <cstdlib>

#include "raytracer/util/large_vector.h"

namespace raytracer {

void preferLargePages(void* memory, std::size_t bytes) { ::madvise(memory, bytes, MADV_HUGEPAGE); }

void* mallocOnLargePages(std::size_t bytes) {
    if (!isWorthLargePages(bytes)) return std::malloc(bytes);
    void* const memory = std::aligned_alloc(largePage, wholeLargePages(bytes));
    if (memory) preferLargePages(memory, wholeLargePages(bytes));
    return memory;
}

}  // namespace raytracer
