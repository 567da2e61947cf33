// Finds brackets and strings in a text that may not be JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace raytracer {

constexpr std::string_view blanks = " \t\r\n";

inline bool isOneOf(char c, std::string_view set) { return set.find(c) != set.npos; }

// The character there, or a zero at the end.
inline char charAt(std::string_view text, std::size_t at) { return at < text.size() ? text[at] : '\0'; }

// The first place from `at` on that is not blank.
inline std::size_t skipped(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(blanks, at), text.size());
}

// Calls visit(place) for each character outside of strings, until it returns false. A string ends with its
// line at the latest.
template <class Visit>
void outsideTexts(std::string_view text, std::size_t from, Visit visit) {
    bool isInText = false;
    for (std::size_t at = from; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"' || c == '\n') isInText = c == '"' && !isInText;
        else if (isInText) at += c == '\\';
        if (!isInText && !visit(at)) return;
    }
}

// How many more brackets of this kind the text closes than it opens.
std::ptrdiff_t excess(std::string_view text, char closing);

// Where the bracket at `opening`, of any kind, is closed; the text's size if it is not.
std::size_t closingOf(std::string_view text, std::size_t opening);

// A line whose indentation says that it no longer belongs to the object in which it stands.
struct Outdented {
    std::size_t place, opening;  // the line's first character, and the object's bracket
};
std::optional<Outdented> outdented(std::string_view text);

}  // namespace raytracer
