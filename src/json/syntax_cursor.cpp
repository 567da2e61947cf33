#include "syntax_cursor.h"

#include "raytracer/json/json_edit.h"
#include "raytracer/util/text.h"

namespace raytracer {

bool SyntaxCursor::isRoot(std::size_t at) const {
    return at == skipped(s_.text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0);
}

std::string SyntaxCursor::shown() const {
    if (isAtEnd()) return "the end of the file";
    const std::string_view word = wordAt(at_);
    return inQuotes(word.empty() ? rest().substr(0, 1) : word);
}

std::string SyntaxCursor::theOpening(std::size_t opening) const {
    std::string kind = s_.text[opening] == '{' ? "the object" : "the list";
    if (s_.text.find('\n') == std::string_view::npos) return kind;
    return kind + " of line " + std::to_string(1 + std::ranges::count(s_.text.substr(0, opening), '\n'));
}

std::size_t SyntaxCursor::valueBegin() const {
    if (s_.last == JsonEvent::Value) return s_.begin;
    std::size_t begin = s_.opening;
    int depth = 0;
    outsideTexts(s_.text.substr(0, s_.end), s_.opening + 1, [&](std::size_t at) {
        if (depth == 0 && s_.text[at] == '[') begin = at;
        depth += isOneOf(s_.text[at], "[{") - isOneOf(s_.text[at], "]}");
        return true;
    });
    return begin;
}

bool SyntaxCursor::isEnd(std::size_t end) const {
    const std::size_t next = std::min(s_.text.find_first_not_of(" \t", end), s_.text.size());
    if (next == s_.text.size() || isOneOf(s_.text[next], "]}\r\n")) return true;
    const bool isKeyNext = s_.container != '{' || !isOneOf(charAt(skipped(next + 1)), "0123456789+-.");
    return s_.text[next] == ',' && s_.container && isKeyNext;
}

SyntaxMistake SyntaxCursor::proposal(TextRange range, const WordMistake& word) const {
    const bool isGood = !word.instead.empty() && word.instead.size() <= longestProposal && isEnd(range.end) &&
                        readingOf(word.instead).why.empty();
    if (!isGood) return {range.begin, word.why};
    return {range.begin, word.why + ": write " + word.instead + word.more, range, word.instead};
}

}  // namespace raytracer
