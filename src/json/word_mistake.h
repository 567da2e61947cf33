// What a word that is no JSON was meant to be.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// Why, and the JSON that may stand instead of the word; empty where that is not known. `more`: what else may.
struct WordMistake {
    std::string why, instead{}, more{};
};

// A name, of a file too.
bool isPlainText(std::string_view word);

// Why the word, which is not empty, is no value.
WordMistake aboutWord(std::string_view word);

// #fff, #ff8000: as other programs write colors. "[1, 1, 1]", or nothing for another word.
std::string hexColor(std::string_view word);

// Whether a calculation begins with the word: sqrt(2), -pi/2.
bool isFormula(std::string_view word);

// Of a calculation with which the text begins; it goes on to where JSON would, but for commas in brackets.
std::string aboutCalculation(std::string_view text);

}  // namespace raytracer
