// Shows progress on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "raytracer/util/progress.h"

namespace raytracer {

// A line on stderr that is overwritten again and again. It shows nothing in the first second, nor if stderr
// is not a terminal that can overwrite a line.
class TerminalLine {
  public:
    TerminalLine();
    ~TerminalLine();  // clears the line
    TerminalLine(const TerminalLine&) = delete;
    TerminalLine& operator=(const TerminalLine&) = delete;

    bool isDue() const;  // whether enough time has passed since the last text
    void show(const std::string& text);
    double elapsedSeconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

// A bar with the remaining time, for several steps of equal length, each of which reports its own progress.
class StepProgress final : public ProgressListener {
  public:
    StepProgress(bool quiet, std::size_t steps);  // quiet: shows no bar
    void progress(double fraction) override;      // of the current step
    void next();                                  // the current step is done

    // One line, without the carriage return: "[#####     ]  50 %  0:07 left". The bar is as long as fits into
    // this many columns; if no bar fits, it is left out.
    static std::string bar(double fraction, double elapsedSeconds, std::size_t columns);

  private:
    std::optional<TerminalLine> line_;
    double done_ = 0, steps_;
};

}  // namespace raytracer
