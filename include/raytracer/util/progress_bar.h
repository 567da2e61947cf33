// Progress on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "raytracer/util/progress.h"

namespace raytracer {

// A line on stderr that is overwritten. It shows nothing in the first second, or where stderr is not a
// terminal that can overwrite it.
class TerminalLine {
  public:
    TerminalLine();
    ~TerminalLine();  // clears the line
    TerminalLine(const TerminalLine&) = delete;
    TerminalLine& operator=(const TerminalLine&) = delete;

    bool isDue() const;  // long enough after the last text
    void show(const std::string& text);
    double elapsedSeconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

// A bar with the remaining time, for equal steps, one after the other, whose own progress is told in between.
class StepProgress final : public ProgressListener {
  public:
    StepProgress(bool quiet, std::size_t steps);  // quiet: without a bar
    void progress(double fraction) override;      // of the present step
    void next();                                  // the step is done

    // One line, without the carriage return: "[#####     ]  50 %  0:07 left". The bar is as long as fits in
    // these columns, and left out where none does.
    static std::string bar(double fraction, double elapsedSeconds, std::size_t columns);

  private:
    std::optional<TerminalLine> line_;
    double done_ = 0, steps_;
};

}  // namespace raytracer
