// Explains what a word that is not JSON was meant to be.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// Why a word is wrong, and the JSON to write instead (empty
// if not known). `more` is other advice, behind that.
struct WordMistake {
    std::string why, instead{}, more{};
};

// Whether the word may be a name, also of a file.
bool isPlainText(std::string_view word);

// Why the word is not a value. It must not be empty.
WordMistake aboutWord(std::string_view word);

// A colour as other programs write it, #fff or #ff8000, as a list: "[1, 1, 1]". Empty for any other word.
std::string hexColor(std::string_view word);

// Whether a calculation begins with the word: sqrt(2), -pi/2.
bool isFormula(std::string_view word);

// The message about a calculation at the text's beginning. It ends where a value would in JSON, but may have
// commas in brackets.
std::string aboutCalculation(std::string_view text);

}  // namespace raytracer
