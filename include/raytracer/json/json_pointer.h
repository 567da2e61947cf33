// JSON pointers (RFC 6901): "/camera/eye/0" names a value of a document.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "raytracer/json/json_document.h"

namespace raytracer {

// The step of a pointer for a key or an index: "/" and the text, with "~0" for "~" and "~1" for "/".
std::string pointerStep(std::string_view key);

// The step as a message shows it: a key that is too long for a line is shortened, in quotes.
std::string shownStep(std::string_view key);

// The key that a step stands for. The step is given without its "/".
std::string keyOf(std::string_view step);

// How far a pointer leads from a value: to the value `node`. `left` is the rest of the pointer, a part of its
// own text. It is empty if the pointer was followed to its end; else it begins with a step that `node` lacks.
struct PointerEnd {
    std::uint32_t node;
    std::string_view left;
};
PointerEnd follow(const JsonDocument& document, std::string_view pointer, std::uint32_t from = 0);

}  // namespace raytracer
