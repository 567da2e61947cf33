#include "raytracer/util/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <sstream>
#include <thread>

#include "descriptor.h"
#include "leftover.h"
#include "raytracer/util/error.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace raytracer {

namespace {

using Clock = std::chrono::steady_clock;

// No file over 1 GiB (2^21 blocks of 512 bytes): a program that prints without end must not fill the disk.
constexpr const char* shellPrefix = "ulimit -f 2097152; ";

// What the child has started in other process groups: when its parent has ended, it becomes a child of this
// process (PR_SET_CHILD_SUBREAPER). True where there was any.
bool killOrphans(pid_t child, const char* listOfChildren) {
    const Descriptor list(::open(listOfChildren, O_RDONLY | O_CLOEXEC));
    char text[4096];
    const ssize_t size = list ? ::read(list.get(), text, sizeof text) : 0;
    bool found = false;
    pid_t number = 0;
    for (ssize_t i = 0; i < size; ++i) {
        if (text[i] != ' ') {
            number = 10 * number + (text[i] - '0');
            continue;
        }
        if (number != child && ::kill(number, SIGKILL) == 0 && ::waitpid(number, nullptr, 0) == number)
            found = true;
        number = 0;
    }
    return found;
}

struct Started {
    pid_t child;
    std::string listOfChildren = "/proc/self/task/" + std::to_string(::getpid()) + "/children";
};

// The child has a process group of its own, so that it can be killed with all in it.
void killAll(const void* started) {
    const auto& [child, list] = *static_cast<const Started*>(started);
    ::kill(-child, SIGKILL);
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
    while (killOrphans(child, list.c_str())) {
    }
}

// The child ignores no signal that this program does (prepareStandardStreams).
sigset_t signalsOfDefault() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGPIPE);
    sigaddset(&set, SIGXFSZ);
    return set;
}

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
    const sigset_t defaults = signalsOfDefault();
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/bin/sh", &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw Error({output}, std::string("cannot start a process: ") + std::strerror(error));
    return child;
}

// True once the child has ended. It stays a zombie, so that no other process can get its number.
bool hasEnded(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           info.si_pid == child;
}

bool endsWithin(pid_t child, Clock::time_point start, std::chrono::duration<double> limit) {
    // Polled, since no portable call waits for a child with a time limit. 2 ms are short beside a render.
    while (!hasEnded(child)) {
        if (Clock::now() - start >= limit) return false;
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
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::optional<SignalsWait> signalsWait(std::in_place);
    const Started started{spawn(words, output, signalsWait->before())};
    const pid_t child = started.child;
    std::optional<Leftover> all(std::in_place, killAll, &started);
    signalsWait.reset();
    ProcessEnd end;
    end.timedOut = !endsWithin(child, start, std::chrono::duration<double>(timeoutSeconds));
    all->clear();
    all.reset();  // before another process can get its number
    end.seconds = end.timedOut ? timeoutSeconds : std::chrono::duration<double>(Clock::now() - start).count();
    const int status = reap(child);
    if (!end.timedOut) readStatus(status, end);
    return end;
}

}  // namespace raytracer
