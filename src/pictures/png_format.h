// What the PNGs that are read and written have in common.
#pragma once

#include <string_view>

namespace raytracer {

inline constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";

// Of those that are written; measured by bench/png_levels (bench/README.md).
inline constexpr int pngFilter = 2;  // "up": each byte less the one above
inline constexpr int deflateLevel = 1;

}  // namespace raytracer
