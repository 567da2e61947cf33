// What a process has started.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace raytracer {

// The children of all threads of a process.
std::vector<pid_t> childrenOf(pid_t process);

// With their children, and theirs and so on, until there are more than `most`: each, before it can end, is
// the child of one that is found, or ours.
std::vector<pid_t> descendantsOf(std::vector<pid_t> processes, std::size_t most);

// Kills them with their groups, out of which none gets by forking. Our own group is left alone.
void killWithGroups(const std::vector<pid_t>& processes);

}  // namespace raytracer
