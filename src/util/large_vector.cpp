#include "raytracer/util/large_vector.h"

#include "large_pages.h"

namespace raytracer {

void* allocateOnLargePages(std::size_t bytes, std::size_t alignment) {
    if (!isWorthLargePages(bytes)) return ::operator new (bytes, std::align_val_t{alignment});
    void* const memory = ::operator new (wholeLargePages(bytes), std::align_val_t{largePage});
    preferLargePages(memory, wholeLargePages(bytes));
    return memory;
}

void freeLargePages(void* memory, std::size_t bytes, std::size_t alignment) {
    ::operator delete (memory, std::align_val_t{isWorthLargePages(bytes) ? largePage : alignment});
}

}  // namespace raytracer
