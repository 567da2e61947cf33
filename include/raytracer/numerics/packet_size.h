// How many rays a packet holds.
#pragma once

namespace raytracer {

inline constexpr int packetWidth = 4, packetHeight = 2;  // pixels, one ray each

}  // namespace raytracer
