#include "signals.h"

#include <unistd.h>

#include "../leftover.h"

namespace raytracer {
namespace {

// Signals that do not end a program, and those that no handler can catch.
constexpr int otherSignals[] = {
    SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGCONT, SIGCHLD, SIGURG, SIGWINCH,
#if defined(SIGINFO)
    SIGINFO, SIGIO  // BSD, macOS
#endif
};

// All other signals, including those without a name (SIGRTMIN to SIGRTMAX).
sigset_t endingSet() {
    sigset_t set;
    sigfillset(&set);
    for (const int signal : otherSignals) sigdelset(&set, signal);
    return set;
}

// The handler stays in place until all is cleared, since a second signal
// may reach another thread meanwhile (timeout(1) sends two). _exit is for
// the first process of a container, which the default action does not end.
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
