#pragma once

#include <csignal>

namespace raytracer {

// Blocks, on this thread, the signals that end the program. Use
// it from before something is made until its Leftover exists.
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

}  // namespace raytracer
