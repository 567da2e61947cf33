#include "leftover.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>

#include "descriptor.h"

namespace raytracer {
namespace {

// All that end a program that does not handle them and that a handler can be told of.
constexpr int endingSignals[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2,
                                 SIGXCPU, SIGABRT, SIGBUS,  SIGFPE,  SIGILL,  SIGSEGV};

sigset_t endingSet() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : endingSignals) sigaddset(&set, signal);
    return set;
}

std::atomic<Leftover*> newest = nullptr;

// The handler stays until all is cleared: a second signal (timeout sends two) may reach another thread
// meanwhile. The first process of a container outlives the default action.
void clearAndEnd(int signal) {
    for (const Leftover* left = newest; left; left = left->older()) left->clear();
    std::signal(signal, SIG_DFL);
    sigset_t own;
    sigemptyset(&own);
    sigaddset(&own, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
    ::raise(signal);
    ::_exit(128 + signal);
}

bool handleEndingSignals() {
    struct sigaction clearing {};
    clearing.sa_handler = clearAndEnd;
    clearing.sa_mask = endingSet();
    for (const int signal : endingSignals) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_DFL) ::sigaction(signal, &clearing, nullptr);
    }
    return true;
}

// Its maker may have locked it. `name` is no link, for that gives another error.
Descriptor openFolder(int parent, const char* name) {
    constexpr int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    Descriptor folder(::openat(parent, name, flags));
    if (folder || errno != EACCES || ::fchmodat(parent, name, S_IRWXU, 0) != 0) return folder;
    return Descriptor(::openat(parent, name, flags));
}

// opendir is not allowed in a handler. `entry` is what the kernel writes for getdents64.
void removeContents(int folder) {
    ::fchmod(folder, S_IRWXU);
    alignas(dirent64) char entries[1024];
    for (;;) {
        const auto size = ::syscall(SYS_getdents64, folder, entries, sizeof entries);
        if (size <= 0) return;
        for (long at = 0; at < size;) {
            const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
            at += entry->d_reclen;
            const char* const name = entry->d_name;
            const bool isOther = name[0] != '.' || (name[1] && (name[1] != '.' || name[2]));
            if (!isOther || ::unlinkat(folder, name, 0) == 0) continue;
            const Descriptor inner = openFolder(folder, name);
            if (inner) removeContents(inner.get());
            ::unlinkat(folder, name, AT_REMOVEDIR);
        }
    }
}

}  // namespace

SignalsWait::SignalsWait() {
    const sigset_t waiting = endingSet();
    ::pthread_sigmask(SIG_BLOCK, &waiting, &before_);
}

SignalsWait::~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

Leftover::Leftover(void (*toClear)(const void* what), const void* what)
    : clear_(toClear), what_(what), older_(newest) {
    [[maybe_unused]] static const bool handled = handleEndingSignals();
    newest = this;
}

Leftover::~Leftover() {
    if (newest == this) newest = older_;
    for (Leftover* newer = newest; newer; newer = newer->older_)
        if (newer->older_ == this) newer->older_ = older_;
}

void removeFile(const void* path) { ::unlink(static_cast<const char*>(path)); }

void removeFolder(const void* path) {
    const auto* const name = static_cast<const char*>(path);
    // A process that is being killed may still make a file.
    for (int attempt = 0; attempt < 100 && ::rmdir(name) != 0 && errno != ENOENT; ++attempt) {
        const Descriptor folder = openFolder(AT_FDCWD, name);
        if (!folder) return;
        removeContents(folder.get());
    }
}

}  // namespace raytracer
