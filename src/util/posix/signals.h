#pragma once

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

}  // namespace raytracer
