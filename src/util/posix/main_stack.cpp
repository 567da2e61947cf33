#include <limits>

#include <sys/resource.h>

#include "raytracer/util/parallel.h"

namespace raytracer {

// The arguments and the environment take up to a quarter
// of the limit (execve(2)). The calls so far take little.
std::size_t mainStack() {
    rlimit limit{};
    getrlimit(RLIMIT_STACK, &limit);
    if (limit.rlim_cur == RLIM_INFINITY) return std::numeric_limits<std::size_t>::max();
    return static_cast<std::size_t>(limit.rlim_cur / 4 * 3);
}

}  // namespace raytracer
