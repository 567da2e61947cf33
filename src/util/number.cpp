#include "raytracer/util/number.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <version>

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

// For libc++, which has std::from_chars for double only since version 20. strtod rounds correctly too. Its
// decimal point is "." since this program never calls setlocale. strtod would also take leading blanks, a
// plus and hexadecimal digits, so these are kept from it.
const char* readNumber(const char* begin, const char* end, double& number) {
    const auto isPart = [](char c) {
        return std::string_view("0123456789.+-einfatyEINFATY").find(c) != std::string_view::npos;
    };
    const std::string text(begin, std::find_if_not(begin, end, isPart));
    char* stop = nullptr;
    const double read = std::strtod(text.c_str(), &stop);
    if (text.starts_with('+') || stop == text.c_str()) return begin;
    number = read;
    return begin + (stop - text.c_str());
}

#endif

}  // namespace raytracer
