#include "quote_mistake.h"

#include <algorithm>
#include <cctype>

#include "json_scan.h"

namespace raytracer {
namespace {

// Why the escape sequence at `at` is not valid; empty if it is.
std::string wrongEscape(const SyntaxState& state, std::size_t at) {
    const std::string_view text = state.text;
    const char escaped = at + 1 < text.size() ? text[at + 1] : '"';
    if (isOneOf(escaped, "\"\\/bfnrt")) return "";
    if (escaped != 'u') return "a backslash in a text is written twice; in a path, write /";
    const std::string_view digits = text.substr(at + 2, 4);
    const bool isHex = digits.size() == 4 &&
                       std::ranges::all_of(digits, [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (!isHex) return "expected four hexadecimal digits behind \\u";
    const bool isBlamed = state.stopped >= at && state.stopped < at + 12;  // 12: a surrogate pair
    const bool isSurrogate = (digits[0] == 'd' || digits[0] == 'D') && digits[1] >= '8';
    return isSurrogate && isBlamed ? "half a character: \\ud800 to \\udfff stand in pairs" : "";
}

bool isWordBehindText(const SyntaxState& state) {
    const std::string_view text = state.text;
    const bool isText = text[state.begin] == '"' && state.end < text.size();
    return isText && !isOneOf(text[state.end], " \t\r\n,:[]{}\"");
}

}  // namespace

std::string aboutOtherQuotes(std::string_view text) {
    if (text.starts_with('\'')) return "text stands in double quotes, not in single ones";
    const bool isCurly =
        text.starts_with("\u201c") || text.starts_with("\u201d") || text.starts_with("\u201e");
    return isCurly ? "text stands in plain double quotes (\"), not in curved ones" : "";
}

SyntaxMistake stringMistake(const SyntaxState& state, std::size_t begin) {
    const std::string_view text = state.text;
    std::size_t at = begin + 1;
    for (; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\n' || text[at] == '\r')
            return {begin, "a text has no end: \" is missing in this line"};
        if (text[at] == '\t') return {at, "a tab in a text: write \\t, or a blank"};
        if (static_cast<unsigned char>(text[at]) < ' ') return {at, "a control character in a text"};
        if (text[at] != '\\') continue;
        if (const auto wrong = wrongEscape(state, at); !wrong.empty()) return {at, wrong};
        ++at;
    }
    if (at >= text.size()) return {begin, "a text has no end: \" is missing"};
    return {state.stopped, "a byte that is no UTF-8: save the file as UTF-8"};
}

bool isSwallowing(const SyntaxState& state) {
    if (!isWordBehindText(state)) return false;
    const std::size_t last = state.text.find_last_not_of(" \t\r\n", state.end - 2);
    return last > state.begin && isOneOf(state.text[last], ",:[{");
}

bool isQuoteInText(const SyntaxState& state) {
    if (!isWordBehindText(state)) return false;
    const std::size_t next = state.text.find_first_of("\"\n,:[]{}", state.end);
    return next != state.text.npos && state.text[next] == '"';
}

}  // namespace raytracer
