#include "../memory_limits.h"

#include <windows.h>

#include <algorithm>

namespace raytracer {

// What the process can still commit, in memory and in the swap file.
std::vector<MemoryLeft> memoryLimits() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    GlobalMemoryStatusEx(&status);
    const auto left = std::min(status.ullAvailPageFile, status.ullAvailVirtual);
    return {{static_cast<double>(left), "the machine has left "}};
}

}  // namespace raytracer
