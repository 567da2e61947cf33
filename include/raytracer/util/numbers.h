// Numbers in texts: decimal, the same in every locale.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace raytracer {

// std::from_chars for numbers as people write them: a plus may stand before one, and what no double can hold
// becomes the nearest that can, infinity or 0.
std::from_chars_result readNumber(const char* begin, const char* end, double& value);

template <class Integer>
std::from_chars_result readNumber(const char* begin, const char* end, Integer& value) {
    const bool hasPlus = end - begin > 1 && begin[0] == '+' && begin[1] != '-';
    return std::from_chars(begin + hasPlus, end, value);
}

// The finite number that the text is, all of it; nothing where it is anything else.
template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    Number value{};
    const auto [end, error] = readNumber(text.data(), text.data() + text.size(), value);
    const bool isNumber = error == std::errc() && end == text.data() + text.size();
    if (!isNumber || !std::isfinite(static_cast<double>(value))) return std::nullopt;
    return value;
}

}  // namespace raytracer
