#include "../memory_limits.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace raytracer {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// The number at the file's beginning; unlimited if there is none ("max").
double numberIn(const std::string& path) {
    double number = 0;
    return std::ifstream(path) >> number ? number : unlimited;
}

double availableBytes() {
    std::ifstream file("/proc/meminfo");
    for (std::string key, rest; file >> key; std::getline(file, rest)) {
        double kibibytes = 0;
        if (key == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
    }
    return unlimited;
}

// The least limit of a control group and of the groups around it. Inside a container, the outer part of the
// path does not exist, and counts as unlimited.
double groupLimit(const std::string& root, std::string path, const char* file) {
    double least = unlimited;
    for (;; path.resize(path.rfind('/'))) {
        least = std::min(least, numberIn(root + path + file));
        if (path.find('/') == path.npos) return least;
    }
}

// The lines of /proc/self/cgroup are NUMBER:CONTROLLERS:PATH; version 2 has no controllers.
double controlGroupLimit() {
    double least = unlimited;
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string path = line.substr(second + 1);
        if (controllers.empty()) least = std::min(least, groupLimit("/sys/fs/cgroup", path, "/memory.max"));
        if (controllers.find("memory") != controllers.npos)
            least = std::min(least, groupLimit("/sys/fs/cgroup/memory", path, "/memory.limit_in_bytes"));
    }
    return least;
}

struct UsedBytes {
    double addresses = 0, resident = 0, data = 0;
};

// The process's address space, the part of it that is resident, and its private writable part.
UsedBytes usedBytes() {
    double addresses = 0, resident = 0, shared = 0, code = 0, libraries = 0, data = 0;
    std::ifstream("/proc/self/statm") >> addresses >> resident >> shared >> code >> libraries >> data;
    const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
    return {page * addresses, page * resident, page * data};
}

double processLimit(__rlimit_resource resource) {
    rlimit limit{};
    const bool isSet = ::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return isSet ? static_cast<double>(limit.rlim_cur) : unlimited;
}

}  // namespace

std::vector<MemoryLeft> memoryLimits() {
    const UsedBytes used = usedBytes();
    return {{availableBytes(), "the machine has left "},
            {controlGroupLimit() - used.resident, "the control group's limit leaves "},
            {processLimit(RLIMIT_AS) - used.addresses, "ulimit -v leaves "},
            {processLimit(RLIMIT_DATA) - used.data, "ulimit -d leaves "}};
}

}  // namespace raytracer
