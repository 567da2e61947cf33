#include "syntax_mistake.h"

#include <cctype>

#include "foreign_text.h"
#include "quote_mistake.h"
#include "raytracer/util/text.h"
#include "syntax_cursor.h"
#include "word_mistake.h"

namespace raytracer {
namespace {

// Finds the mistake from what follows the last event.
class Finder : private SyntaxCursor {
  public:
    explicit Finder(const SyntaxState& state) : SyntaxCursor(state) {}

    SyntaxMistake find() {
        if (s_.last == JsonEvent::None) return atRoot();
        if (s_.last == JsonEvent::Key) return behindKey();
        const bool isBehindValue = s_.last == JsonEvent::Value || s_.last == JsonEvent::Close;
        if (isBehindValue && !s_.container) return isForeign() ? foreign() : behindAll();
        if (isBehindValue) return behindValue();
        return s_.container == '{' ? atKey() : atValue();
    }

  private:
    SyntaxMistake unclosed() const {
        const auto line = isAtEnd() && s_.container == '{' ? outdented(s_.text) : std::nullopt;
        if (line) return {line->place, "\"}\" is missing at the end of " + theOpening(line->opening)};
        const std::string bracket{'"', closing(), '"'};
        return {at_, bracket + " is missing at the end of " + theOpening(s_.opening)};
    }

    bool isForeign() const { return !aboutForeign(rest()).empty(); }
    SyntaxMistake foreign() const { return {at_, aboutForeign(rest())}; }

    SyntaxMistake atRoot() const {
        if (isAtEnd()) return {at_, "expected a scene, found an empty file"};
        if (const auto format = aboutFormat(rest()); !format.empty()) return {at_, format};
        if (rest().starts_with("---")) return {at_, "expected \"{\", found " + shown()};
        return atValue();
    }

    SyntaxMistake behindKey() {
        const std::string_view key = s_.text.substr(s_.begin, s_.end - s_.begin);
        if (isForeign()) return foreign();
        if (isSwallowing(s_)) return {s_.begin, "a text has no end: \" is missing"};
        if (isQuoteInText(s_)) return quoteInText();
        if (found() == '=') return {at_, "expected \":\" behind a key, found \"=\""};
        if (found() != ':')
            return {s_.end, "a colon is missing behind the key " + inQuotes(key.substr(1, key.size() - 2))};
        isColor_ = key.starts_with("\"color");
        at_ = skipped(at_ + 1);
        return atValue();
    }
    SyntaxMistake quoteInText() const { return {s_.end - 1, "a quote in a text is written \\\""}; }

    SyntaxMistake behindAll() const {
        if (found() == '}' || found() == ']') return {at_, "a bracket too many"};
        if (s_.last == JsonEvent::Close && excess(s_.text, s_.text[s_.end - 1]) > 0)
            return {s_.end - 1, "a bracket too many"};
        if (found() == ',' && s_.last == JsonEvent::Value) return bareNumbers();
        if (found() == ',') return {at_, "a comma too many: the scene ends before it"};
        if (found() == ':' && isBehindText()) return {s_.begin, "\"{\" is missing before this key"};
        return {at_, "expected the end of the file, found " + shown()};
    }
    SyntaxMistake bareNumbers() const {
        return proposal(s_.begin, "a list stands in [ and ]", bareList(s_.text.substr(s_.begin)));
    }

    bool isParenthesis() const { return found() == ')' && s_.container; }
    SyntaxMistake parenthesis() const {
        if (excess(s_.text, closing()) >= 0) return {at_, "a bracket too many"};
        return expectedClosing();
    }
    SyntaxMistake expectedClosing() const {
        return {at_, std::string("expected \"") + closing() + "\", found \"" + found() + '"'};
    }

