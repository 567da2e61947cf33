// Why a text is no JSON, in the words of who wrote it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/json/json_document.h"

namespace raytracer {

// How far a parser came: the last event that it reported.
enum class JsonEvent { None, Value, Key, Open, Close };

struct SyntaxState {
    std::string_view text;
    JsonEvent last = JsonEvent::None;
    std::size_t begin = 0;    // where what was reported last begins
    std::size_t end = 0;      // and ends
    std::size_t stopped = 0;  // the character, or the end of the text, at which the parser stopped
    char container = 0;       // the innermost that is open: '{', '[' or 0
    std::size_t opening = 0;  // where that stands
};

// Where the message proposes other text for a range, `instead` is that: with it, the place is JSON.
struct SyntaxMistake {
    std::size_t offset;  // of the character to blame
    std::string message;
    TextRange range{};
    std::string instead{};
};
SyntaxMistake syntaxMistake(const SyntaxState& state);

}  // namespace raytracer
