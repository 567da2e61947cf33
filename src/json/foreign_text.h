// What JSON has nowhere outside of its texts.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// Of a comment, a character that nobody sees, a conflict of versions, with which the text begins. Empty where
// that may stand.
std::string aboutForeign(std::string_view text);

// Of a whole file that is no JSON: what it is, where that is sure.
std::string aboutFormat(std::string_view text);

}  // namespace raytracer