    SyntaxMistake behindValue() {
        if (isForeign()) return foreign();
        if (isAtEnd()) return unclosed();
        if (isParenthesis()) return parenthesis();
        if (found() == ';') return {at_, "expected a comma, found \";\""};
        if (isBehindNumber())
            if (const Meant number = withoutThousands(s_.text.substr(s_.begin), s_.container == '['))
                return proposal(s_.begin, "a number has no separator of thousands", number);
        if (found() == ',') {
            if (isDecimalComma()) return decimalComma();
            comma_ = at_;
            at_ = skipped(at_ + 1);
            return s_.container == '{' ? atKey() : atValue();
        }
        const bool goesOn = at_ == s_.end && !wordAt(at_).empty();
        if (isBehindNumber() && (goesOn || isOperatorInLine() || isUnitInLine())) return longerNumber();
        if (isSwallowing(s_)) return {s_.begin, "a text has no end: \" is missing"};
        if (s_.last == JsonEvent::Value && isQuoteInText(s_)) return quoteInText();
        if (isOperatorInLine()) return calculation(valueBegin());
        if (goesOn && s_.last == JsonEvent::Value &&
            std::isalpha(static_cast<unsigned char>(s_.text[s_.begin])))  // truee
            return aboutWordAt(s_.begin);
        if (found() == '}' || found() == ']') return wrongClosing();
        if (found() == ':') return behindColon();
        if (s_.container == '{' && isBehindNumber() && isInLine() && isNumber(wordAt(at_)))
            return spacedNumbers();
        return {s_.end, "a comma is missing here"};
    }
    // "eye": 0 0 4
    SyntaxMistake spacedNumbers() const {
        const std::size_t end = std::min(s_.text.find_first_of(",}\r\n", s_.begin), s_.text.size());
        const std::string list = listOf(numbersIn(s_.text.substr(s_.begin, end - s_.begin)));
        if (list.empty()) return {s_.end, "a comma is missing here"};
        return proposal({s_.begin, end}, {"a list stands in [ and ]", list});
    }
    bool isTooMany(char bracket) const {
        return excess(s_.text, bracket) > 0 && excess(s_.text, closing()) >= 0;
    }
    SyntaxMistake wrongClosing() const {
        if (isTooMany(found())) return {at_, "a bracket too many"};
        const bool isSwapped = excess(s_.text, found()) == 1 && excess(s_.text, closing()) == -1;
        return isSwapped ? expectedClosing() : unclosed();
    }
    SyntaxMistake behindColon() const {
        if (!isBehindText() || isKeyAt(skipped(at_ + 1))) return {at_, "expected a comma, found \":\""};
        if (s_.container == '[') return keyInList();
        return {s_.begin, "\"{\" is missing before this key"};
    }
    bool isKeyAt(std::size_t at) const {
        return charAt(at) == '"' && charAt(skipped(s_.text.find('"', at + 1) + 1)) == ':';
    }
    SyntaxMistake keyInList() const {
        if (s_.text.find_first_not_of(blanks, s_.opening + 1) == s_.begin)
            return {s_.opening, "keys stand in { and }, not in [ and ]"};
        const std::size_t closed = s_.text.rfind('}', s_.begin);
        if (closed != std::string_view::npos && isTooMany('}')) return keyBehind(closed);
        const std::size_t comma = s_.text.find_last_not_of(blanks, s_.begin - 1);
        const bool hasComma = s_.text[comma] == ',';
        const std::size_t end = s_.text.find_last_not_of(blanks, comma - hasComma) + 1;
        return {end, unclosed().message};
    }
    // If the object that is closed there has this key already, the key belongs to another object.
    SyntaxMistake keyBehind(std::size_t closed) const {
        const std::string_view key = s_.text.substr(s_.begin, s_.end - s_.begin);
        const std::size_t opening = s_.text.rfind('{', closed);
        if (s_.text.substr(opening, closed - opening).find(key) == std::string_view::npos)
            return {closed, "a bracket too many"};
        return {s_.begin, "\"{\" is missing before this key"};
    }

