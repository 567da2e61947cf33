// What a word that is no JSON was meant to be.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

bool isDigitAt(std::string_view text, std::size_t at);

// Why the word, which is not empty, is no value.
std::string aboutWord(std::string_view word);

// Whether a calculation begins with the word: sqrt(2), -pi/2.
bool isFormula(std::string_view word);

// What JSON has nowhere outside of its texts, and the text begins with: a comment, a character that nobody
// sees. Empty where that may stand.
std::string aboutForeign(std::string_view text);

// "a number has no comma ...", of what stands on both sides of it.
std::string aboutComma(const std::string& whole, const std::string& fraction);

// Of a number with zeros in front.
std::string withoutZeros(const std::string& number);

}  // namespace raytracer
