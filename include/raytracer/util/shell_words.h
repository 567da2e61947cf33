// The words of a shell's command line (POSIX.1-2017, Shell Command Language, 2.2 and 2.3).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

struct ShellWord {
    enum Kind { Text, Operator, Redirection };

    std::size_t begin = 0, end = 0;  // where it is written
    std::string text{};              // without quotes
    Kind kind = Text;
    bool isPlain = true;        // the shell takes the text as it is
    bool quotesBraces = false;  // "{}" stands in quotes
};

// Up to a here-document.
std::vector<ShellWord> shellWords(std::string_view command);

}  // namespace raytracer
