// What each limit still leaves to the process. Each platform has its own version.
#pragma once

#include <vector>

#include "raytracer/util/memory.h"

namespace raytracer {

std::vector<MemoryLeft> memoryLimits();  // at least one

}  // namespace raytracer
