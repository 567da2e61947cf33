// The help of a command, from what it declares.
#include "command_line.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr std::size_t helpColumns = 80;  // what a terminal shows of a line
constexpr std::size_t nameColumns = 26;  // the left column: "  --max-recursion N=3" and blanks

std::string entry(const std::string& name, const std::string& help) {
    std::string left = "  " + name;
    left += left.size() + 1 > nameColumns ? "\n" + std::string(nameColumns, ' ')
                                          : std::string(nameColumns - left.size(), ' ');
    return left + wrapped(help, helpColumns, nameColumns, nameColumns) + "\n";
}

}  // namespace

std::string CommandLine::help() const {
    std::string arguments, options = entry("--help, -h", "Print this");
    options += entry("--version, -V", "Print the version, the instruction sets and the precisions");
    for (const Word& word : words_) {
        const std::string value = word.isFlag() ? "" : " " + word.placeholder;
        if (word.isOption()) options += entry(word.name + value, word.help);
        else arguments += entry(word.name + (word.isMany ? "..." : ""), word.help);
    }
    return purpose_ + "\n\nUsage: " + command_ + " [options] " + order() + "\n\n" + arguments +
           "\nOptions:\n" + options + "\n" + footer_ + "\n";
}

}  // namespace raytracer::commands
