// Values of a JSON text, replaced before it is read.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// "/pointer=value": a JSON pointer (RFC 6901) up to the first "=", and JSON; what is no JSON is a string.
struct JsonEdit {
    std::string pointer, value;

    // Throws Error where there is no pointer or no "=".
    explicit JsonEdit(const std::string& assignment);
};

// The text of the file `path` with another value at the pointer. Throws Error where there is none, with the
// nearest pointer that the text has.
std::string edited(const std::string& path, std::string_view text, const JsonEdit& edit);

}  // namespace raytracer
