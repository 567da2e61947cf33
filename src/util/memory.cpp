#include "raytracer/util/memory.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "memory_limits.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

constexpr std::size_t little = 1 << 20;  // bytes; filling them takes ten times as long as reading the limits

std::string inBytes(double bytes) {
    constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit) bytes /= 1000;
    return formatted("%.3g %s", bytes, units[unit]);
}

}  // namespace

MemoryLeft memoryLeft() {
    MemoryLeft least = std::ranges::min(memoryLimits(), {}, &MemoryLeft::bytes);
    least.bytes = std::max(0.0, least.bytes - static_cast<double>(little));
    least.inWords += inBytes(least.bytes);
    return least;
}

bool hasMemory(double bytes) {
    static std::atomic<std::size_t> unchecked = 0;  // less than `little`, which memoryLeft() keeps for it
    unchecked += static_cast<std::size_t>(std::min(bytes, static_cast<double>(little)));
    if (unchecked < little) return true;
    unchecked = 0;
    return bytes <= memoryLeft().bytes;
}

void requireMemory(const std::string& file, const std::string& what, double bytes) {
    if (!hasMemory(bytes)) failForMemory(file, what + " (" + inBytes(bytes) + ")");
}

void failForMemory(const std::string& file, const std::string& what) {
    throw OutOfMemory({file}, "not enough memory for " + what + ": " + memoryLeft().inWords);
}

}  // namespace raytracer
