// How much memory the process can still take, as the platform tells.
#pragma once

#include <vector>

#include "raytracer/util/memory.h"

namespace raytracer {

std::vector<MemoryLeft> memoryLimits();  // at least one

}  // namespace raytracer
