// JSON without anything that is rare. A scene of a million shapes has twenty million values; nlohmann's
// lexer, which copies each token letter by letter and asks strtod, takes most of the time that such a scene
// takes to load (Notes.txt).
#include <charconv>

#include "json_nodes.h"

namespace raytracer {
namespace {

using Kind = JsonDocument::Kind;

// A quotient of two whole numbers that double holds exactly is rounded once, so right (Clinger, How to Read
// Floating Point Numbers Accurately, 1990): 15 digits over 10^15 are.
constexpr std::ptrdiff_t mostExactDigits = 15;
constexpr double powersOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                  1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

class Scanner {
  public:
    Scanner(std::string_view text, JsonNodes& nodes)
        : p_(text.data()), end_(p_ + text.size()), nodes_(nodes) {}

    bool scan();

  private:
    // NUL, which is no part of JSON, stands for the end.
    char peek() const { return p_ != end_ ? *p_ : '\0'; }
    char peekBehindBlanks() {
        while (peek() == ' ' || peek() == '\n' || peek() == '\t' || peek() == '\r') ++p_;
        return peek();
    }
    bool take(char c) { return peek() == c && (++p_, true); }

    bool open(Kind kind);
    bool goOn();
    bool scalar(char first);
    bool key();
    bool text(Kind kind);
    bool word(std::string_view word, Kind kind, double value);
    bool number();
    bool longNumber(const char* begin, double& value);
    bool digits(std::uint64_t& number);

    const char* p_;
    const char* end_;
    JsonNodes& nodes_;
    bool whole_ = false;
};

// Each round takes a value, or the beginning of one that is not empty.
bool Scanner::scan() {
    while (!whole_) {
        const char first = peekBehindBlanks();
        const bool taken = first == '{'   ? open(Kind::Object)
                           : first == '[' ? open(Kind::Array)
                                          : scalar(first) && goOn();
        if (!taken) return false;
    }
    peekBehindBlanks();
    return p_ == end_;
}

bool Scanner::open(Kind kind) {
    ++p_;
    nodes_.open(kind);
    const bool isObject = kind == Kind::Object;
    if (peekBehindBlanks() == (isObject ? '}' : ']')) return goOn();
    return !isObject || key();
}

// After a value: closes what ends with it, up to where the next one begins.
bool Scanner::goOn() {
    while (nodes_.anyOpen()) {
        const bool isObject = nodes_.isInObject();
        const char next = peekBehindBlanks();
        if (next == ',') return ++p_, !isObject || key();
        if (next != (isObject ? '}' : ']') || (isObject && nodes_.twice())) return false;
        ++p_;
        nodes_.close();
    }
    return whole_ = true;
}

bool Scanner::scalar(char first) {
    switch (first) {
        case '"': return text(Kind::String);
        case 't': return word("true", Kind::Boolean, 1);
        case 'f': return word("false", Kind::Boolean, 0);
        case 'n': return word("null", Kind::Null, 0);
        default: return number();
    }
}

bool Scanner::key() {
    return peekBehindBlanks() == '"' && text(Kind::Key) && peekBehindBlanks() == ':' && (++p_, true);
}

bool Scanner::text(Kind kind) {
    const char* const begin = ++p_;
    while (p_ != end_ && static_cast<signed char>(*p_) >= ' ' && *p_ != '"' && *p_ != '\\')
        ++p_;  // beyond ASCII is below 0
    if (peek() != '"' || static_cast<std::size_t>(p_ - begin) > std::numeric_limits<std::uint32_t>::max())
        return false;
    nodes_.addText(kind, {begin, p_});
    return ++p_, true;
}

bool Scanner::word(std::string_view word, Kind kind, double value) {
    if (!std::string_view(p_, end_).starts_with(word)) return false;
    p_ += word.size();
    nodes_.addNumber(kind, value);
    return true;
}

bool Scanner::digits(std::uint64_t& number) {
    const char* const begin = p_;
    for (; isDigit(peek()); ++p_) number = 10 * number + static_cast<std::uint64_t>(*p_ - '0');
    return p_ != begin;
}

bool Scanner::number() {
    const char* const begin = p_;
    const bool negative = take('-');
    std::uint64_t digitsAsOne = 0;
    if (!take('0') && !digits(digitsAsOne)) return false;
    const char* const point = p_;
    if (take('.') && !digits(digitsAsOne)) return false;
    const bool isWhole = p_ == point, hasExponent = peek() == 'e' || peek() == 'E';
    double value = 0;
    if (!hasExponent && p_ - begin <= mostExactDigits) {
        value = static_cast<double>(digitsAsOne) / powersOfTen[isWhole ? 0 : p_ - point - 1];
        if (negative)
            value = isWhole ? 0 - value : -value;  // to nlohmann, -0 is an integer, which has no sign
    } else if (!longNumber(begin, value)) {
        return false;
    }
    nodes_.addNumber(Kind::Number, value);
    return true;
}

// One whose digits, or whose exponent, may be too many for a single rounding of exact numbers.
bool Scanner::longNumber(const char* begin, double& value) {
    std::uint64_t exponent = 0;
    if (take('e') || take('E')) {
        if (!take('+')) take('-');
        if (!digits(exponent)) return false;
    }
    return std::from_chars(begin, p_, value).ec == std::errc();
}

}  // namespace

bool scanPlainJson(std::string_view text, JsonNodes& nodes) { return Scanner(text, nodes).scan(); }

}  // namespace raytracer
