// Values of options that their author, or a shell, has set apart: "--crop 0, 0, 5, 5". Each function takes an
// option's text and the words behind it that are no options, and gives the value whole and as it is written
// in a shell; empty where the text is whole already, or what is behind is no part of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "command_line.h"

namespace raytracer::commands {

using Behind = std::span<const std::string>;

Word::Whole joinedTerms(const std::string& text, Behind behind, const std::vector<std::string>& terms);
Word::Whole joinedCrop(const std::string& text, Behind behind);
Word::Whole joinedPart(const std::string& text, Behind behind);
Word::Whole joinedFrames(const std::string& text, Behind behind);

// "/pointer=value" of "/pointer" "=" "[0," "1]", and of "/pointer=0" "/pointer=1", which a shell makes of
// braces.
Word::Whole joinedEdit(const std::string& text, Behind behind);

}  // namespace raytracer::commands
