#include "number_mistake.h"

#include <algorithm>
#include <cctype>

#include "json_scan.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

std::size_t digitsAt(std::string_view text, std::size_t at) {
    std::size_t count = 0;
    while (isDigitAt(text, at + count)) ++count;
    return count;
}

// A number at a text's beginning, with groups of three digits and a separator before each group.
struct Grouped {
    std::size_t size = 0, groups = 0;
    std::string number{};
    char separator = '\0';
    bool hasBlank = false, hasZero = false, hasFraction = false;
};

void addGroups(Grouped& found, std::string_view text) {
    while (charAt(text, found.size) == found.separator) {
        const bool isBlank = found.separator == ',' && charAt(text, found.size + 1) == ' ';
        const std::size_t begin = found.size + 1 + isBlank;
        if (digitsAt(text, begin) != 3) return;
        found.hasBlank = found.hasBlank || isBlank;
        found.hasZero = found.hasZero || text[begin] == '0';
        found.number += text.substr(begin, 3);
        found.size = begin + 3;
        ++found.groups;
    }
}

Grouped grouped(std::string_view text) {
    Grouped found;
    found.size = text.starts_with('-');
    const std::size_t first = digitsAt(text, found.size);
    if (first == 0 || first > 3 || text[found.size] == '0') return {};
    found.size += first;
    found.number = text.substr(0, found.size);
    found.separator = charAt(text, found.size);
    if (std::string_view(" ,._'").find(found.separator) == std::string_view::npos) return {};
    addGroups(found, text);
    const char point = charAt(text, found.size);
    const std::size_t digits = digitsAt(text, found.size + 1);
    found.hasFraction = (point == '.' || point == ',') && point != found.separator && digits > 0;
    if (!found.hasFraction) return found;
    found.number += "." + std::string(text.substr(found.size + 1, digits));
    found.size += 1 + digits;
    return found;
}

bool isSure(const Grouped& found, bool isInList) {
    if (found.groups == 0) return false;
    if (found.separator == '_' || found.separator == '\'') return !isInList || !found.hasFraction;
    if (found.separator == '.') return found.hasFraction ? !isInList : found.groups > 1;
    if (isInList || found.separator == ' ') return !isInList;
    return found.hasFraction || (found.hasZero && (found.groups > 1 || found.hasBlank));
}

// Whether this is the name of a function that makes a vector or a list of its arguments: "vec3", "np.array".
bool isVectorName(std::string_view name) {
    const std::string lower = inLowerCase(name.substr(name.rfind('.') + 1));  // npos + 1 is 0
    static constexpr std::string_view begins[] = {"vec",     "array", "point", "float3", "float4",
                                                  "double3", "tuple", "list",  "color",  "rgb"};
    return std::ranges::any_of(begins, [&](std::string_view begin) { return lower.starts_with(begin); });
}

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == ':';
}

std::size_t nameAt(std::string_view text, std::size_t at) {
    std::size_t count = 0;
    while (at + count < text.size() && isNameCharacter(text[at + count])) ++count;
    return std::isalpha(static_cast<unsigned char>(charAt(text, at))) ? count : 0;
}

// The place behind a label, "x:" or "x ="; `at` if there is no label.
std::size_t behindLabel(std::string_view text, std::size_t at) {
    if (!std::isalpha(static_cast<unsigned char>(charAt(text, at)))) return at;
    const std::size_t sign = skipped(text, at + 1);
    return charAt(text, sign) == ':' || charAt(text, sign) == '=' ? skipped(text, sign + 1) : at;
}

// Two numbers or more, with commas between them.
struct Numbers {
    std::size_t end = 0;  // behind the last number
    std::vector<std::string> json{};
    bool hasLabels = false;
};
Numbers numbersAt(std::string_view text, std::size_t at) {
    Numbers found;
    for (bool goesOn = true; goesOn;) {
        const std::size_t begin = behindLabel(text, at);
        const std::string_view word =
            text.substr(begin, text.find_first_of(" \t\r\n,:=()[]{}<>\"", begin) - begin);
        if (!isNumber(word)) return {};
        found.hasLabels = found.hasLabels || begin != at;
        found.json.push_back(asJsonNumber(word));
        found.end = begin + word.size();
        const std::size_t comma = skipped(text, found.end);
        at = skipped(text, comma + 1);
        goesOn = charAt(text, comma) == ',' && charAt(text, at) != '"';
    }
    return found.json.size() < 2 ? Numbers{} : found;
}

}  // namespace

