// What is wrong with a text's quotes, or between them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "syntax_mistake.h"

namespace raytracer {

// Of quotes other than JSON's, with which the text begins, or nothing.
std::string aboutOtherQuotes(std::string_view text);

// Why there is no text where one begins, and the parser has stopped in it.
SyntaxMistake stringMistake(const SyntaxState& state, std::size_t begin);

// Whether a text that the parser has read last, and behind which a word follows at once, took in what follows
// it, to the next text's beginning: "red, "color": 1
bool isSwallowing(const SyntaxState& state);

// Whether it ends where a quote was meant for a part of it: "the "red" one"
bool isQuoteInText(const SyntaxState& state);

}  // namespace raytracer
