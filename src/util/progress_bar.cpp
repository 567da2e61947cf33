#include "raytracer/util/progress_bar.h"

#include <cmath>
#include <cstdio>

#include <unistd.h>

#include "raytracer/util/text.h"

namespace raytracer {

namespace {
constexpr int barWidth = 40;                           // characters
constexpr std::chrono::milliseconds quietStart{1000};  // shorter work needs no bar
constexpr std::chrono::milliseconds betweenFrames{100};
}  // namespace

TerminalLine::TerminalLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

TerminalLine::~TerminalLine() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

bool TerminalLine::isDue() const {
    const auto now = Clock::now();
    return terminal_ && now - start_ >= quietStart && now - last_ >= betweenFrames;
}

void TerminalLine::show(const std::string& text) {
    if (!isDue()) return;
    last_ = Clock::now();
    drawn_ = true;
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
}

double TerminalLine::elapsedSeconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ProgressBar::progress(double fraction) {
    if (line_.isDue()) line_.show(line(fraction, line_.elapsedSeconds()));
}

std::string ProgressBar::line(double fraction, double elapsedSeconds) {
    const int filled = static_cast<int>(fraction * barWidth);
    const double left = fraction > 0 ? elapsedSeconds * (1 - fraction) / fraction : 0;
    const long seconds = std::lround(left);
    std::string bar(static_cast<std::size_t>(barWidth), ' ');
    bar.replace(0, static_cast<std::size_t>(filled), static_cast<std::size_t>(filled), '#');
    return '[' + bar + formatted("] %3.0f %%  %ld:%02ld left", 100 * fraction, seconds / 60, seconds % 60);
}

}  // namespace raytracer
