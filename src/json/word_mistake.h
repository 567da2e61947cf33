// What a word that is no JSON was meant to be.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

bool isDigitAt(std::string_view text, std::size_t at);

// #fff, #ff8000: as other programs write colors.
bool isHexColor(std::string_view word);
std::string aboutHexColor(std::string_view color);

// Why the word, which is not empty, is no value.
std::string aboutWord(std::string_view word);

// Whether the word is a unit, which numbers do not have here.
bool isUnit(std::string_view word);

// Whether a calculation begins with the word: sqrt(2), -pi/2.
bool isFormula(std::string_view word);

// Of a calculation with which the text begins; it goes on to where JSON would, but for commas in brackets.
std::string aboutCalculation(std::string_view text);

// Of numbers with commas between them that lack their brackets: 0, 1, 4
std::string aboutBareList(std::string_view text);

// What JSON has nowhere outside of its texts, and the text begins with: a comment, a character that nobody
// sees. Empty where that may stand.
std::string aboutForeign(std::string_view text);

// "a number has no comma ...", of what stands on both sides of it.
std::string aboutComma(const std::string& whole, const std::string& fraction);

// Of a number with zeros in front.
std::string withoutZeros(const std::string& number);

}  // namespace raytracer
