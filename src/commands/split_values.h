// Recognises values of options that their author, or a shell, has split into several words: "--crop 0, 0, 5,
// 5". A Word::Rejoin puts them together, as the value is written in a shell. Its result is empty if the value
// is complete already, or if the words behind it are not parts of it.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "command_line.h"

namespace raytracer::commands {

// The form of an option's list.
struct ListForm {
    const char* inWords;          // for the message: "has commas, no blanks"
    std::string_view separators;  // characters that may separate parts
    const char* between;          // the right separator
    std::size_t least, most;      // number of parts
    std::function<bool(const std::string&)> isPart;
};
Word::Rejoin rejoinedList(const ListForm& form);

using Behind = std::span<const std::string>;

// Restores "/pointer=value" from "/pointer" "=" "[0," "1]", and from "/pointer=0" "/pointer=1", into which a
// shell expands braces.
Word::Whole joinedEdit(const std::string& text, Behind behind);

}  // namespace raytracer::commands
