// How many rays a packet holds.
#pragma once

namespace raytracer {

inline constexpr int packetWidth = 4, packetHeight = 2;  // pixels, one ray each

// A set of lanes, of rays in a packet: lane i is the bit 1 << i.
using LaneBits = unsigned;

}  // namespace raytracer
