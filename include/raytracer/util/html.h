// What self-contained pages are made of.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raytracer {

// Text for between tags or for an attribute in double quotes.
std::string escaped(std::string_view text);

// RFC 4648, section 4.
std::string base64(std::span<const char> bytes);

// data:image/png;base64,...: for an attribute.
std::string pngUri(std::span<const char> png);

}  // namespace raytracer
