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

// Runs `command arguments...` by the shell, which splits and expands the command but leaves the arguments as
// they are. It reads nothing; what it prints goes to the file `output`. After `timeoutSeconds` it is killed,
// and with its end whatever it has started and left behind. Throws Error where there is no process to
// be had.
ProcessEnd runProcess(const std::string& command, const std::vector<std::string>& arguments,
                      const std::string& output, double timeoutSeconds);

}  // namespace raytracer
