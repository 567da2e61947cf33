#include "raytracer/util/stopwatch.h"

#include <windows.h>

#include <psapi.h>

#include <chrono>

namespace raytracer {

Seconds Seconds::now() {
    FILETIME start{}, end{}, kernel{}, user{};
    GetProcessTimes(GetCurrentProcess(), &start, &end, &kernel, &user);
    const auto seconds = [](const FILETIME& time) {  // FILETIME counts 100 ns
        return 1e-7 * (0x1p32 * time.dwHighDateTime + time.dwLowDateTime);
    };
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
    return {wall.count(), seconds(kernel) + seconds(user)};
}

std::uint64_t peakMemoryBytes() {
    PROCESS_MEMORY_COUNTERS counters{};
    GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return counters.PeakWorkingSetSize;
}

}  // namespace raytracer