    // "[1 -2]" lacks a comma; "[1 - 2]" and "[1-2]" are calculations.
    bool isOperator() const {
        const bool isSign = found() == '+' || found() == '-';
        return isOneOf(found(), "+-*/^%") && (!isSign || at_ == s_.end || !isDigitAt(s_.text, at_ + 1));
    }

    bool isInLine() const {
        return s_.text.substr(s_.end, at_ - s_.end).find('\n') == std::string_view::npos;
    }
    bool isUnitInLine() const { return isInLine() && isUnit(wordAt(at_)); }
    bool isOperatorInLine() const { return isInLine() && s_.text[s_.end - 1] != '}' && isOperator(); }

    // A number is followed by more than may follow it: 360/4, 007, 90deg, 1 m.
    SyntaxMistake longerNumber() const {
        if (isOperator()) return calculation(s_.begin);
        const std::size_t end = at_ + wordAt(at_).size();
        const std::string all(s_.text.substr(s_.begin, end - s_.begin));
        if (isUnit(wordAt(at_))) {
            const std::string number(s_.text.substr(s_.begin, s_.end - s_.begin));
            return proposal({s_.begin, end}, {"a number has no unit", number});
        }
        if (isNumber(all)) return proposal({s_.begin, end}, {aboutNumberForm(all), asJsonNumber(all)});
        return {s_.begin, "expected a number, found " + inQuotes(all)};
    }
    SyntaxMistake calculation(std::size_t begin) const {
        return {begin, aboutCalculation(s_.text.substr(begin))};
    }

    // A decimal comma where a key should follow the comma: "x": 0,5
    Meant decimal() const { return withDecimalPoint(s_.text.substr(s_.begin)); }
    bool isDecimalComma() const { return s_.container == '{' && isBehindNumber() && decimal(); }
    SyntaxMistake decimalComma() const {
        const Meant number = decimal();
        std::string whole = number.json;
        std::erase(whole, '.');
        const bool isUnsure = mayBeThousand(number.json);
        SyntaxMistake mistake = isUnsure ? proposal({s_.begin, s_.begin + number.size},
                                                    {"a number has no comma", whole, ", or " + number.json})
                                         : proposal(s_.begin, "a number has a decimal point", number);
        mistake.offset = at_;
        return mistake;
    }

    // Whether a comma is followed by a closing bracket or another comma.
    bool isCommaTooMany() const {
        return comma_ != std::string_view::npos && (found() == '}' || found() == ']' || found() == ',');
    }
    SyntaxMistake commaTooMany() const {
        return {comma_, std::string("a comma too many before \"") + found() + '"'};
    }

    // "{{" at the root, or with a "}" missing, or closed by "}}". Any other was meant as a list of objects.
    bool isBraceTwice() const {
        if (found() != '{' || s_.last != JsonEvent::Open) return false;
        const bool isUnclosed = excess(s_.text, '}') < 0 && excess(s_.text, ']') <= 0;
        return isRoot(s_.opening) || isUnclosed || charAt(skipped(closingOf(s_.text, at_) + 1)) == '}';
    }

    SyntaxMistake atKey() const {
        if (isForeign()) return foreign();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd()) return unclosed();
        if (isParenthesis()) return parenthesis();
        const std::string_view word = wordAt(at_);
        if (!word.empty() && charAt(skipped(at_ + word.size())) == ':' && aboutOtherQuotes(word).empty())
            return bareKey(word);
        const bool isList = found() == '[' || found() == '{' || isNumber(word);
        if (isBraceTwice()) return {at_, "a bracket too many"};
        if (isList && s_.last == JsonEvent::Open)
            return {s_.opening, "a list stands in [ and ], not in { and }"};
        if (isNumber(word) && isBehindNumber()) return bareNumbers();
        if (found() == ']') return wrongClosing();
        if (found() == '{') return unclosed();
        if (found() == '"') return stringMistake(s_, at_);
        if (const auto quotes = aboutOtherQuotes(rest()); !quotes.empty()) return {at_, quotes};
        if (word.empty() || isDigitAt(word, 0))
            return {at_, "expected a key in double quotes, found " + shown()};
        return bareKey(isPlainText(word) ? word : "");
    }
    SyntaxMistake bareKey(std::string_view word) const {
        const std::string why = "a key stands in double quotes", quoted = jsonString(word);
        if (word.empty() || quoted.size() > longestProposal) return {at_, why};
        return {at_, why + ": write " + quoted, {at_, at_ + word.size()}, quoted};
    }

