#include "supervisor.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "../descriptor.h"
#include "process_tree.h"

namespace raytracer {

namespace {

using SteadyClock = std::chrono::steady_clock;

std::size_t readInto(const char* path, char* text, std::size_t most) {
    const Descriptor file(::open(path, O_RDONLY | O_CLOEXEC));
    const ssize_t size = file ? ::read(file.get(), text, most - 1) : 0;
    text[std::max<ssize_t>(0, size)] = '\0';
    return static_cast<std::size_t>(std::max<ssize_t>(0, size));
}

// Processor seconds of a process and of the children that it has waited for: fields 14 to 17 of
// /proc/PID/stat (proc(5)).
double processorSecondsOf(pid_t process) {
    char path[64], text[1024];
    std::snprintf(path, sizeof path, "/proc/%d/stat", process);
    readInto(path, text, sizeof text);
    const char* after = std::strrchr(text, ')');
    unsigned long user = 0, system = 0;
    long usersChildren = 0, systemsChildren = 0;
    if (!after || std::sscanf(after + 2, "%*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %ld %ld", &user,
                              &system, &usersChildren, &systemsChildren) != 4)
        return 0;
    static const double ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
    return static_cast<double>(user + system + static_cast<unsigned long>(usersChildren + systemsChildren)) /
           ticks;
}

double secondsOf(const rusage& usage) {
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double reapedSeconds() {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return secondsOf(usage);
}

void limit(int resource, std::uint64_t most) {
    rlimit limits{};
    ::getrlimit(static_cast<__rlimit_resource>(resource), &limits);
    limits.rlim_cur = limits.rlim_max = std::min<rlim_t>(most, limits.rlim_max);
    ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

void setLimits(const ProcessLimits& limits, bool hasOtherUser) {
    limit(RLIMIT_AS, limits.memory);
    limit(RLIMIT_FSIZE, limits.output);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::min(1e9, std::ceil(limits.processorSeconds) + 2)));
    if (hasOtherUser) limit(RLIMIT_NPROC, static_cast<std::uint64_t>(limits.processes));
}

bool becomeUser(const ProcessStart& start, const UserIds& ids) {
    return !ids.other || (::initgroups(start.user.c_str(), ids.group) == 0 && ::setgid(ids.group) == 0 &&
                          ::setuid(ids.user) == 0);
}

bool openStreams(const std::string& output) {
    const int input = ::open("/dev/null", O_RDONLY);
    if (input < 0) return false;
    const int printed = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    return printed >= 0 && ::dup2(input, STDIN_FILENO) >= 0 && ::dup2(printed, STDOUT_FILENO) >= 0 &&
           ::dup2(printed, STDERR_FILENO) >= 0;
}

void defaultSignals(const sigset_t& mask) {
    for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &mask, nullptr);
}

// Turns this process into the program: a shell that runs the command.
[[noreturn]] void become(const ProcessStart& start, const UserIds& ids, const sigset_t& signalMask) {
    ::setsid();
    if (!start.folder.empty()) ::setenv("TMPDIR", start.folder.c_str(), 1);
    if (!becomeUser(start, ids)) ::_exit(126);
    const std::string script = start.command + " \"$@\"";
    std::vector<const char*> words{"sh", "-c", script.c_str(), "sh"};
    for (const std::string& argument : start.arguments) words.push_back(argument.c_str());
    words.push_back(nullptr);
    ::closefrom(3);
    defaultSignals(signalMask);
    setLimits(start.limits, ids.other);  // last: the limits are not meant for the steps above
    ::execv("/bin/sh", const_cast<char* const*>(words.data()));
    ::_exit(127);
}

// Watches this process's descendants, the program and all that it has started.
class Supervisor {
  public:
    Supervisor(pid_t child, const ProcessLimits& limits) : child_(child), limits_(limits) {}

    SupervisorReport watch() {
        while (!hasEnded() && report_.end.stop == ProcessEnd::Stop::None && !isTold_) {
            waitForSignal();
            checkLimits();
        }
        report_.end.seconds = report_.end.stop == ProcessEnd::Stop::Hung ? limits_.wallSeconds : seconds();
        killAll();
        report_.end.processorSeconds = reapedSeconds();
        const bool isSlow = report_.end.processorSeconds > limits_.processorSeconds;
        if (report_.end.stop == ProcessEnd::Stop::None && isSlow)
            report_.end.stop = ProcessEnd::Stop::TooSlow;
        return report_;
    }

  private:
    double seconds() const { return std::chrono::duration<double>(SteadyClock::now() - start_).count(); }

    // Reaps the children that have ended. True once the program itself has.
    bool hasEnded() {
        int status = 0;
        for (pid_t ended; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;) {
            if (ended != child_) continue;
            report_.status = status;
            childEnded_ = true;
        }
        return childEnded_;
    }

    // Waits for 5 ms, which are short compared with a render, or until the program ends or SIGTERM arrives.
    void waitForSignal() {
        sigset_t set;
        sigemptyset(&set);
        sigaddset(&set, SIGCHLD);
        sigaddset(&set, SIGTERM);
        const timespec time{0, 5'000'000};
        isTold_ = ::sigtimedwait(&set, nullptr, &time) == SIGTERM;
    }

    void checkLimits() {
        const auto processes =
            descendantsOf(childrenOf(::getpid()), static_cast<std::size_t>(limits_.processes));
        double used = reapedSeconds();
        for (const pid_t process : processes) used += processorSecondsOf(process);
        if (used > limits_.processorSeconds) report_.end.stop = ProcessEnd::Stop::TooSlow;
        else if (seconds() > limits_.wallSeconds) report_.end.stop = ProcessEnd::Stop::Hung;
        else if (processes.size() > static_cast<std::size_t>(limits_.processes))
            report_.end.stop = ProcessEnd::Stop::TooManyProcesses;
    }

    // Kills all descendants, and repeats that until no child is left to wait for.
    void killAll() {
        for (;;) {
            killWithGroups(descendantsOf(childrenOf(::getpid()), 1 << 16));
            int status = 0;
            pid_t ended = 0;
            while ((ended = ::waitpid(-1, &status, WNOHANG)) > 0)
                if (ended == child_ && !childEnded_) report_.status = status;
            if (ended < 0 && errno == ECHILD) return;
            const timespec time{0, 1'000'000};
            ::nanosleep(&time, nullptr);
        }
    }

    pid_t child_;
    const ProcessLimits& limits_;
    SteadyClock::time_point start_ = SteadyClock::now();
    SupervisorReport report_;
    bool childEnded_ = false, isTold_ = false;
};

}  // namespace

void supervise(const ProcessStart& start, const UserIds& ids, const sigset_t& signalMask, pid_t parent,
               int report) {
    sigset_t all;
    sigfillset(&all);
    ::sigprocmask(SIG_SETMASK, &all, nullptr);
    defaultSignals(all);
    ::setpgid(0, 0);  // a terminal's signals (Ctrl+C) are for our parent
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);
    const bool isReady =
        openStreams(start.output) && (start.folder.empty() || ::chdir(start.folder.c_str()) == 0);
    if (!isReady) ::_exit(errno);
    const pid_t child = ::fork();
    if (child == 0) become(start, ids, signalMask);
    if (child < 0) ::_exit(errno);
    const SupervisorReport result = Supervisor(child, start.limits).watch();
    const char* const bytes = reinterpret_cast<const char*>(&result);
    ::_exit(writeAll(report, {bytes, sizeof result}) ? 0 : 1);
}

}  // namespace raytracer
