// Text from numbers.
#pragma once

#include <string>

namespace raytracer {

// What printf prints, of any length.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace raytracer
