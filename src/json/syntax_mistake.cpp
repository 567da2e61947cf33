#include "syntax_mistake.h"

#include <algorithm>
#include <cctype>

#include "raytracer/json/json_document.h"
#include "raytracer/util/number.h"

namespace raytracer {
namespace {

constexpr std::string_view blanks = " \t\r\n", ends = " \t\r\n,:[]{}\"";

bool isDigitAt(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

// Finds out what stands behind the last event, and what should.
class Finder {
  public:
    explicit Finder(const SyntaxState& state) : s_(state), at_(skipped(state.end)) {}

    SyntaxMistake find() {
        if (s_.last == JsonEvent::Key) return behindKey();
        const bool isBehindValue = s_.last == JsonEvent::Value || s_.last == JsonEvent::Close;
        if (isBehindValue && !s_.container) return isComment() ? comment() : behindAll();
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

    bool isComment() const {
        const std::string_view rest = s_.text.substr(at_);
        return rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with('#');
    }
    SyntaxMistake comment() const { return {at_, "a comment, which JSON does not have: delete it"}; }

    // What was found, for a message.
    std::string shown() const {
        if (isAtEnd()) return "the end of the file";
        const std::string_view word = wordAt(at_);
        return inQuotes(word.empty() ? s_.text.substr(at_, 1) : word);
    }

    std::string theOpening() const {
        return std::string("the ") + (s_.container == '{' ? "object" : "list") + " of line " +
               std::to_string(lineOf(s_.opening));
    }
    SyntaxMistake unclosed() const {
        const std::string bracket{'"', closing(), '"'};
        return {at_, bracket + " is missing at the end of " + theOpening()};
    }

    SyntaxMistake behindKey() {
        const std::string key(s_.text.substr(s_.begin, s_.end - s_.begin));
        if (isComment()) return comment();
        if (found() != ':') return {s_.end, "a colon is missing behind the key " + inQuotes(unquoted(key))};
        at_ = skipped(at_ + 1);
        return atValue();
    }
    static std::string_view unquoted(std::string_view text) {
        return text.size() < 2 ? text : text.substr(1, text.size() - 2);
    }

    SyntaxMistake behindAll() const {
        if (found() == '}' || found() == ']') return {at_, "a bracket too many"};
        if (found() == ',') return {at_, "a comma too many: the scene ends before it"};
        if (found() == ':') return {s_.begin, "\"{\" is missing before this key"};
        return {at_, "expected the end of the file, found " + shown()};
    }

    SyntaxMistake behindValue() {
        if (isComment()) return comment();
        if (isAtEnd()) return unclosed();
        if (found() == ',') {
            if (isDecimalComma()) return decimalComma();
            comma_ = at_;
            at_ = skipped(at_ + 1);
            return s_.container == '{' ? atKey() : atValue();
        }
        const bool goesOn = at_ == s_.end && !wordAt(at_).empty();
        if (isBehindNumber() && (goesOn || isOperator())) return longerNumber();
        if (found() == '}' || found() == ']') return unclosed();
        if (found() == ':' && s_.container == '[') return {s_.begin, unclosed().message};
        if (found() == ':') return {at_, "expected a comma, found \":\""};
        return {s_.end, "a comma is missing here"};
    }
    bool isBehindNumber() const { return s_.last == JsonEvent::Value && isDigitAt(s_.text, s_.end - 1); }
    // "[1 -2]" lacks a comma; "[1 - 2]" and "[1-2]" calculate.
    bool isOperator() const {
        const bool isSign = found() == '+' || found() == '-';
        return std::string_view("+-*/^%").find(found()) != std::string_view::npos &&
               (!isSign || at_ == s_.end || !isDigitAt(s_.text, at_ + 1));
    }

    // A number goes on where it should end: 360/4, 007, 90deg.
    SyntaxMistake longerNumber() const {
        if (found() == ';') return {at_, "expected a comma, found \";\""};
        if (isOperator())
            return {s_.begin, "JSON does not calculate: write the result of " + inQuotes(formula())};
        const std::size_t end = at_ + wordAt(at_).size();
        const std::string all(s_.text.substr(s_.begin, end - s_.begin));
        if (numberOf<double>(all))
            return {s_.begin, "a number has no zero in front: write " + withoutZeros(all)};
        return {s_.begin, "expected a number, found " + inQuotes(all)};
    }
    std::string_view formula() const {
        const std::size_t end = std::min(s_.text.find_first_of(",]}\r\n", at_), s_.text.size());
        return s_.text.substr(s_.begin, s_.text.find_last_not_of(" \t", end - 1) + 1 - s_.begin);
    }

    // Where a key should follow: "x": 0,5
    bool isDecimalComma() const {
        return s_.container == '{' && isBehindNumber() && at_ == s_.end && isDigitAt(s_.text, at_ + 1);
    }
    SyntaxMistake decimalComma() const {
        const std::string whole(s_.text.substr(s_.begin, s_.end - s_.begin)), fraction(wordAt(at_ + 1));
        return {at_, "a number has a decimal point: write " + whole + "." + fraction};
    }

    static std::string withoutZeros(const std::string& number) {
        const std::size_t sign = number[0] == '-';
        const std::size_t first = std::min(number.find_first_not_of('0', sign), number.size() - 1);
        return number.substr(0, sign) + number.substr(first);
    }

    // Where only the end of the container or another comma follows one.
    bool isCommaTooMany() const {
        return comma_ != std::string_view::npos && (found() == '}' || found() == ']' || found() == ',');
    }
    SyntaxMistake commaTooMany() const {
        return {comma_, std::string("a comma too many before \"") + found() + '"'};
    }

    SyntaxMistake atKey() const {
        if (isComment()) return comment();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd() || found() == ']' || found() == '{') return unclosed();
        if (found() == '"') return inString();
        if (const auto quotes = otherQuotes(); !quotes.empty()) return {at_, quotes};
        const std::string_view word = wordAt(at_);
        if (word.empty() || isDigitAt(word, 0))
            return {at_, "expected a key in double quotes, found " + shown()};
        return {at_, "a key stands in double quotes: write \"" + std::string(inQuotes(word)).substr(1)};
    }

    SyntaxMistake atValue() const {
        if (isComment()) return comment();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd() && s_.container) return unclosed();
        if (isAtEnd()) return {at_, "expected a scene, found an empty file"};
        if (found() == '}' && s_.container == '[') return unclosed();
        if (found() == '"') return inString();
        if (const auto quotes = otherQuotes(); !quotes.empty()) return {at_, quotes};
        const std::string_view word = wordAt(at_);
        if (word.empty()) return {at_, "expected a value, found " + shown()};
        return {at_, aboutWord(word)};
    }

    std::string otherQuotes() const {
        const std::string_view rest = s_.text.substr(at_);
        if (rest.starts_with('\'')) return "text stands in double quotes, not in single ones";
        const bool isCurly =
            rest.starts_with("\u201c") || rest.starts_with("\u201d") || rest.starts_with("\u201e");
        return isCurly ? "text stands in plain double quotes (\"), not in curved ones" : "";
    }

    // What is no value, though its author meant one.
    static std::string aboutWord(std::string_view word) {
        const std::string lower = inLowerCase(word), text = inQuotes(word);
        if (isOneOf(lower, {"true", "false", "null"}))
            return "expected " + lower + ", found " + text + ": small letters";
        if (lower == "none") return "expected null, found " + text;
        const std::string_view unsigned_ = std::string_view(lower).substr(lower[0] == '-' || lower[0] == '+');
        if (isOneOf(unsigned_, {"nan", "inf", "infinity"})) return "expected a finite number, found " + text;
        if (word[0] == '(') return "a list stands in [ and ], not in ( and )";
        if (isOneOf(unsigned_, {"pi", "tau", "e"}))
            return "JSON has no constants: write the number for " + text;
        if (word[0] == '+' && numberOf<double>(word))
            return "a number has no plus in front: write " + std::string(word.substr(1));
        if (numberOf<double>(word)) return "a point stands between digits: write " + withDigits(word);
        if (isDigitAt(word, 0) || isDigitAt(word, 1) || word == "-")
            return "expected a number, found " + text;
        if (static_cast<unsigned char>(word[0]) < ' ' || static_cast<unsigned char>(word[0]) == 0x89)
            return "expected JSON, found what is no text";
        return "expected a value, found " + text + "; text stands in double quotes";
    }
    // ".5" as "0.5", "5." as "5.0".
    static std::string withDigits(std::string_view number) {
        std::string digits(number);
        const std::size_t point = digits.find('.');
        if (!isDigitAt(digits, point + 1)) digits.insert(point + 1, "0");
        if (point == 0 || !isDigitAt(digits, point - 1)) digits.insert(point, "0");
        return digits;
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
        const bool isSurrogate = inLowerCase(digits)[0] == 'd' && digits[1] >= '8';
        return isSurrogate && isBlamed ? "half a character: \\ud800 to \\udfff stand in pairs" : "";
    }

    const SyntaxState& s_;
    std::size_t at_;  // the first character that has a meaning, behind the last event
    std::size_t comma_ = std::string_view::npos;  // behind the last event, if it is there
};

}  // namespace

SyntaxMistake syntaxMistake(const SyntaxState& state) { return Finder(state).find(); }

}  // namespace raytracer
