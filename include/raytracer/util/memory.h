// Memory for what is large is asked for before it is taken. Where there is too little, a system mostly gives
// it all the same, and kills the process when it is used.
#pragma once

#include <initializer_list>
#include <string>

namespace raytracer {

// How much the process can still take, and who sets that limit: the least of ulimit -v (RLIMIT_AS), ulimit -d
// (RLIMIT_DATA), the limits of its control groups (version 1 and 2), and the machine's available memory.
struct MemoryLeft {
    double bytes = 0;
    std::string inWords;  // "ulimit -v leaves 12.3 MB"
};
MemoryLeft memoryLeft();
bool hasMemory(double bytes);

struct MemoryNeed {
    std::string what;  // "18000 × 18000 pixels"
    double bytes = 0;
};

// Throws Error, about `file`, where there is not enough for all of them: "not enough memory for
// 18000 × 18000 pixels (972 MB) and the PNG (1.94 GB): ulimit -v leaves 12.3 MB".
void requireMemory(const std::string& file, std::initializer_list<MemoryNeed> needs);

}  // namespace raytracer
