// Measures the time and the memory that the process has used.
#pragma once

#include <cstdint>
#include <utility>

namespace raytracer {

// Wall time, and CPU time of all threads, in seconds.
struct Seconds {
    double wall = 0, cpu = 0;
    static Seconds now();
    Seconds& operator+=(const Seconds& more) {
        wall += more.wall;
        cpu += more.cpu;
        return *this;
    }
};

// The most memory that the process has had resident at once.
std::uint64_t peakMemoryBytes();

// lap() returns the time since the last lap, or since construction.
class Stopwatch {
  public:
    Seconds lap() {
        const Seconds before = std::exchange(last_, Seconds::now());
        return {last_.wall - before.wall, last_.cpu - before.cpu};
    }

  private:
    Seconds last_ = Seconds::now();
};

}  // namespace raytracer
