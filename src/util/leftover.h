// What a signal that ends the program must not leave behind.
#pragma once

#include <sys/types.h>
#include <csignal>

namespace raytracer {

// Holds back the signals that end the program in this thread. Held from before something is made until its
// Leftover is there.
class SignalsWait {
  public:
    SignalsWait();
    ~SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

    const sigset_t& before() const { return before_; }

  private:
    sigset_t before_;
};

// While it lives, a signal that ends the program calls toClear(what) first; for several the newest first. It
// may only do what POSIX allows in a handler. Signals that are ignored or handled already stay so. One thread
// makes and destroys them.
class Leftover {
  public:
    Leftover(void (*toClear)(const void* what), const void* what);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    void clear() const { clear_(what_); }
    const Leftover* older() const { return older_; }

  private:
    void (*clear_)(const void* what);
    const void* what_;
    Leftover* older_;
};

// Deletes a file, or a folder with all that is in it, as far as it can be done.
void removeFile(const void* path);
void removeFolder(const void* path);

}  // namespace raytracer
