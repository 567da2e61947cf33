#include "../memory_limits.h"

#include <unistd.h>

namespace raytracer {

std::vector<MemoryLeft> memoryLimits() {
    const double bytes =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    return {{bytes, "the machine has "}};
}

}  // namespace raytracer
