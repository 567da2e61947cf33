#include <windows.h>

#include "raytracer/util/parallel.h"

namespace raytracer {

std::size_t mainStack() {
    ULONG_PTR low = 0, high = 0;
    GetCurrentThreadStackLimits(&low, &high);
    return (high - low) / 4 * 3;
}

}  // namespace raytracer
