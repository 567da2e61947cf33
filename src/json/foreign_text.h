// Recognises text that has no place in JSON outside of strings.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// What is wrong with the text's beginning: a comment, a merge conflict, a byte that is no UTF-8, an invisible
// character. Empty if it is none of these.
std::string aboutForeign(std::string_view text);

// For a whole file that is not JSON: what it is instead, if that is certain; else empty.
std::string aboutFormat(std::string_view text);

}  // namespace raytracer
