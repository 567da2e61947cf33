// The words of a shell's command line (POSIX.1-2017, Shell Command Language, 2.2, 2.3 and 2.9.1).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// Wrapped is the command that another one starts: p in "timeout 8 p". Script is the file that an interpreter
// is given: s in "python3 -u s"; behind an option a word may be that one's value instead.
enum class ShellRole {
    Operator,
    Redirection,
    Target,
    Assignment,
    Keyword,
    Command,
    Wrapped,
    Option,
    Script,
    Argument
};

struct ShellWord {
    std::size_t begin = 0, end = 0;  // where it is written
    std::string text{};              // without quotes
    bool isPlain = true;             // the shell takes the text as it is
    bool isQuoted = false;           // in part
    ShellRole role = ShellRole::Argument;
};

// Up to a here-document.
std::vector<ShellWord> shellWords(std::string_view command);

// Whether "{}" stands in quotes somewhere.
bool hasQuotedBraces(std::string_view command);

}  // namespace raytracer
