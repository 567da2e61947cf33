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

// Refuses an integer that does not fit its type, if the range has no limit of its own on that side.
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

// "; write 10" for "10s", and the like for "2%", "600px" and "0,02". Empty if no number of the range is
// meant: a count is no percentage.
template <class Number>
std::string meantNumber(const std::string& text, const Range& range) {
    const std::size_t end = text.find_last_of("0123456789.") + 1;
    const std::string unit = text.substr(end);
    std::string digits = text.substr(0, end);
    if (const std::size_t comma = digits.find(','); comma != digits.npos) digits[comma] = '.';
    const bool isKnown =
        unit.empty() || unit == "s" || unit == "px" || (unit == "%" && !std::is_integral_v<Number>);
    const std::optional<double> meant = isKnown ? numberOf<double>(digits) : std::nullopt;
    const std::string write = meant && unit == "%" ? shortestNumber(*meant / 100) : digits;
    const std::optional<Number> number = meant ? numberOf<Number>(write) : std::nullopt;
    return number && range.has(static_cast<double>(*number)) ? "; write " + write : "";
}

// " from 0 to 1"; empty for any number.
std::string inWords(const Range& range) {
    if (range.most < Range().most)
        return " from " + formatted("%.6g", range.least) + " to " + formatted("%.6g", range.most);
    if (range.least == Range().least) return "";
    return (range.open ? " above " : " not below ") + formatted("%.6g", range.least);
}

// "a whole number from 1 to 8".
template <class Number>
std::string expectedNumber(const Range& range, bool isFinite = true) {
    const char* const kind = std::is_integral_v<Number> ? "a whole number"
                             : isFinite                 ? "a number"
                                                        : "a finite number";
    return kind + inWords(range);
}

// Reads a number. Throws UsageError if the text is not a number in the range.
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

// The number's type for a variable that is one, or a std::optional of one; and the default in the help.
template <class Number>
struct Variable {
    using Type = Number;
    static std::string usual(Number number) { return formatted("%.6g", static_cast<double>(number)); }
};
template <class Number>
struct Variable<std::optional<Number>> {
    using Type = Number;
    static std::string usual(const std::optional<Number>&) { return {}; }
};

}  // namespace

void refuse(const std::string& name, const std::string& expected, const std::string& found) {
    throw UsageError(name + ": expected " + expected + ", found " + found);
}

template <class Value>
void CommandLine::number(const char* name, Value& value, const Range& range, const std::string& help) {
    using Number = typename Variable<Value>::Type;
    const std::string words = inWords(range);
    words_.push_back(
        {.name = name,
         .help = help + (words.empty() ? "" : " (" + words.substr(1) + ")"),
         .read = [=, &value](const std::string& text) { value = numberIn<Number>(name, text, range); },
         .placeholder = std::is_integral_v<Number> ? "N" : "NUMBER",
         .usual = Variable<Value>::usual(value),
         .expected = expectedNumber<Number>(range),
         .kind = ArgumentKind::Number});
}

template void CommandLine::number(const char*, int&, const Range&, const std::string&);
template void CommandLine::number(const char*, double&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<int>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<double>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<std::uint64_t>&, const Range&,
                                  const std::string&);

}  // namespace raytracer::commands
