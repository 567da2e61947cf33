// What stands behind the last event of a text that is no JSON, and what may stand there instead.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "json_scan.h"
#include "number_mistake.h"
#include "syntax_mistake.h"
#include "word_mistake.h"

namespace raytracer {

class SyntaxCursor {
  protected:
    static constexpr std::string_view ends = " \t\r\n,:[]{}\"";
    static constexpr std::size_t longestProposal = 40;  // fits a terminal's line

    explicit SyntaxCursor(const SyntaxState& state) : s_(state), at_(skipped(state.end)) {}

    std::size_t skipped(std::size_t at) const { return raytracer::skipped(s_.text, at); }
    char charAt(std::size_t at) const { return raytracer::charAt(s_.text, at); }
    char found() const { return charAt(at_); }
    bool isAtEnd() const { return at_ == s_.text.size(); }
    std::string_view rest() const { return s_.text.substr(at_); }
    std::string_view wordAt(std::size_t at) const {
        return s_.text.substr(at, s_.text.find_first_of(ends, at) - at);
    }
    char closing() const { return s_.container == '{' ? '}' : ']'; }
    bool isRoot(std::size_t at) const;
    bool isBehindText() const { return s_.last == JsonEvent::Value && s_.text[s_.begin] == '"'; }
    bool isBehindNumber() const { return s_.last == JsonEvent::Value && isDigitAt(s_.text, s_.end - 1); }

    std::string shown() const;  // what was found, for a message
    std::string theOpening(std::size_t opening) const;

    // Of the text or the list that the parser has read last.
    std::size_t valueBegin() const;

    // Whether JSON can go on behind a value that ends here.
    bool isEnd(std::size_t end) const;

    // "WHY: write INSTEAD", of a range of the text; without a remedy where that would be no JSON.
    SyntaxMistake proposal(TextRange range, const WordMistake& word) const;
    SyntaxMistake proposal(std::size_t begin, const char* why, const Meant& meant) const {
        return proposal({begin, begin + meant.size}, {why, meant.json});
    }

    const SyntaxState& s_;
    std::size_t at_;  // the first character that has a meaning, behind the last event
};

}  // namespace raytracer
