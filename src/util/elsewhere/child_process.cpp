// Only Linux lets a program find and stop all that another one has started (src/util/linux/supervisor.cpp).
#include "raytracer/util/child_process.h"

#include "raytracer/util/error.h"

namespace raytracer {
namespace {

[[noreturn]] void refuse() {
    throw Error("programs are run on Linux only; the pictures that they have made are graded here too");
}

}  // namespace

std::string signalName(int) { return {}; }

void runProcesses(std::size_t count, int, const std::function<ProcessStart(std::size_t)>&,
                  const std::function<void(std::size_t, const ProcessEnd&)>&) {
    if (count > 0) refuse();
}

void requireUser(const std::string& name) {
    if (!name.empty()) refuse();
}

void giveFolderTo(const std::string&, const std::string&) {}

}  // namespace raytracer
