// Where brackets and texts stand in a text that may be no JSON.
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

// The first place from `at` that has no blank.
inline std::size_t skipped(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(blanks, at), text.size());
}

// Calls visit(place) for each character outside of texts, which end in their lines, until that is false.
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

// How many more of these brackets the text closes than it opens.
std::ptrdiff_t excess(std::string_view text, char closing);

// Where the bracket that opens here, of any kind, is closed; the text's size where it is not.
std::size_t closingOf(std::string_view text, std::size_t opening);

// By its indentation, a line no longer belongs to the object in which it stands.
struct Outdented {
    std::size_t place, opening;  // of the line's first character, and of the object
};
std::optional<Outdented> outdented(std::string_view text);

}  // namespace raytracer
