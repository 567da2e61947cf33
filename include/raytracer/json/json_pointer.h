// JSON pointers (RFC 6901): "/camera/eye/0" names a value of a document.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "raytracer/json/json_document.h"

namespace raytracer {

// What a key or an index adds to a pointer: "/" and the text, with "~0" for "~" and "~1" for "/".
std::string pointerStep(std::string_view key);

// The key of a step without its "/".
std::string keyOf(std::string_view step);

// How far a pointer leads from a value: to the value `node`, and all the way where nothing is left of it.
// What is left begins with a step that this value does not have; it is a part of the pointer's own text.
struct PointerEnd {
    std::uint32_t node;
    std::string_view left;
};
PointerEnd follow(const JsonDocument& document, std::string_view pointer, std::uint32_t from = 0);

}  // namespace raytracer
