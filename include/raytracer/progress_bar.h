// A progress bar with the remaining time, on stderr.
#pragma once

#include <chrono>
#include <string>

#include "raytracer/render_options.h"

namespace raytracer {

// Draws nothing in the first second, and nothing at all where stderr is not a terminal.
class ProgressBar final : public ProgressListener {
  public:
    ProgressBar();
    ~ProgressBar() override;  // clears the line
    void progress(double fraction) override;

    // One line, without the carriage return: "[#####     ]  50 %  0:07 left".
    static std::string line(double fraction, double elapsedSeconds);

  private:
    using Clock = std::chrono::steady_clock;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace raytracer
