// Another program, run until it ends or its time is up.
#pragma once

#include <string>
#include <vector>

namespace raytracer {

struct ProcessEnd {
    int exitStatus = 0;  // as the shell has it; 127: no such program
    int signal = 0;      // that killed it, or 0
    bool timedOut = false;
    double seconds = 0;  // of wall time

    bool well() const { return exitStatus == 0 && signal == 0 && !timedOut; }
    std::string description()
        const;  // "crashed: Segmentation fault", "hung: ...", "exit status 3", or "" if all is well
};

// Runs `command arguments...` in a shell, which splits and expands the command but not the arguments. Its
// input is empty, and its output goes to the file `output`. It is killed after `timeoutSeconds`. Processes
// that it has started and not ended are killed too. Throws Error where no process can be started.
ProcessEnd runProcess(const std::string& command, const std::vector<std::string>& arguments,
                      const std::string& output, double timeoutSeconds);

}  // namespace raytracer
