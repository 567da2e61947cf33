#include "raytracer/util/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <sstream>
#include <thread>

#include "raytracer/util/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace raytracer {

namespace {

using Clock = std::chrono::steady_clock;

// No file over 1 GiB (2^21 blocks of 512 bytes): a program that prints without end must not fill the disk.
constexpr const char* shellPrefix = "ulimit -f 2097152; ";

std::atomic<pid_t> runningGroup = 0;

void killGroupAndDie(int signal) {
    if (const pid_t group = runningGroup) ::kill(-group, SIGKILL);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// The child has a process group of its own, so that it can be killed with all its children. The terminal's
// Ctrl-C does not reach that group, so this passes it on.
class GroupGuard {
  public:
    explicit GroupGuard(pid_t group) {
        runningGroup = group;
        interrupt_ = std::signal(SIGINT, killGroupAndDie);
        terminate_ = std::signal(SIGTERM, killGroupAndDie);
    }
    ~GroupGuard() {
        std::signal(SIGINT, interrupt_);
        std::signal(SIGTERM, terminate_);
        runningGroup = 0;
    }
    GroupGuard(const GroupGuard&) = delete;
    GroupGuard& operator=(const GroupGuard&) = delete;

  private:
    void (*interrupt_)(int);
    void (*terminate_)(int);
};

// Delays interrupts from before the child's start until the guard is there, so that none misses the child.
class InterruptsWait {
  public:
    InterruptsWait() {
        sigset_t interrupts;
        sigemptyset(&interrupts);
        sigaddset(&interrupts, SIGINT);
        sigaddset(&interrupts, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &interrupts, &before_);
    }
    ~InterruptsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    InterruptsWait(const InterruptsWait&) = delete;
    InterruptsWait& operator=(const InterruptsWait&) = delete;

    const sigset_t& before() const { return before_; }

  private:
    sigset_t before_;
};

pid_t spawn(const std::vector<std::string>& words, const std::string& output, const sigset_t& signalMask) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &signalMask);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/bin/sh", &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw Error(std::string("cannot start a process: ") + std::strerror(error));
    return child;
}

// True once the child has ended. It stays a zombie, so that no other process can get its number.
bool hasEnded(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           info.si_pid == child;
}

bool endsBefore(pid_t child, Clock::time_point deadline) {
    // Polled, since no portable call waits for a child with a time limit. 2 ms are short beside a render.
    while (!hasEnded(child)) {
        if (Clock::now() >= deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

int reap(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

// The exit status of a shell whose program a signal has killed is 128 + signal (POSIX says only "over 128").
void readStatus(int status, ProcessEnd& end) {
    constexpr int lastSignal = 31;
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    if (WIFEXITED(status)) end.exitStatus = WEXITSTATUS(status);
    if (end.exitStatus > 128 && end.exitStatus <= 128 + lastSignal) end.signal = end.exitStatus - 128;
}

}  // namespace

std::string ProcessEnd::description() const {
    std::ostringstream text;
    if (timedOut) text << "hung: stopped after " << seconds << " s";
    else if (signal) text << "crashed: " << strsignal(signal);
    else if (exitStatus == 127) text << "could not be started";
    else if (exitStatus) text << "exit status " << exitStatus;
    return text.str();
}

ProcessEnd runProcess(const std::string& command, const std::vector<std::string>& arguments,
                      const std::string& output, double timeoutSeconds) {
    std::vector<std::string> words{"sh", "-c", shellPrefix + command + " \"$@\"", "sh"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Clock::time_point start = Clock::now();
    std::optional<InterruptsWait> interruptsWait(std::in_place);
    const pid_t child = spawn(words, output, interruptsWait->before());
    const GroupGuard guard(child);
    interruptsWait.reset();
    ProcessEnd end;
    end.timedOut = !endsBefore(child, start + std::chrono::duration_cast<Clock::duration>(
                                                  std::chrono::duration<double>(timeoutSeconds)));
    ::kill(-child, SIGKILL);
    end.seconds = end.timedOut ? timeoutSeconds : std::chrono::duration<double>(Clock::now() - start).count();
    const int status = reap(child);
    if (!end.timedOut) readStatus(status, end);
    return end;
}

}  // namespace raytracer
