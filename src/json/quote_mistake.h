// Finds what is wrong with a string's quotes, or between them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "syntax_mistake.h"

namespace raytracer {

// What is wrong with the quote at the text's beginning, if it is not JSON's; else empty.
std::string aboutOtherQuotes(std::string_view text);

// Why the string that begins at `begin`, and in which the parser has stopped, is not valid.
SyntaxMistake stringMistake(const SyntaxState& state, std::size_t begin);

// Whether the string that was read last lacks its closing quote, so that it reaches to the opening quote of
// the next one: "red, "color": 1. A word must follow directly.
bool isSwallowing(const SyntaxState& state);

// Whether the string that was read last ends at a quote that was meant as a part of it: "the "red" one"
bool isQuoteInText(const SyntaxState& state);

}  // namespace raytracer
