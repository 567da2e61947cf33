#include "signals.h"

#include <unistd.h>

#include "../leftover.h"

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
    for (const int signal : endingSignals) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_DFL) ::sigaction(signal, &clearing, nullptr);
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
