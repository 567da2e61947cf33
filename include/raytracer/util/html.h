// Parts of self-contained HTML pages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raytracer {

// Text, shown as printable (text.h) has it, as HTML or XML for between tags or for a quoted attribute.
std::string escaped(std::string_view text);

// ` NAME="VALUE"`, of HTML or XML.
std::string attribute(const char* name, std::string_view value);

// A page from its doctype to the opened body. `title` is escaped here, `style` is CSS.
std::string pageHead(std::string_view title, std::string_view style);

// RFC 4648, section 4.
std::string base64(std::span<const char> bytes);

// data:image/png;base64,...: for an attribute.
std::string pngUri(std::span<const char> png);

}  // namespace raytracer
