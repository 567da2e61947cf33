#include "process_tree.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace raytracer {

std::vector<pid_t> childrenOf(pid_t process) {
    std::vector<pid_t> found;
    std::error_code isGone;
    std::filesystem::directory_iterator thread("/proc/" + std::to_string(process) + "/task", isGone), end;
    for (; !isGone && thread != end; thread.increment(isGone)) {
        std::ifstream children(thread->path() / "children");
        for (pid_t child = 0; children >> child;) found.push_back(child);
    }
    return found;
}

std::vector<pid_t> descendantsOf(std::vector<pid_t> processes, std::size_t most) {
    for (std::size_t i = 0; i < processes.size() && processes.size() <= most; ++i)
        std::ranges::copy(childrenOf(processes[i]), std::back_inserter(processes));
    return processes;
}

void killWithGroups(const std::vector<pid_t>& processes) {
    for (const pid_t process : processes) {
        const pid_t group = ::getpgid(process);
        if (group > 0 && group != ::getpgrp()) ::kill(-group, SIGKILL);
        ::kill(process, SIGKILL);
    }
}

}  // namespace raytracer
