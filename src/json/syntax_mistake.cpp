#include "syntax_mistake.h"

#include <algorithm>
#include <cctype>

#include "raytracer/util/number.h"
#include "raytracer/util/text.h"
#include "word_mistake.h"

namespace raytracer {
namespace {

constexpr std::string_view blanks = " \t\r\n", ends = " \t\r\n,:[]{}\"";

// Finds out what stands behind the last event, and what should.
class Finder {
  public:
    explicit Finder(const SyntaxState& state) : s_(state), at_(skipped(state.end)) {}

    SyntaxMistake find() {
        if (s_.last == JsonEvent::Key) return behindKey();
        const bool isBehindValue = s_.last == JsonEvent::Value || s_.last == JsonEvent::Close;
        if (isBehindValue && !s_.container) return isForeign() ? foreign() : behindAll();
        if (isBehindValue) return behindValue();
        return s_.container == '{' ? atKey() : atValue();
    }

  private:
    std::size_t skipped(std::size_t at) const {
        return std::min(s_.text.find_first_not_of(blanks, at), s_.text.size());
    }
    char found() const { return at_ < s_.text.size() ? s_.text[at_] : '\0'; }
    bool isAtEnd() const { return at_ == s_.text.size(); }
    std::string_view wordAt(std::size_t at) const {
        return s_.text.substr(at, s_.text.find_first_of(ends, at) - at);
    }
    char closing() const { return s_.container == '{' ? '}' : ']'; }
    std::size_t lineOf(std::size_t at) const {
        return 1 + static_cast<std::size_t>(std::ranges::count(s_.text.substr(0, at), '\n'));
    }

    bool isForeign() const { return !aboutForeign(s_.text.substr(at_)).empty(); }
    SyntaxMistake foreign() const { return {at_, aboutForeign(s_.text.substr(at_))}; }

    // What was found, for a message.
    std::string shown() const {
        if (isAtEnd()) return "the end of the file";
        const std::string_view word = wordAt(at_);
        return inQuotes(word.empty() ? s_.text.substr(at_, 1) : word);
    }

    std::string theOpening() const {
        const std::string kind = s_.container == '{' ? "the object" : "the list";
        const bool isOneLine = s_.text.find('\n') == std::string_view::npos;
        return isOneLine ? kind : kind + " of line " + std::to_string(lineOf(s_.opening));
    }
    SyntaxMistake unclosed() const {
        const std::string bracket{'"', closing(), '"'};
        return {at_, bracket + " is missing at the end of " + theOpening()};
    }

    SyntaxMistake behindKey() {
        const std::string_view key = s_.text.substr(s_.begin, s_.end - s_.begin);
        if (isForeign()) return foreign();
        if (isSwallowing()) return {s_.begin, "a text has no end: \" is missing"};
        if (found() != ':')
            return {s_.end, "a colon is missing behind the key " + inQuotes(key.substr(1, key.size() - 2))};
        at_ = skipped(at_ + 1);
        return atValue();
    }
    // A text without its end takes in what follows, to the next text's beginning: "red, "color": 1
    bool isSwallowing() const {
        if (s_.text[s_.begin] != '"' || at_ != s_.end || wordAt(at_).empty()) return false;
        const std::size_t last = s_.text.find_last_not_of(blanks, s_.end - 2);
        return last > s_.begin && std::string_view(",:[{").find(s_.text[last]) != std::string_view::npos;
    }

    SyntaxMistake behindAll() const {
        if (found() == '}' || found() == ']') return {at_, "a bracket too many"};
        if (s_.last == JsonEvent::Close && excess(s_.text[s_.end - 1]) > 0)
            return {s_.end - 1, "a bracket too many"};
        if (found() == ',' && s_.last == JsonEvent::Value) return {s_.begin, "a list stands in [ and ]"};
        if (found() == ',') return {at_, "a comma too many: the scene ends before it"};
        if (found() == ':') return {s_.begin, "\"{\" is missing before this key"};
        return {at_, "expected the end of the file, found " + shown()};
    }

    bool isParenthesis() const { return found() == ')' && s_.container; }
    SyntaxMistake parenthesis() const {
        if (excess(closing()) >= 0) return {at_, "a bracket too many"};
        return {at_, std::string("expected \"") + closing() + "\", found \")\""};
    }

