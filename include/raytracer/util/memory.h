// Memory for what is large is asked for before it is taken. Where there is too little, a system mostly gives
// it all the same, and kills the process when it is used.
#pragma once

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

// Throws Error, about `file`, where there is not enough: "not enough memory for 18000 × 18000 pixels (972
// MB): ulimit -v leaves 12.3 MB".
void requireMemory(const std::string& file, const std::string& what, double bytes);

}  // namespace raytracer
