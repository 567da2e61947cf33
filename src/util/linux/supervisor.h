// The process between this program and one that it runs: it is the parent of all that is left without one
// there, counts what they use, and kills them all.
#pragma once

#include <sys/types.h>
#include <csignal>

#include "raytracer/util/child_process.h"

namespace raytracer {

// What the supervisor writes to its pipe at the end.
struct SupervisorReport {
    int status = 0;    // of waitpid
    ProcessEnd end{};  // but for what the status says
};

struct UserIds {
    bool other = false;
    uid_t user = 0;
    gid_t group = 0;
};

// Runs and watches the program; SIGTERM, and the end of this process's parent, stop it. In a process of its
// own, made by fork where there is one thread. Where no program can be started it ends with errno as its exit
// status.
[[noreturn]] void supervise(const ProcessStart& start, const UserIds& ids, const sigset_t& signalMask,
                            pid_t parent, int report);

}  // namespace raytracer
