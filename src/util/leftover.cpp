#include "leftover.h"

#include <unistd.h>

#include <atomic>
#include <utility>

namespace raytracer {
namespace {

Leftover* newest = nullptr;
std::atomic_flag isBusy;  // a lock for the list

void take() {
    while (isBusy.test_and_set()) {
    }
}

// Signals are blocked while the lock is held: a handler on this thread would wait for the lock for ever.
void changeList(const std::function<void()>& change) {
    withoutEndingSignals([&] {
        take();
        change();
        isBusy.clear();
    });
}

}  // namespace

Leftover::Leftover(void (*toClear)(const void* what), const void* what) : clear_(toClear), what_(what) {
    [[maybe_unused]] static const bool handled = [] {
        handleEndingSignals();
        return true;
    }();
    changeList([this] { older_ = std::exchange(newest, this); });
}

Leftover::~Leftover() {
    changeList([this] {
        Leftover** link = &newest;
        while (*link != this) link = &(*link)->older_;
        *link = older_;
    });
}

void Leftover::clearAll() {
    take();
    for (const Leftover* left = newest; left; left = left->older_) left->clear();
}

void removeFile(const void* path) { ::unlink(static_cast<const char*>(path)); }

}  // namespace raytracer
