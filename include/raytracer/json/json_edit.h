// Replaces and adds values in a JSON text before it is parsed (--set).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "raytracer/json/json_document.h"

namespace raytracer {

// The kind of JSON value that a text is, and why it is not JSON (without a place; empty if it is JSON). A
// text that is not JSON counts as a String. If all that is wrong is a number too large for a double, the kind
// is the value's own.
struct JsonReading {
    JsonDocument::Kind kind;
    std::string why{};
};
JsonReading readingOf(std::string_view text);

// "/pointer=value": a JSON pointer (RFC 6901) up to the first "=", and a value. A value that is not JSON is
// taken for a string.
struct JsonEdit {
    std::string pointer, value;

    // Throws Error if the pointer or the "=" is missing. A pointer
    // without its first "/" is left to edited(), which throws.
    explicit JsonEdit(const std::string& assignment);
};

struct EditedJson {
    std::string text;
    TextEdits edits;
};

// Applies the edits, one after the other, to the text of the file `path`, which must
// outlive the result. A pointer's last step may be a key that the object does not have,
// or "-", the place behind an array's last element: then the value is added. Throws
// Error if a pointer leads nowhere; the message proposes the nearest one that exists.
EditedJson edited(const std::string& path, std::string_view text, std::span<const std::string> assignments);

}  // namespace raytracer
