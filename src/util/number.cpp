#include "raytracer/util/number.h"

#include <cstdlib>

namespace raytracer {

const char* readNumber(const char* begin, const char* end, double& number) {
    const auto [stop, error] = std::from_chars(begin, end, number);
    // Too large or too near to 0: std::from_chars does not say which.
    if (error == std::errc::result_out_of_range)
        number = std::strtod(std::string(begin, stop).c_str(), nullptr);
    return stop;
}

}  // namespace raytracer
