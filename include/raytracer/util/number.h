// Reads numbers from text. Only JSON's are read elsewhere, by nlohmann's parser.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string_view>

namespace raytracer {

// Reads the number at the text's beginning, and returns where it ends, or `begin` if there is none. A double
// is correctly rounded; one that is too large becomes an infinity. An integer that does not fit becomes 0.
template <std::integral Number>
const char* readNumber(const char* begin, const char* end, Number& number) {
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error == std::errc::result_out_of_range) number = 0;
    return stop;
}
const char* readNumber(const char* begin, const char* end, double& number);

// Whether the whole text is an integer; it may be too large for any type.
bool isWholeNumber(std::string_view text);

// The number that the whole text is. A plus may stand before it. Empty if the text is anything else, or an
// integer that does not fit.
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
