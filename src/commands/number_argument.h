// A number on a command line: which ones an option takes, and what is said of others.
#pragma once

#include <limits>
#include <string>
#include <type_traits>

namespace raytracer::commands {

// A line that cannot be followed. what() says what is wrong; with a hint, parse names --help too.
struct WrongUsage {
    std::string message;
    bool hint = false;
};

// Throws WrongUsage: "--samples: expected a number, found nothing".
[[noreturn]] void refuse(const std::string& name, const std::string& expected, const std::string& found);

// The numbers that an option takes: from `least` to `most`, but not `least` itself where `open`.
struct Range {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    bool open = false;
};
constexpr Range atLeast(double least) { return {.least = least}; }
constexpr Range above(double least) { return {.least = least, .open = true}; }

// " from 0 to 1"; empty for any number.
std::string inWords(const Range& range);

// "a whole number from 1 to 8".
template <class Number>
std::string expectedNumber(const Range& range, bool isFinite = true);

// Throws WrongUsage where the text is no number of the range.
template <class Number>
Number numberIn(const char* name, const std::string& text, const Range& range);

}  // namespace raytracer::commands
