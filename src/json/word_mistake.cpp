#include "word_mistake.h"

#include <algorithm>
#include <cctype>

#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

std::string_view withoutSign(std::string_view word) {
    return word.substr(word.starts_with('-') || word.starts_with('+'));
}

bool isConstant(std::string_view word) { return isOneOf(inLowerCase(word), {"pi", "tau", "e"}); }

// ".5" as "0.5", "5." as "5.0".
std::string withDigits(std::string_view number) {
    std::string digits(number);
    const std::size_t point = digits.find('.');
    if (!isDigitAt(digits, point + 1)) digits.insert(point + 1, "0");
    if (point == 0 || !isDigitAt(digits, point - 1)) digits.insert(point, "0");
    return digits;
}

// True or false, if the word is like one of them.
std::string truth(const std::string& lower) {
    if (isOneOf(lower, {"yes", "on"})) return "true";
    if (isOneOf(lower, {"no", "off"})) return "false";
    NearestName nearest(lower);
    nearest.consider("true");
    nearest.consider("false");
    return nearest.found() ? nearest.name() : "";
}

// A minus sign, an en dash or an em dash before a digit.
std::string_view behindDash(std::string_view word) {
    const bool isDash =
        word.starts_with("\u2212") || word.starts_with("\u2013") || word.starts_with("\u2014");
    return isDash && isDigitAt(word, 3) ? word.substr(3) : "";
}

std::string aboutNumber(std::string_view word) {
    if (word[0] == '+' && numberOf<double>(word))
        return "a number has no plus in front: write " + std::string(word.substr(1));
    if (numberOf<double>(word)) return "a point stands between digits: write " + withDigits(word);
    if (const auto number = behindDash(word); !number.empty())
        return "a minus is the sign -: write -" + std::string(number);
    const bool isMeant = isDigitAt(word, 0) || isDigitAt(word, 1) || word == "-" ||
                         (word.starts_with("--") && word.size() > 2);
    return isMeant ? "expected a number, found " + inQuotes(word) : "";
}

// Unicode's code point, of a character that looks like a blank or like nothing; else 0.
unsigned invisible(std::string_view text) {
    struct Invisible {
        std::string_view bytes;
        unsigned code;
    };
    static constexpr Invisible all[] = {
        {"\u00a0", 0xa0},   {"\u00ad", 0xad},   {"\u2002", 0x2002}, {"\u2003", 0x2003}, {"\u2009", 0x2009},
        {"\u200b", 0x200b}, {"\u200c", 0x200c}, {"\u200d", 0x200d}, {"\u200e", 0x200e}, {"\u200f", 0x200f},
        {"\u202f", 0x202f}, {"\u2060", 0x2060}, {"\u3000", 0x3000}, {"\ufeff", 0xfeff}};
    const auto found = std::ranges::find_if(
        all, [&](const Invisible& character) { return text.starts_with(character.bytes); });
    return found == std::end(all) ? 0 : found->code;
}

}  // namespace

bool isHexColor(std::string_view word) {
    return (word.size() == 4 || word.size() == 7) && word[0] == '#' &&
           std::ranges::all_of(word.substr(1), [](unsigned char c) { return std::isxdigit(c); });
}

std::string aboutHexColor(std::string_view color) {
    const std::size_t digits = color.size() / 3;  // of a channel
    double channels[3];
    for (std::size_t i = 0; i < 3; ++i) {
        std::string hex(color.substr(1 + i * digits, digits));
        if (digits == 1) hex += hex;
        channels[i] = std::stoi(hex, nullptr, 16) / 255.0;
    }
    return formatted("a color is 3 numbers: write [%.3g, %.3g, %.3g]", channels[0], channels[1], channels[2]);
}

bool isUnit(std::string_view word) {
    return isOneOf(inLowerCase(word), {"m", "cm", "mm", "km", "in", "ft", "deg", "degree", "degrees", "rad",
                                       "radians", "px", "f", "meter", "meters", "unit", "units", "\u00b0"});
}

