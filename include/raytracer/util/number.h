// Reads numbers from text, for all rooms but json, where nlohmann's parser does it.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

namespace raytracer {

// Reads the number that the text begins with and returns where it ends, or `begin` where there is none. A
// double is correctly rounded; one that is too large is an infinity. An integer that does not fit is 0.
template <std::integral Number>
const char* readNumber(const char* begin, const char* end, Number& number) {
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error == std::errc::result_out_of_range) number = 0;
    return stop;
}
const char* readNumber(const char* begin, const char* end, double& number);

// Whether the whole text is a whole number, which may be too large for any type.
bool isWholeNumber(std::string_view text);

// The number that the whole text is; a plus may stand before it. Nothing for a whole number that does not
// fit.
template <class Number>
std::optional<Number> numberOf(std::string_view text) {
    Number number{};
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const char* const end = text.data() + text.size();
    if constexpr (std::integral<Number>) {
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc() || stop != end) return std::nullopt;
    } else {
        if (text.empty() || readNumber(text.data(), end, number) != end) return std::nullopt;
    }
    return number;
}

}  // namespace raytracer