    SyntaxMistake atValue() const {
        const std::size_t end = at_ + wordAt(at_).size();
        const std::string color = isColor_ && isEnd(end) ? hexColor(wordAt(at_)) : "";
        if (!color.empty()) return proposal({at_, end}, {"a color is 3 numbers", color});
        if (isForeign()) return foreign();
        if (isParenthesis()) return parenthesis();
        if (isCommaTooMany()) return commaTooMany();
        if (isAtEnd() && s_.container) return unclosed();
        if (found() == '}' && s_.container == '[') return wrongClosing();
        if (found() == '"') return stringMistake(s_, at_);
        if (const auto quotes = aboutOtherQuotes(rest()); !quotes.empty()) return {at_, quotes};
        const std::string_view word = wordAt(at_);
        if (auto list = otherList(); !list.message.empty()) return list;
        if (found() == '(') return inParentheses();
        if (word.empty()) return {at_, "expected a value, found " + shown()};
        if (word.size() <= 2 && charAt(at_ + word.size()) == '"') return prefixedText(word.size());
        return isFormula(word) ? calculation(at_) : aboutWordAt(at_);
    }
    // A list of numbers as other languages write it.
    SyntaxMistake otherList() const {
        const char* const why = "a list stands in [ and ]";
        const bool isInList = s_.container == '[' && s_.last == JsonEvent::Open;
        if (isInList)
            if (const Meant list = vectorElsewhere(s_.text.substr(s_.opening)))
                return proposal(s_.opening, aboutFirstNumber(), list);
        const Meant list = vectorElsewhere(rest());
        return list ? proposal(at_, why, list) : SyntaxMistake{at_, ""};
    }
    const char* aboutFirstNumber() const {
        if (std::isalpha(static_cast<unsigned char>(found()))) return "the numbers of a list have no names";
        return isNumber(wordAt(at_)) ? aboutNumberForm(wordAt(at_)) : "a list stands in [ and ]";
    }
    // A string with a prefix, as in Python: r"red".
    SyntaxMistake prefixedText(std::size_t prefix) const {
        const std::size_t begin = at_ + prefix, end = s_.text.find_first_of("\"\n", begin + 1);
        const std::string text(s_.text.substr(begin, end - begin));
        return proposal({at_, begin + text.size() + 1}, {"a text begins with its quote", text + '"'});
    }
    SyntaxMistake inParentheses() const {
        const std::size_t end = closingOf(s_.text, at_);
        if (charAt(end) != ')') return {at_, "JSON has no ( and )"};
        const std::string inside(s_.text.substr(at_ + 1, end - at_ - 1));
        return proposal({at_, end + 1}, {"JSON has no ( and )", inside});
    }
    SyntaxMistake aboutWordAt(std::size_t at) const {
        const std::string_view word = wordAt(at);
        const WordMistake about = aboutWord(word);
        const std::size_t end = at + word.size();
        if (s_.last == JsonEvent::None && about.why.starts_with("expected a value"))
            return {at, "expected \"{\", found " + inQuotes(word)};
        return proposal({at, end}, about);
    }

    std::size_t comma_ = std::string_view::npos;  // the comma behind the last event, if there is one
    bool isColor_ = false;                        // whether the key says that the next value is a colour
};

}  // namespace

SyntaxMistake syntaxMistake(const SyntaxState& state) { return Finder(state).find(); }

}  // namespace raytracer
