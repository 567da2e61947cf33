#include "../large_pages.h"

#include <cstdlib>

#include "raytracer/util/large_vector.h"

namespace raytracer {

void preferLargePages(void*, std::size_t) {}

void* mallocOnLargePages(std::size_t bytes) { return std::malloc(bytes); }

}  // namespace raytracer
