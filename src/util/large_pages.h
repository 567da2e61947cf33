// Support for large pages.
#pragma once

#include <cstddef>

namespace raytracer {

inline constexpr std::size_t largePage = std::size_t{1} << 21;  // bytes, on x86 and most ARM

inline bool isWorthLargePages(std::size_t bytes) { return bytes >= largePage / 2; }

// Rounds up to whole large pages: the system gives usual pages for a part of one.
inline std::size_t wholeLargePages(std::size_t bytes) {
    return (bytes + largePage - 1) / largePage * largePage;
}

// Asks for large pages, before the memory is touched. `memory` and `bytes` are multiples of largePage. Each
// platform has its own version.
void preferLargePages(void* memory, std::size_t bytes);

}  // namespace raytracer
