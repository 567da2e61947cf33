// The supervisor is a process between this program and one that it runs. It becomes the parent of all orphans
// there (as a subreaper), counts what the processes use, and kills them all in the end.
#pragma once

#include <sys/types.h>
#include <csignal>

#include "raytracer/util/child_process.h"

namespace raytracer {

// What the supervisor writes to its pipe at the end.
struct SupervisorReport {
    int status = 0;    // of waitpid
    ProcessEnd end{};  // without what `status` says
};

struct UserIds {
    bool other = false;
    uid_t user = 0;
    gid_t group = 0;
};

// Runs the program and watches it. SIGTERM, or the end of this process's parent, stops the program. To be
// called in a process of its own, which is forked while there is only one thread. If no program can be
// started, this process ends with errno as its exit status.
[[noreturn]] void supervise(const ProcessStart& start, const UserIds& ids, const sigset_t& signalMask,
                            pid_t parent, int report);

}  // namespace raytracer
