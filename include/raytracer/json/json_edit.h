// Values of a JSON text, replaced or added before it is read.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/json/json_document.h"

namespace raytracer {

// What a text is, read as JSON: a string where it is none, but for a number that no double can hold, which
// keeps its kind. `why`: what is wrong, without its place; empty for JSON.
struct JsonReading {
    JsonDocument::Kind kind;
    std::string why{};
};
JsonReading readingOf(std::string_view text);

// "/pointer=value": a JSON pointer (RFC 6901) up to the first "=", and JSON; what is no JSON is a string.
struct JsonEdit {
    std::string pointer, value;

    // Throws Error where there is no pointer or no "="; edited() does for a pointer without its first "/".
    explicit JsonEdit(const std::string& assignment);
};

struct EditedJson {
    std::string text;
    TextEdits edits;
};

// The text of the file `path` with other values, one edit after the other; the text must outlive it. A
// pointer's last step may be a key that its object does not have, or "-", behind the last element of its
// array: then the value is added. Throws Error where a pointer leads nowhere, with the nearest pointer that
// the text has.
EditedJson edited(const std::string& path, std::string_view text, std::span<const std::string> assignments);

}  // namespace raytracer
