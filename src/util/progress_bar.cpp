#include "raytracer/util/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {
constexpr std::size_t widestBar = 40;                  // characters
constexpr std::chrono::milliseconds quietStart{1000};  // shorter work shows no bar
constexpr std::chrono::milliseconds betweenFrames{100};
}  // namespace

TerminalLine::TerminalLine() : terminal_(canOverwrite()) {}

TerminalLine::~TerminalLine() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

bool TerminalLine::isDue() const {
    const auto now = Clock::now();
    return terminal_ && now - start_ >= quietStart && now - last_ >= betweenFrames;
}

// The last column stays empty: a character there would make some terminals begin a new line.
void TerminalLine::show(const std::string& text) {
    if (!isDue()) return;
    last_ = Clock::now();
    drawn_ = true;
    const std::size_t columns = terminalColumns();
    std::fprintf(stderr, "\r\033[K%s", text.substr(0, columns > 0 ? columns - 1 : 0).c_str());
    std::fflush(stderr);
}

double TerminalLine::elapsedSeconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string StepProgress::bar(double fraction, double elapsedSeconds, std::size_t columns) {
    const double left = fraction > 0 ? elapsedSeconds * (1 - fraction) / fraction : 0;
    const long seconds = std::lround(left);
    std::string numbers = formatted("%3.0f %%  %ld:%02ld left", 100 * fraction, seconds / 60, seconds % 60);
    constexpr std::size_t others = 4;  // "[", "] " and the last column, which stays empty
    if (columns < numbers.size() + others + 1) return numbers;
    const std::size_t width = std::min(widestBar, columns - numbers.size() - others);
    const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
    return '[' + std::string(filled, '#') + std::string(width - filled, ' ') + "] " + numbers;
}

StepProgress::StepProgress(bool quiet, std::size_t steps) : steps_(static_cast<double>(steps)) {
    if (!quiet) line_.emplace();
}

void StepProgress::progress(double fraction) {
    if (line_ && line_->isDue())
        line_->show(bar((done_ + fraction) / steps_, line_->elapsedSeconds(), terminalColumns()));
}

void StepProgress::next() {
    progress(1);
    ++done_;
}

}  // namespace raytracer
