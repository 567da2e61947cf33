#include "command_line.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "raytracer/json/json_writer.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// Refuses a number that is beyond its type, where nothing else limits it.
template <class Number>
void refuseBeyondType(const char* name, const std::string& text, const Range& range) {
    const bool isNegative = text[0] == '-';
    const bool isLimited = isNegative ? range.least > Range().least : range.most < Range().most;
    if (!std::is_integral_v<Number> || isLimited || !isWholeNumber(text)) return;
    using Limits = std::numeric_limits<Number>;
    const std::string limit = isNegative ? "at least " + std::to_string(Limits::lowest())
                                         : "at most " + std::to_string(Limits::max());
    refuse(name, limit, inQuotes(text));
}

// "; write 10" for "10s", and so for "2%", "600px" and "0,02"; empty where no number of the range is meant.
template <class Number>
std::string meantNumber(const std::string& text, const Range& range) {
    const std::size_t end = text.find_last_of("0123456789.") + 1;
    const std::string unit = text.substr(end);
    std::string digits = text.substr(0, end);
    if (const std::size_t comma = digits.find(','); comma != digits.npos) digits[comma] = '.';
    const bool isKnown = unit.empty() || unit == "s" || unit == "px" || unit == "%";
    const std::optional<double> meant = isKnown ? numberOf<double>(digits) : std::nullopt;
    const std::string write = meant && unit == "%" ? shortestNumber(*meant / 100) : digits;
    const std::optional<Number> number = meant ? numberOf<Number>(write) : std::nullopt;
    return number && range.has(static_cast<double>(*number)) ? "; write " + write : "";
}

}  // namespace

[[noreturn]] void refuse(const std::string& name, const std::string& expected, const std::string& found) {
    throw WrongUsage{name + ": expected " + expected + ", found " + found};
}

std::string inWords(const Range& range) {
    if (range.most < Range().most)
        return " from " + formatted("%.6g", range.least) + " to " + formatted("%.6g", range.most);
    if (range.least == Range().least) return "";
    return (range.open ? " above " : " not below ") + formatted("%.6g", range.least);
}

template <class Number>
std::string expectedNumber(const Range& range, bool isFinite) {
    const char* const kind = std::is_integral_v<Number> ? "a whole number"
                             : isFinite                 ? "a number"
                                                        : "a finite number";
    return kind + inWords(range);
}

template <class Number>
Number numberIn(const char* name, const std::string& text, const Range& range) {
    const std::optional<Number> number = numberOf<Number>(text);
    if (!number) refuseBeyondType<Number>(name, text, range);
    const double value = number ? static_cast<double>(*number) : range.least - 1;
    if (!number || !range.has(value))
        refuse(name, expectedNumber<Number>(range, std::isfinite(value) || range.most < Range().most),
               inQuotes(text) + meantNumber<Number>(text, range));
    return *number;
}

template std::string expectedNumber<int>(const Range&, bool);
template std::string expectedNumber<double>(const Range&, bool);
template std::string expectedNumber<std::uint64_t>(const Range&, bool);
template int numberIn(const char*, const std::string&, const Range&);
template double numberIn(const char*, const std::string&, const Range&);
template std::uint64_t numberIn(const char*, const std::string&, const Range&);

}  // namespace raytracer::commands