    SyntaxMistake behindValue() {
        if (isForeign()) return foreign();
        if (isAtEnd()) return unclosed();
        if (isParenthesis()) return parenthesis();
        if (found() == ';') return {at_, "expected a comma, found \";\""};
        if (found() == ',') {
            if (isDecimalComma()) return decimalComma();
            comma_ = at_;
            at_ = skipped(at_ + 1);
            return s_.container == '{' ? atKey() : atValue();
        }
        const bool goesOn = at_ == s_.end && !wordAt(at_).empty();
        if (isBehindNumber() && (goesOn || isOperator() || isUnitInLine())) return longerNumber();
        if (isSwallowing()) return {s_.begin, "a text has no end: \" is missing"};
        if (isOperatorInLine()) return calculation(valueBegin());
        if (goesOn && s_.last == JsonEvent::Value &&
            std::isalpha(static_cast<unsigned char>(s_.text[s_.begin])))  // truee
            return {s_.begin, aboutWord(wordAt(s_.begin))};
        if (found() == '}' || found() == ']') return wrongClosing();
        if (found() == ':' && s_.container == '[') return keyInList();
        if (found() == ':') return {at_, "expected a comma, found \":\""};
        return {s_.end, "a comma is missing here"};
    }
    // How many more of these brackets the text closes than it opens, outside of its texts.
    std::ptrdiff_t excess(char closing) const {
        const char opening = closing == '}' ? '{' : '[';
        std::ptrdiff_t count = 0;
        bool isInText = false;
        for (std::size_t at = 0; at < s_.text.size(); ++at) {
            const char c = s_.text[at];
            if (c == '"' || c == '\n') isInText = c == '"' && !isInText;
            else if (isInText) at += c == '\\';
            else count += (c == closing) - (c == opening);
        }
        return count;
    }
    bool isTooMany(char bracket) const { return excess(bracket) > 0 && excess(closing()) >= 0; }
    SyntaxMistake wrongClosing() const {
        return isTooMany(found()) ? SyntaxMistake{at_, "a bracket too many"} : unclosed();
    }
    SyntaxMistake keyInList() const {
        if (s_.text.find_first_not_of(blanks, s_.opening + 1) == s_.begin)
            return {s_.opening, "keys stand in { and }, not in [ and ]"};
        const std::size_t closed = s_.text.rfind('}', s_.begin);
        if (closed != std::string_view::npos && isTooMany('}')) return {closed, "a bracket too many"};
        return {s_.begin, unclosed().message};
    }

    bool isBehindNumber() const { return s_.last == JsonEvent::Value && isDigitAt(s_.text, s_.end - 1); }
    // "[1 -2]" lacks a comma; "[1 - 2]" and "[1-2]" calculate.
    bool isOperator() const {
        const bool isSign = found() == '+' || found() == '-';
        return std::string_view("+-*/^%").find(found()) != std::string_view::npos &&
               (!isSign || at_ == s_.end || !isDigitAt(s_.text, at_ + 1));
    }

    bool isInLine() const {
        return s_.text.substr(s_.end, at_ - s_.end).find('\n') == std::string_view::npos;
    }
    bool isUnitInLine() const { return isInLine() && isUnit(wordAt(at_)); }
    bool isOperatorInLine() const { return isInLine() && s_.text[s_.end - 1] != '}' && isOperator(); }
    // Of the text or the list that the parser has read last.
    std::size_t valueBegin() const {
        if (s_.last == JsonEvent::Value) return s_.begin;
        std::size_t at = s_.end;
        int depth = 0;
        do {
            --at;
            depth += (s_.text[at] == ']') - (s_.text[at] == '[');
        } while (depth > 0 && at > s_.opening);
        return at;
    }

    // A number goes on where it should end: 360/4, 007, 90deg, 1 m.
    SyntaxMistake longerNumber() const {
        if (isOperator()) return calculation(s_.begin);
        if (isUnit(wordAt(at_)))
            return {s_.begin, "a number has no unit: write " +
                                  std::string(s_.text.substr(s_.begin, s_.end - s_.begin))};
        const std::size_t end = at_ + wordAt(at_).size();
        const std::string all(s_.text.substr(s_.begin, end - s_.begin));
        if (numberOf<double>(all))
            return {s_.begin, "a number has no zero in front: write " + withoutZeros(all)};
        return {s_.begin, "expected a number, found " + inQuotes(all)};
    }
    SyntaxMistake calculation(std::size_t begin) const {
        return {begin, aboutCalculation(s_.text.substr(begin))};
    }

    // Where a key should follow: "x": 0,5
    bool isDecimalComma() const {
        if (s_.container != '{' || !isBehindNumber() || at_ != s_.end || !isDigitAt(s_.text, at_ + 1))
            return false;
        const std::size_t next = at_ + 1 + wordAt(at_ + 1).size();  // "x": 3,5,4 is a list
        return s_.text.substr(next, 1) != "," || !numberOf<double>(wordAt(next + 1));
    }
    SyntaxMistake decimalComma() const {
        const std::string whole(s_.text.substr(s_.begin, s_.end - s_.begin)), fraction(wordAt(at_ + 1));
        return {at_, aboutComma(whole, fraction)};
    }

    // Where only the end of the container or another comma follows one.
    bool isCommaTooMany() const {
        return comma_ != std::string_view::npos && (found() == '}' || found() == ']' || found() == ',');
    }
    SyntaxMistake commaTooMany() const {
        return {comma_, std::string("a comma too many before \"") + found() + '"'};
    }

