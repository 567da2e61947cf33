// Values of options that their author, or a shell, has set apart: "--crop 0, 0, 5, 5". What a Word::Rejoin
// makes of them is whole, and as it is written in a shell; empty where the text is whole already, or what is
// behind is no part of it.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "command_line.h"

namespace raytracer::commands {

// How an option's list is written.
struct ListForm {
    const char* inWords;
    std::string_view separators;  // characters
    const char* between;          // its parts, as the list is written
    std::size_t least, most;      // parts
    std::function<bool(const std::string&)> isPart;
};
Word::Rejoin rejoinedList(const ListForm& form);

using Behind = std::span<const std::string>;

// "/pointer=value" of "/pointer" "=" "[0," "1]", and of "/pointer=0" "/pointer=1", which a shell makes of
// braces.
Word::Whole joinedEdit(const std::string& text, Behind behind);

}  // namespace raytracer::commands