bool isDigitAt(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

bool isNumber(std::string_view word) {
    const std::size_t sign = word.starts_with('-') || word.starts_with('+');
    const bool isFinite = isDigitAt(word, sign) || (charAt(word, sign) == '.' && isDigitAt(word, sign + 1));
    return isFinite && numberOf<double>(word).has_value();
}

std::string asJsonNumber(std::string_view word) {
    std::string sign = word.starts_with('-') ? "-" : "", digits(word.substr(word.find_first_not_of("+-")));
    while (digits[0] == '0' && isDigitAt(digits, 1)) digits.erase(0, 1);
    const std::size_t point = digits.find('.');
    if (point != digits.npos && !isDigitAt(digits, point + 1)) digits.insert(point + 1, "0");
    return sign + (point == 0 ? "0" : "") + digits;
}

const char* aboutNumberForm(std::string_view number) {
    if (number.starts_with('+')) return "a number has no plus in front";
    const std::size_t first = number.starts_with('-');
    const bool hasZero = charAt(number, first) == '0' && isDigitAt(number, first + 1);
    return hasZero ? "a number has no zero in front" : "a point stands between digits";
}

bool isUnit(std::string_view word) {
    static constexpr std::string_view units[] = {"m",   "cm",     "mm",      "km",   "in",      "ft",
                                                 "deg", "degree", "degrees", "rad",  "radians", "px",
                                                 "f",   "meter",  "meters",  "unit", "units",   "\u00b0"};
    return std::ranges::find(units, inLowerCase(word)) != std::end(units);
}

Meant withoutThousands(std::string_view text, bool isInList) {
    const Grouped found = grouped(text);
    if (!isSure(found, isInList) || isDigitAt(text, found.size)) return {};
    return {found.size, found.number};
}

Meant withDecimalPoint(std::string_view text) {
    const std::size_t sign = text.starts_with('-'), comma = sign + digitsAt(text, sign);
    const std::size_t digits = digitsAt(text, comma + 1);
    if (comma == sign || charAt(text, comma) != ',' || digits == 0) return {};
    const std::size_t end = comma + 1 + digits, next = skipped(text, end);
    const std::size_t third = skipped(text, next + 1);  // "x": 3,5,4 is a list
    const bool isNext = isDigitAt(text, third) || charAt(text, third) == '-' || charAt(text, third) == '.';
    if (charAt(text, next) == ',' && isNext) return {};
    return {end, std::string(text.substr(0, comma)) + "." + std::string(text.substr(comma + 1, digits))};
}

bool mayBeThousand(std::string_view number) {
    const std::size_t point = number.find('.');
    return number.size() - point == 4 && number.substr(0, point).find_first_not_of("-0") != number.npos;
}

Meant bareList(std::string_view text) {
    const Numbers found = numbersAt(text, 0);
    return found.hasLabels ? Meant{} : Meant{found.end, listOf(found.json)};
}

std::vector<std::string> numbersIn(std::string_view text) {
    constexpr std::string_view between = " \t\r\n,";
    std::vector<std::string> numbers;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(between), text.size()));
        if (text.empty()) return numbers;
        const std::string_view word = text.substr(0, text.find_first_of(between));
        if (!isNumber(word)) return {};
        numbers.push_back(asJsonNumber(word));
        text.remove_prefix(word.size());
    }
}

std::string listOf(const std::vector<std::string>& numbers) {
    std::string list;
    for (const std::string& number : numbers) list += (list.empty() ? "[" : ", ") + number;
    return list.empty() ? "" : list + "]";
}

Meant vectorElsewhere(std::string_view text) {
    std::size_t at = text.starts_with("new ") ? 4 : 0;
    const std::size_t name = nameAt(text, at);
    const bool isCall = charAt(text, at + name) == '(';
    if (isCall && name > 0 && !isVectorName(text.substr(at, name))) return {};
    std::string closing;
    if (isCall) at += name;
    for (; at < text.size() && isOneOf(text[at], "([<"); at = skipped(text, at + 1))
        closing.insert(0, 1, text[at] == '(' ? ')' : text[at] == '[' ? ']' : '>');
    const Numbers found = numbersAt(text, at);
    if (found.json.empty() || (closing.empty() && !found.hasLabels)) return {};
    std::size_t end = found.end;
    for (const char bracket : closing) {
        end = skipped(text, end);
        if (charAt(text, end) != bracket) return {};
        ++end;
    }
    return {end, listOf(found.json)};
}

}  // namespace raytracer
