// Runs other programs until they end or exceed a limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raytracer {

// Limits of a program and all processes that it starts.
struct ProcessLimits {
    double processorSeconds = 60;  // the sum over all its processes and threads
    double wallSeconds = 600;
    std::uint64_t memory = std::uint64_t{8} << 30;    // bytes of address space, of each process
    std::uint64_t output = std::uint64_t{256} << 20;  // bytes, of each file
    int processes = 128;                              // at once
};

struct ProcessStart {
    std::string command;                 // for a shell, which splits and expands it
    std::vector<std::string> arguments;  // appended as they are
    std::string output;                  // the file for its standard output and standard error
    ProcessLimits limits = {};
    std::string folder = {};  // its working folder and its TMPDIR; empty: those of this program
    std::string user = {};    // the user that it runs as; empty: this program's
};

std::string signalName(int signal);  // "Segmentation fault"

struct ProcessEnd {
    enum class Stop { None, Hung, TooSlow, TooManyProcesses, TooMuchOutput };

    int exitStatus = 0;  // that of the shell; 127: no such program
    int signal = 0;      // the signal that killed it, or 0
    Stop stop = Stop::None;
    double seconds = 0, processorSeconds = 0;

    bool well() const { return exitStatus == 0 && signal == 0 && stop == Stop::None; }
    // "crashed: Segmentation fault", "hung: stopped after 10 s", "too slow: 2.1 s of processor time", "exit
    // status 3", or "" if all is well.
    std::string description() const;
};

// Runs a program with empty standard input. When it ends or is stopped, all processes that it has started are
// killed, in whatever session they are; so they are when this program ends. A program that kills its
// supervisor counts as crashed. Throws Error if no process can be started.
ProcessEnd runProcess(const ProcessStart& start);

// Runs the programs start(0), ..., start(count - 1), up to `atOnce` at a time, and calls ended(i, how) after
// program i has ended, and meanwhile() every few milliseconds. All three functions are called on this thread.
// No other thread may run meanwhile.
void runProcesses(
    std::size_t count, int atOnce, const std::function<ProcessStart(std::size_t)>& start,
    const std::function<void(std::size_t, const ProcessEnd&)>& ended,
    const std::function<void()>& meanwhile = [] {});

// Throws Error on a platform where programs cannot be run.
void requirePrograms();
// Throws Error if there is no such user, or if this program may not run others as that user.
void requireUser(const std::string& name);
// Makes the user the owner of the folder and of all that is in it. Throws Error.
void giveFolderTo(const std::string& user, const std::string& folder);

}  // namespace raytracer
