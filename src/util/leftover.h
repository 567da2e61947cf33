// What a signal that ends the program must not leave behind.
#pragma once

#include <functional>

namespace raytracer {

// While it lives, a signal that ends the program calls toClear(what) first; for several the newest first. It
// may only do what POSIX allows in a handler. Signals that are ignored or handled already stay so. From any
// thread.
class Leftover {
  public:
    Leftover(void (*toClear)(const void* what), const void* what);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    void clear() const { clear_(what_); }
    static void clearAll();  // by what ends the program: no thread makes or destroys one any more

  private:
    void (*clear_)(const void* what);
    const void* what_;
    Leftover* older_ = nullptr;
};

// Deletes a file, or (of the platform) a folder with all that is in it but mounts, as far as it can be done.
void removeFile(const void* path);
void removeFolder(const void* path);

// Of the platform: signals that end the program call Leftover::clearAll first.
void handleEndingSignals();
// Of the platform: calls work() where no such signal can interrupt this thread.
void withoutEndingSignals(const std::function<void()>& work);

}  // namespace raytracer
