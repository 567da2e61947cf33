// Explains why a text is not JSON, in terms of what its author meant.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/json/json_document.h"

namespace raytracer {

// The last event that the parser reported, and where it stopped.
enum class JsonEvent { None, Value, Key, Open, Close };

struct SyntaxState {
    std::string_view text;
    JsonEvent last = JsonEvent::None;
    std::size_t begin = 0;    // where the last event begins in the text
    std::size_t end = 0;      // where it ends
    std::size_t stopped = 0;  // the character, or the end of the text, at which the parser stopped
    char container = 0;       // the innermost open bracket: '{', '[', or 0 for none
    std::size_t opening = 0;  // where that bracket is
};

// If the message proposes to replace `range` of the text, `instead` is the replacement, which is JSON.
struct SyntaxMistake {
    std::size_t offset;  // of the wrong character
    std::string message;
    TextRange range{};
    std::string instead{};
};
SyntaxMistake syntaxMistake(const SyntaxState& state);

}  // namespace raytracer