bool isDigitAt(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

std::string aboutWord(std::string_view word) {
    const std::string lower = inLowerCase(word), text = inQuotes(word);
    if (isOneOf(lower, {"true", "false"})) return "expected " + lower + ", found " + text + ": small letters";
    if (isOneOf(lower, {"null", "none", "nil", "undefined"}))
        return "expected a value, found " + text + ": leave out a key that has none";
    if (isOneOf(withoutSign(lower), {"nan", "inf", "infinity"}))
        return "expected a finite number, found " + text;
    if (word[0] == '(') return "a list stands in [ and ], not in ( and )";
    if (isConstant(withoutSign(word))) return "JSON has no constants: write the number for " + text;
    if (std::string about = aboutNumber(word); !about.empty()) return about;
    if (static_cast<unsigned char>(word[0]) < ' ' || static_cast<unsigned char>(word[0]) == 0x89)
        return "expected JSON, found what is no text";
    const std::string likely = truth(lower), found = "expected a value, found " + text + "; ";
    return likely.empty() ? found + "text stands in double quotes"
                          : found + "write " + likely + ", or a text in double quotes";
}

bool isFormula(std::string_view word) {
    word = withoutSign(word);
    const std::size_t sign = word.find_first_of("(+-*/^");
    return sign != word.npos && sign > 0 && (word[sign] == '(' || isConstant(word.substr(0, sign)));
}

std::string aboutCalculation(std::string_view text) {
    std::size_t end = 0;
    const auto isAt = [&](std::string_view set) { return set.find(text[end]) != set.npos; };
    for (int depth = 0; end < text.size() && !isAt(depth > 0 ? "\r\n" : ",]}\r\n"); ++end)
        depth += isAt("([") - isAt(")]");
    end = text.find_last_not_of(" \t", end - 1) + 1;
    return "JSON does not calculate: write the result of " + inQuotes(text.substr(0, end));
}

std::string aboutBareList(std::string_view text) {
    constexpr std::size_t longest = 40;  // fits a terminal's line
    std::string_view list = text.substr(0, text.find_first_not_of("0123456789+-.eE, \t"));
    list = list.substr(0, list.find_last_not_of(", \t") + 1);
    const std::string write = list.size() > longest ? "" : ": write [" + std::string(list) + "]";
    return "a list stands in [ and ]" + write;
}

// "% sun", "; sun", but not "40 % 3", and not "1; 2" for "1, 2".
static bool isCommentBySign(std::string_view text) {
    if (text.empty() || (text[0] != '%' && text[0] != ';')) return false;
    const std::size_t word = text.find_first_not_of(text[0] == '%' ? "% \t" : "; \t");
    return word != text.npos && std::isalpha(static_cast<unsigned char>(text[word]));
}

std::string aboutForeign(std::string_view text) {
    const bool isDashes = text.starts_with("--") && !isDigitAt(text, 2) && !text.substr(2).starts_with('.');
    if (isDashes || text.starts_with("//") || text.starts_with("/*") || text.starts_with('#') ||
        isCommentBySign(text) || text.starts_with("<!--"))
        return "a comment, which JSON does not have: delete it";
    const bool isPng = text.starts_with("\x89PNG");  // no text at all
    if (!text.empty() && !isPng && utf8Bytes(text) == 0)
        return "a byte that is no UTF-8: save the file as UTF-8";
    const unsigned code = invisible(text);
    return code == 0 ? "" : formatted("an invisible character (U+%04X): delete it", code);
}

// "1,000" may be a thousand, "0,125" may not.
std::string aboutComma(const std::string& whole, const std::string& fraction) {
    const bool isThousand = fraction.size() == 3 && whole.find_first_not_of("-0") != whole.npos;
    const std::string number = whole + "." + fraction;
    return isThousand ? "a number has no comma: write " + whole + fraction + ", or " + number
                      : "a number has a decimal point: write " + number;
}

std::string withoutZeros(const std::string& number) {
    const std::size_t sign = number[0] == '-';
    const std::size_t first = std::min(number.find_first_not_of('0', sign), number.size() - 1);
    return number.substr(0, sign) + number.substr(first);
}

}  // namespace raytracer
