// Other programs, run until they end or a limit stops them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raytracer {

// Of a program with all that it starts.
struct ProcessLimits {
    double processorSeconds = 60;  // of all its processes and threads together
    double wallSeconds = 600;
    std::uint64_t memory = std::uint64_t{8} << 30;    // bytes of address space, of each process
    std::uint64_t output = std::uint64_t{256} << 20;  // bytes, of each file
    int processes = 128;                              // at once
};

struct ProcessStart {
    std::string command;                 // for a shell, which splits and expands it
    std::vector<std::string> arguments;  // which it does not
    std::string output;                  // the file for what it prints
    ProcessLimits limits = {};
    std::string folder = {};  // where it runs, and its TMPDIR; empty: here
    std::string user = {};    // whose rights it has; empty: ours
};

std::string signalName(int signal);  // "Segmentation fault"

struct ProcessEnd {
    enum class Stop { None, Hung, TooSlow, TooManyProcesses, TooMuchOutput };

    int exitStatus = 0;  // as the shell has it; 127: no such program
    int signal = 0;      // that killed it, or 0
    Stop stop = Stop::None;
    double seconds = 0, processorSeconds = 0;

    bool well() const { return exitStatus == 0 && signal == 0 && stop == Stop::None; }
    // "crashed: Segmentation fault", "hung: stopped after 10 s", "too slow: 2.1 s of processor time", "exit
    // status 3", or "" if all is well.
    std::string description() const;
};

// Its input is empty. All that it has started, in whatever session, is killed when it ends or is stopped, and
// where this program ends. Where it kills what watches it, it has crashed. Throws Error where no process can
// be started.
ProcessEnd runProcess(const ProcessStart& start);

// start(i) and, once that has ended, ended(i, how), for each i below the count: `atOnce` of them side by
// side. To be called where no other thread runs, as both functions are in this one.
void runProcesses(std::size_t count, int atOnce, const std::function<ProcessStart(std::size_t)>& start,
                  const std::function<void(std::size_t, const ProcessEnd&)>& ended);

// Throws Error where the platform is not one that programs are run on.
void requirePrograms();
// Throws Error where there is no such user, or where this program may not become another.
void requireUser(const std::string& name);
// Makes the folder, with all that is in it, the user's.
void giveFolderTo(const std::string& user, const std::string& folder);

}  // namespace raytracer
