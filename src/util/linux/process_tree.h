// Finds and kills the descendants of a process.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace raytracer {

// The children of all threads of a process.
std::vector<pid_t> childrenOf(pid_t process);

// These processes and their descendants; stops when there are more than `most`. A descendant whose parent has
// ended is not found here: it is a child of this process, the subreaper.
std::vector<pid_t> descendantsOf(std::vector<pid_t> processes, std::size_t most);

// Kills the processes and their process groups, so that one that forks meanwhile does not escape. Our own
// group is left alone.
void killWithGroups(const std::vector<pid_t>& processes);

}  // namespace raytracer
