// Pages that the system has larger ones of than usual.
#pragma once

#include <cstddef>

namespace raytracer {

inline constexpr std::size_t largePage = std::size_t{1} << 21;  // x86's and most ARM's

inline bool isWorthLargePages(std::size_t bytes) { return bytes >= largePage / 2; }

// A part of a page is not a large one.
inline std::size_t wholeLargePages(std::size_t bytes) {
    return (bytes + largePage - 1) / largePage * largePage;
}

// Of the platform: asks for large pages, before the memory is touched. It is whole ones.
void preferLargePages(void* memory, std::size_t bytes);

}  // namespace raytracer
