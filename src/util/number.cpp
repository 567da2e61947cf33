#include "raytracer/util/number.h"

#include <cstdlib>
#include <version>

#include "raytracer/util/text.h"

namespace raytracer {

bool isWholeNumber(std::string_view text) {
    const bool hasSign = text.starts_with('-') || text.starts_with('+');
    const std::string_view digits = text.substr(hasSign);
    return !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
}

#if defined(__cpp_lib_to_chars)

const char* readNumber(const char* begin, const char* end, double& number) {
    const auto [stop, error] = std::from_chars(begin, end, number);
    // Too large or too near to 0: std::from_chars does not say which.
    if (error == std::errc::result_out_of_range)
        number = std::strtod(std::string(begin, stop).c_str(), nullptr);
    return stop;
}

#else

namespace {

const char* endOfDigits(const char* at, const char* end) {
    while (at != end && *at >= '0' && *at <= '9') ++at;
    return at;
}

const char* behindSign(const char* at, const char* end, std::string_view signs) {
    return at != end && signs.find(*at) != signs.npos ? at + 1 : at;
}

// Where the number that std::from_chars would read ends.
const char* endOfNumber(const char* begin, const char* end) {
    const char* const whole = behindSign(begin, end, "-");
    const std::string_view text(whole, static_cast<std::size_t>(end - whole));
    for (const std::string_view word : {"infinity", "inf", "nan"})
        if (text.size() >= word.size() && endsIn(text.substr(0, word.size()), word))
            return whole + word.size();
    const char* const point = endOfDigits(whole, end);
    const char* const fraction = behindSign(point, end, ".");
    const char* const stop = endOfDigits(fraction, end);
    const bool hasDigits = point > whole || stop > fraction;
    if (!hasDigits) return begin;
    const char* const exponent = behindSign(stop, end, "eE");
    const char* const digits = exponent > stop ? behindSign(exponent, end, "+-") : stop;
    const char* const exponentEnd = endOfDigits(digits, end);
    return exponentEnd > digits ? exponentEnd : stop;
}

}  // namespace

// For libc++, which has std::from_chars for double since version 20 only. strtod rounds correctly too, and
// where setlocale is never called its point is a point.
const char* readNumber(const char* begin, const char* end, double& number) {
    const char* const stop = endOfNumber(begin, end);
    if (stop != begin) number = std::strtod(std::string(begin, stop).c_str(), nullptr);
    return stop;
}

#endif

}  // namespace raytracer
