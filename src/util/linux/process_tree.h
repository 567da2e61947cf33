// What a process has started.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace raytracer {

// The children of all threads of a process.
std::vector<pid_t> childrenOf(pid_t process);

// These processes and their descendants, until there are more than `most`. One whose parent has ended is a
// child of ours.
std::vector<pid_t> descendantsOf(std::vector<pid_t> processes, std::size_t most);

// Kills them with their groups, out of which none gets by forking. Our own group is left alone.
void killWithGroups(const std::vector<pid_t>& processes);

}  // namespace raytracer
