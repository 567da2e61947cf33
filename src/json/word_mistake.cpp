#include "word_mistake.h"

#include <algorithm>
#include <cctype>

#include "json_scan.h"
#include "number_mistake.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

bool isAnyOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

std::string_view withoutSign(std::string_view word) {
    return word.substr(word.starts_with('-') || word.starts_with('+'));
}

bool isConstant(std::string_view word) {
    return isAnyOf(inLowerCase(word),
                   {"pi", "tau", "e", "m_pi", "math.pi", "np.pi", "numpy.pi", "std::numbers::pi", "\u03c0"});
}

// "true" or "false" if the word means that or is spelt like it; else empty.
std::string truth(const std::string& lower) {
    if (isAnyOf(lower, {"yes", "on"})) return "true";
    if (isAnyOf(lower, {"no", "off"})) return "false";
    NearestName nearest(lower);
    nearest.consider("true");
    nearest.consider("false");
    return nearest.found() ? nearest.name() : "";
}

// The number behind a long dash; empty if the word is anything else.
std::string_view behindDash(std::string_view word) {
    const std::string_view number = behindLongDash(word);
    return isNumber(number) && number[0] != '-' && number[0] != '+' ? number : "";
}

WordMistake aboutNumber(std::string_view word) {
    if (isNumber(word)) return {aboutNumberForm(word), asJsonNumber(word)};
    if (const Meant number = withoutThousands(word, true); number && number.size == word.size())
        return {"a number has no separator of thousands", number.json};
    if (const auto number = behindDash(word); !number.empty())
        return {"a minus is the sign -", "-" + asJsonNumber(number)};
    const bool isMeant = isDigitAt(word, 0) || isDigitAt(word, 1) || word == "-" ||
                         (word.starts_with("--") && isDigitAt(word, 2));
    return {isMeant ? "expected a number, found " + inQuotes(word) : ""};
}

}  // namespace

bool isPlainText(std::string_view word) {
    const auto isPlain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '/'; };
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) &&
           std::ranges::all_of(word, isPlain);
}

std::string hexColor(std::string_view word) {
    const bool isHex =
        (word.size() == 4 || word.size() == 7) && word[0] == '#' &&
        std::ranges::all_of(word.substr(1), [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (!isHex) return {};
    const std::size_t digits = word.size() / 3;  // of a channel
    double channels[3];
    for (std::size_t i = 0; i < 3; ++i) {
        std::string hex(word.substr(1 + i * digits, digits));
        if (digits == 1) hex += hex;
        channels[i] = std::stoi(hex, nullptr, 16) / 255.0;
    }
    return formatted("[%.3g, %.3g, %.3g]", channels[0], channels[1], channels[2]);
}

WordMistake aboutWord(std::string_view word) {
    const std::string lower = inLowerCase(word), text = inQuotes(word),
                      found = "expected a value, found " + text;
    if (isAnyOf(lower, {"true", "false"}))
        return {"expected " + lower + ", found " + text + ": small letters"};
    if (isAnyOf(lower, {"null", "none", "nil", "undefined"}))
        return {found + ": leave out a key that has none"};
    if (isAnyOf(withoutSign(lower), {"nan", "inf", "infinity"}))
        return {"expected a finite number, found " + text};
    if (isConstant(withoutSign(word))) return {"JSON has no constants: write the number for " + text};
    if (WordMistake about = aboutNumber(word); !about.why.empty()) return about;
    if (const std::string likely = truth(lower); !likely.empty())
        return {found, likely, ", or a text in double quotes"};
    return {found, isPlainText(word) ? jsonString(word) : "", " if it is a text"};
}

bool isFormula(std::string_view word) {
    word = withoutSign(word);
    const std::size_t sign = word.find_first_of("(+-*/^");
    return sign != word.npos && sign > 0 && (word[sign] == '(' || isConstant(word.substr(0, sign)));
}

std::string aboutCalculation(std::string_view text) {
    std::size_t end = 0;
    int depth = 0;
    outsideTexts(text, 0, [&](std::size_t at) {
        const auto isAt = [&](std::string_view set) { return set.find(text[at]) != set.npos; };
        if (isAt(depth > 0 ? "\r\n" : ",]}\r\n")) return false;
        depth += isAt("([") - isAt(")]");
        end = at + 1;
        return true;
    });
    end = text.find_last_not_of(" \t", end - 1) + 1;
    constexpr std::size_t longest = 40;  // fits a terminal's line
    const std::string shown = inQuotes(text.substr(0, end));
    return "JSON does not calculate: write the result" + (shown.size() > longest ? "" : " of " + shown);
}

}  // namespace raytracer