    // {{ at the beginning, or where nothing closes one of them; else it is a list of objects.
    bool isBraceTwice() const {
        const bool isRoot = skipped(0) == s_.opening, isUnclosed = excess('}') < 0 && excess(']') <= 0;
        return found() == '{' && s_.last == JsonEvent::Open && (isRoot || isUnclosed);
    }

    SyntaxMistake atKey() const {
        if (isForeign()) return foreign();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd()) return unclosed();
        if (isParenthesis()) return parenthesis();
        const std::string_view word = wordAt(at_);
        const bool isNumber = numberOf<double>(word).has_value();
        const bool isList = found() == '[' || found() == '{' || isNumber;
        if (isBraceTwice()) return {at_, "a bracket too many"};
        if (isList && s_.last == JsonEvent::Open)
            return {s_.opening, "a list stands in [ and ], not in { and }"};
        if (isNumber && isBehindNumber()) return {s_.begin, aboutBareList(s_.text.substr(s_.begin))};
        if (found() == ']') return wrongClosing();
        if (found() == '{') return unclosed();
        if (found() == '"') return inString();
        if (const auto quotes = otherQuotes(); !quotes.empty()) return {at_, quotes};
        if (word.empty() || isDigitAt(word, 0))
            return {at_, "expected a key in double quotes, found " + shown()};
        return {at_, "a key stands in double quotes: write \"" + std::string(inQuotes(word)).substr(1)};
    }

    SyntaxMistake atValue() const {
        if (isHexColor(wordAt(at_))) return {at_, aboutHexColor(wordAt(at_))};
        if (isForeign()) return foreign();
        if (isParenthesis()) return parenthesis();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd() && s_.container) return unclosed();
        if (isAtEnd()) return {at_, "expected a scene, found an empty file"};
        if (found() == '}' && s_.container == '[') return wrongClosing();
        if (found() == '"') return inString();
        if (const auto quotes = otherQuotes(); !quotes.empty()) return {at_, quotes};
        const std::string_view word = wordAt(at_);
        if (word.empty()) return {at_, "expected a value, found " + shown()};
        return isFormula(word) ? calculation(at_) : SyntaxMistake{at_, aboutWord(word)};
    }

    std::string otherQuotes() const {
        const std::string_view rest = s_.text.substr(at_);
        if (rest.starts_with('\'')) return "text stands in double quotes, not in single ones";
        const bool isCurly =
            rest.starts_with("\u201c") || rest.starts_with("\u201d") || rest.starts_with("\u201e");
        return isCurly ? "text stands in plain double quotes (\"), not in curved ones" : "";
    }

    SyntaxMistake inString() const {
        std::size_t at = at_ + 1;
        for (; at < s_.text.size() && s_.text[at] != '"'; ++at) {
            if (s_.text[at] == '\n' || s_.text[at] == '\r')
                return {at_, "a text has no end: \" is missing in this line"};
            if (s_.text[at] == '\t') return {at, "a tab in a text: write \\t, or a blank"};
            if (static_cast<unsigned char>(s_.text[at]) < ' ') return {at, "a control character in a text"};
            if (s_.text[at] != '\\') continue;
            if (const auto wrong = wrongEscape(at); !wrong.empty()) return {at, wrong};
            ++at;
        }
        if (at >= s_.text.size()) return {at_, "a text has no end: \" is missing"};
        return {s_.stopped, "a byte that is no UTF-8: save the file as UTF-8"};
    }
    std::string wrongEscape(std::size_t at) const {
        const char escaped = at + 1 < s_.text.size() ? s_.text[at + 1] : '"';
        if (std::string_view("\"\\/bfnrt").find(escaped) != std::string_view::npos) return "";
        if (escaped != 'u') return "a backslash in a text is written twice; in a path, write /";
        const std::string_view digits = s_.text.substr(at + 2, 4);
        const bool isHex = digits.size() == 4 &&
                           std::ranges::all_of(digits, [](unsigned char c) { return std::isxdigit(c); });
        if (!isHex) return "expected four hexadecimal digits behind \\u";
        const bool isBlamed = s_.stopped >= at && s_.stopped < at + 12;  // of a pair, its second half
        const bool isSurrogate = (digits[0] == 'd' || digits[0] == 'D') && digits[1] >= '8';
        return isSurrogate && isBlamed ? "half a character: \\ud800 to \\udfff stand in pairs" : "";
    }

    const SyntaxState& s_;
    std::size_t at_;  // the first character that has a meaning, behind the last event
    std::size_t comma_ = std::string_view::npos;  // behind the last event, if it is there
};

}  // namespace

SyntaxMistake syntaxMistake(const SyntaxState& state) { return Finder(state).find(); }

}  // namespace raytracer
