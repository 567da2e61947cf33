#include "signals.h"

#include <unistd.h>

#include "../leftover.h"

namespace raytracer {
namespace {

// Those that end no program, and those that no handler can be told of.
constexpr int otherSignals[] = {
    SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGCONT, SIGCHLD, SIGURG, SIGWINCH,
#if defined(SIGINFO)
    SIGINFO, SIGIO  // BSD, macOS
#endif
};

// All others, those without a name (SIGRTMIN to SIGRTMAX) too.
sigset_t endingSet() {
    sigset_t set;
    sigfillset(&set);
    for (const int signal : otherSignals) sigdelset(&set, signal);
    return set;
}

// The handler stays until all is cleared: a second signal (timeout sends two) may reach another thread
// meanwhile. The first process of a container outlives the default action.
void clearAndEnd(int signal) {
    Leftover::clearAll();
    std::signal(signal, SIG_DFL);
    sigset_t own;
    sigemptyset(&own);
    sigaddset(&own, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
    ::raise(signal);
    ::_exit(128 + signal);
}

}  // namespace

void handleEndingSignals() {
    struct sigaction clearing {};
    clearing.sa_handler = clearAndEnd;
    clearing.sa_mask = endingSet();
    for (int signal = 1; signal < NSIG; ++signal) {
        struct sigaction before {};
        const bool ends =
            sigismember(&clearing.sa_mask, signal) == 1 && ::sigaction(signal, nullptr, &before) == 0;
        if (ends && before.sa_handler == SIG_DFL) ::sigaction(signal, &clearing, nullptr);
    }
}

void withoutEndingSignals(const std::function<void()>& work) {
    const SignalsWait wait;
    work();
}

SignalsWait::SignalsWait() {
    const sigset_t waiting = endingSet();
    ::pthread_sigmask(SIG_BLOCK, &waiting, &before_);
}

SignalsWait::~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace raytracer
