#include "raytracer/util/numbers.h"

#include <cstdlib>
#include <string>

namespace raytracer {

std::from_chars_result readNumber(const char* begin, const char* end, double& value) {
    const bool hasPlus = end - begin > 1 && begin[0] == '+' && begin[1] != '-';
    begin += hasPlus;
    std::from_chars_result result = std::from_chars(begin, end, value);
    if (result.ec != std::errc::result_out_of_range) return result;
    value = std::strtod(std::string(begin, result.ptr).c_str(),
                        nullptr);  // from_chars does not say which of the two
    result.ec = {};
    return result;
}

}  // namespace raytracer
