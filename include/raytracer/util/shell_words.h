// Splits a shell's command line into words (POSIX.1-2017, Shell Command Language, 2.2 and 2.3).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

struct ShellWord {
    enum Kind { Text, Operator, Redirection };

    std::size_t begin = 0, end = 0;  // the word's place in the command, with its quotes
    std::string text{};              // the word without its quotes; ~/ is $HOME/
    Kind kind = Text;
    bool isPlain = true;        // the shell expands nothing in the text
    bool quotesBraces = false;  // the word has a "{}" in quotes
};

// The words up to the first here-document.
std::vector<ShellWord> shellWords(std::string_view command);

}  // namespace raytracer
