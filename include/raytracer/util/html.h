// Parts of self-contained HTML pages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raytracer {

// Text for HTML or XML, between tags or in a quoted attribute. What cannot be shown is escaped as by
// printable (text.h).
std::string escaped(std::string_view text);

// ` NAME="VALUE"`, for HTML or XML.
std::string attribute(const char* name, std::string_view value);

// A page from its doctype to the opening tag of its body. `title` is escaped here; `style` is CSS.
std::string pageHead(std::string_view title, std::string_view style);

// RFC 4648, section 4.
std::string base64(std::span<const char> bytes);

// "data:image/png;base64,...", for an attribute.
std::string pngUri(std::span<const char> png);

}  // namespace raytracer
