// Constants of the PNG format, and those of the PNGs that this program writes.
#pragma once

#include <string_view>

namespace raytracer {

inline constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";

// For writing; chosen by the measurements of bench/png_levels (bench/README.md).
inline constexpr int pngFilter = 2;  // "Up": each byte minus the one above it
inline constexpr int deflateLevel = 1;

}  // namespace raytracer
