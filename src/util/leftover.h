// Clears up what must not be left behind when a signal ends the program.
#pragma once

#include <functional>

namespace raytracer {

// While this object lives, a signal that ends the program first calls toClear(what); of several objects, the
// newest first. toClear may only do what POSIX allows in a signal handler. Signals that are ignored or
// handled already stay so. Any thread may make and destroy such objects.
class Leftover {
  public:
    Leftover(void (*toClear)(const void* what), const void* what);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    void clear() const { clear_(what_); }
    static void clearAll();  // when the program ends: from then on no thread can make or destroy one

  private:
    void (*clear_)(const void* what);
    const void* what_;
    Leftover* older_ = nullptr;
};

// Deletes a file, or a folder with all that is in it except mounts, as far as possible. Each platform has its
// own removeFolder.
void removeFile(const void* path);
void removeFolder(const void* path);

// Makes signals that end the program call Leftover::clearAll first. Each platform has its own version.
void handleEndingSignals();
// Calls work() while no such signal can interrupt this thread. Each platform has its own version.
void withoutEndingSignals(const std::function<void()>& work);

}  // namespace raytracer
