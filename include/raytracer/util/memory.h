// Checks for enough memory before a large allocation. Most systems grant an allocation even if there is too
// little memory, and kill the process when it uses the memory.
#pragma once

#include <new>
#include <string>

#include "raytracer/util/error.h"

namespace raytracer {

// How much memory the process can still take, and which limit that is: the least of ulimit -v (RLIMIT_AS),
// ulimit -d (RLIMIT_DATA), the limits of its control groups (versions 1 and 2), and the machine's available
// memory. Less a MiB for what is not counted. Other platforms than Linux know the machine's memory only.
struct MemoryLeft {
    double bytes = 0;
    std::string inWords;  // "ulimit -v leaves 12.3 MB"
};
MemoryLeft memoryLeft();
bool hasMemory(double bytes);  // looks at the limits only once in a MiB

// There is too little memory: no fault of the file that the Error is about.
class OutOfMemory : public Error {
  public:
    using Error::Error;
};

// Throws OutOfMemory, about `file` (empty: none), if there is not enough: "not enough memory for 18000 ×
// 18000 pixels (972 MB): ulimit -v leaves 12.3 MB".
void requireMemory(const std::string& file, const std::string& what, double bytes);

// Makes room in a list for so many elements, if there is enough memory for these. `what`: "shapes".
template <class List>
void reserveMemory(List& list, std::size_t count, const std::string& file, const char* what) {
    requireMemory(file, std::to_string(count) + " " + what, static_cast<double>(sizeof(list[0]) * count));
    list.reserve(count);
}

// Calls work(), for what cannot be counted before. A std::bad_alloc becomes such an Error, without a number.
[[noreturn]] void failForMemory(const std::string& file, const std::string& what);
template <class Work>
auto withMemoryFor(const std::string& file, const std::string& what, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        failForMemory(file, what);
    }
}

}  // namespace raytracer
