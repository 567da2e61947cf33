// What a command's line may say. Only command_line.cpp knows CLI11.
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace raytracer::commands {

// The numbers that an option takes: from `least` to `most`, but not `least` itself where `open`.
struct Range {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    bool open = false;
};
constexpr Range atLeast(double least) { return {.least = least}; }
constexpr Range above(double least) { return {.least = least, .open = true}; }

// A name with dashes is an option. Any other is an argument: it must be given, in the order of the
// declarations. The variables must outlive `parse`, which fills them. Help is wrapped to 80 columns; it shows
// their values as the defaults.
class CommandLine {
  public:
    // The command as its user calls it, and what it does.
    CommandLine(const std::string& command, const std::string& purpose);
    ~CommandLine();

    void text(const char* name, std::string& value, const std::string& help);                 // not blank
    void texts(const char* name, std::vector<std::string>& values, const std::string& help);  // one or more
    void choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                const std::string& help);
    void flag(const char* name, bool& value, const std::string& help);

    // A decimal, finite number in the range; whole where Number is: int, std::uint64_t or double.
    template <class Number>
    void number(const char* name, Number& value, const Range& range, const std::string& help);
    template <class Number>
    void number(const char* name, std::optional<Number>& value, const Range& range, const std::string& help);

    // The option and any of the others, all declared before, can't be given together.
    void exclude(const char* option, std::initializer_list<const char*> others);

    // What the help ends with: lines of at most 80 columns.
    void footer(const char* text);

    // Where the process is to end with the command line, its exit status: 0 for --help, 2 for wrong usage, of
    // which a line on stderr says what was expected and what was found.
    std::optional<int> parse(int argc, char** argv);

  private:
    using Read = std::function<void(const std::string& text)>;
    CLI::Option& add(const char* name, const std::string& placeholder, const std::string& help, Read read);

    std::unique_ptr<CLI::App> app_;
};

}  // namespace raytracer::commands
