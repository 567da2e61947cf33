#include "raytracer/util/child_process.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <list>
#include <optional>
#include <thread>

#include "../descriptor.h"
#include "../leftover.h"
#include "../posix/signals.h"
#include "process_tree.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"
#include "supervisor.h"

namespace raytracer {

namespace {

UserIds idsOf(const std::string& name) {
    if (name.empty()) return {};
    const passwd* const user = ::getpwnam(name.c_str());
    if (!user) throw Error("there is no user " + printable(name));
    return {true, user->pw_uid, user->pw_gid};
}

// Stops the supervisor, and waits until it has ended, so that all is cleared when a signal's handler goes on.
// SIGCONT is for a supervisor that the program has halted.
void stopSupervisor(const void* process) {
    const pid_t supervisor = *static_cast<const pid_t*>(process);
    ::kill(supervisor, SIGTERM);
    ::kill(supervisor, SIGCONT);
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(supervisor), &info, WEXITED | WNOWAIT);
}

// If a signal has killed the program, the shell's exit status
// is 128 + signal (POSIX only says "greater than 128").
ProcessEnd endOf(const SupervisorReport& report) {
    constexpr int lastSignal = 31;
    ProcessEnd end = report.end;
    if (end.stop != ProcessEnd::Stop::None) return end;
    if (WIFSIGNALED(report.status)) end.signal = WTERMSIG(report.status);
    if (WIFEXITED(report.status)) end.exitStatus = WEXITSTATUS(report.status);
    if (end.exitStatus > 128 && end.exitStatus <= 128 + lastSignal) end.signal = end.exitStatus - 128;
    if (end.signal == SIGXFSZ) end.stop = ProcessEnd::Stop::TooMuchOutput;
    return end;
}

// Kills what a supervisor would have killed if it had not been killed itself. Those processes are children of
// this one now. They are known by their session: no other child of this process has one of its own.
void killStrays() {
    for (;;) {
        std::vector<pid_t> strays = childrenOf(::getpid());
        std::erase_if(strays, [](pid_t child) { return ::getsid(child) == ::getsid(0); });
        if (strays.empty()) return;
        killWithGroups(descendantsOf(strays, 1 << 16));
        for (const pid_t stray : strays) ::waitpid(stray, nullptr, WNOHANG);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

// A running program with its supervisor. The program may
// kill or halt the supervisor if both have the same user.
class Running {
  public:
    explicit Running(const ProcessStart& start) {
        const UserIds ids = idsOf(start.user);
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) throw systemError(start.output, "cannot start a process");
        report_ = Descriptor(ends[0]);
        wallSeconds_ = start.limits.wallSeconds;
        ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans become our children, for killStrays
        const Descriptor toReport(ends[1]);
        const pid_t self = ::getpid();
        const SignalsWait signalsWait;
        supervisor_ = ::fork();
        if (supervisor_ == 0) supervise(start, ids, signalsWait.before(), self, toReport.get());
        if (supervisor_ < 0) throw systemError(start.output, "cannot start a process");
        leftover_.emplace(stopSupervisor, &supervisor_);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (!leftover_) return;
        leftover_->clear();
        ::waitpid(supervisor_, nullptr, 0);
    }

    // How the program has ended; empty while it runs.
    std::optional<ProcessEnd> end() {
        siginfo_t info{};
        const bool isThere =
            ::waitid(P_PID, static_cast<id_t>(supervisor_), &info, WEXITED | WNOHANG | WNOWAIT) == 0;
        if (isThere && info.si_pid != supervisor_) {
            constexpr double forItsReport = 1;  // seconds that the supervisor gets to stop the program
            if (seconds() > wallSeconds_ + forItsReport) ::kill(supervisor_, SIGKILL);
            return std::nullopt;
        }
        leftover_.reset();  // before waitpid, after which another process can get the number
        int status = 0;
        ::waitpid(supervisor_, &status, 0);
        SupervisorReport report;
        if (::read(report_.get(), &report, sizeof report) == sizeof report) return endOf(report);
        return endWithoutReport(status);
    }

  private:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    ProcessEnd endWithoutReport(int status) const {
        if (WIFEXITED(status)) {
            errno = WEXITSTATUS(status);
            throw systemError("", "cannot start a process");
        }
        killStrays();
        ProcessEnd end;
        end.signal = WTERMSIG(status);
        end.seconds = std::min(seconds(), wallSeconds_);
        if (end.seconds == wallSeconds_) end.stop = ProcessEnd::Stop::Hung;
        return end;
    }

    pid_t supervisor_ = 0;
    Descriptor report_;
    std::optional<Leftover> leftover_;
    double wallSeconds_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

std::string signalName(int signal) { return strsignal(signal); }

void runProcesses(std::size_t count, int atOnce, const std::function<ProcessStart(std::size_t)>& start,
                  const std::function<void(std::size_t, const ProcessEnd&)>& ended,
                  const std::function<void()>& meanwhile) {
    struct Numbered {
        Numbered(std::size_t i, const ProcessStart& how) : number(i), running(how) {}
        std::size_t number;
        Running running;
    };
    std::list<Numbered> running;
    for (std::size_t next = 0; next < count || !running.empty();) {
        while (next < count && running.size() < static_cast<std::size_t>(atOnce)) {
            running.emplace_back(next, start(next));
            ++next;
        }
        // Polled, since no portable call waits for several children with their time limits.
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        meanwhile();
        for (auto one = running.begin(); one != running.end();) {
            const auto end = one->running.end();
            if (!end) {
                ++one;
                continue;
            }
            const std::size_t number = one->number;
            one = running.erase(one);
            ended(number, *end);
        }
    }
}

void requirePrograms() {}

void requireUser(const std::string& name) {
    if (name.empty()) return;
    if (::geteuid() != 0) throw Error("only root may run programs as another user");
    idsOf(name);
}

void giveFolderTo(const std::string& user, const std::string& folder) {
    if (user.empty()) return;
    const UserIds ids = idsOf(user);
    const auto give = [&](const std::string& path) {
        if (::lchown(path.c_str(), ids.user, ids.group) != 0)
            throw systemError(path, "cannot give it to " + user);
    };
    std::error_code error;
    std::filesystem::recursive_directory_iterator entry(folder, error), end;
    for (; !error && entry != end; entry.increment(error)) give(entry->path().string());
    if (error) throw Error({folder}, "cannot give it to " + user + ": " + error.message());
    give(folder);  // last: until then the user can change nothing in it
}

}  // namespace raytracer
