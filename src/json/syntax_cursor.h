// Looks at what follows the last event in a text that is not JSON, and makes proposals of other text.
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

    // Where the string, number or list begins that the parser has read last.
    std::size_t valueBegin() const;

    // Whether what follows `end` can follow a value in JSON.
    bool isEnd(std::size_t end) const;

    // "WHY: write INSTEAD", about a range of the text. Only "WHY"
    // if the replacement would not be JSON, or is too long.
    SyntaxMistake proposal(TextRange range, const WordMistake& word) const;
    SyntaxMistake proposal(std::size_t begin, const char* why, const Meant& meant) const {
        return proposal({begin, begin + meant.size}, {why, meant.json});
    }

    const SyntaxState& s_;
    std::size_t at_;  // the first character behind the last event that is not blank
};

}  // namespace raytracer
