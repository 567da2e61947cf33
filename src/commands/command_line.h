// What a command's line may say, what it says wrong, and its help.
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "number_argument.h"

namespace raytracer::commands {

// What an argument is, as far as its text shows that: so that arguments in a wrong order are recognised.
enum class ArgumentKind { Any, Scene, Picture, Number, Folder };

// An option or an argument, as it was declared.
struct Word {
    using Read = std::function<void(const std::string& text)>;
    // An option's value of which its text and some words behind it are parts; empty where they are not.
    using Rejoin = std::function<std::string(const std::string& text, std::span<const std::string> behind)>;

    std::string name;                       // "--samples", or an argument: "SCENE"
    std::string placeholder;                // of the value: "N=3"; empty: a flag
    std::string expected;                   // the value in words: "a whole number from 1 to 65536"
    std::string help;                       // one paragraph
    Read read;                              // takes a text, or throws WrongUsage
    ArgumentKind kind = ArgumentKind::Any;  // of the text
    std::vector<std::string> choices{};     // all that the text may be, where it is one of few
    bool isMany = false;                    // may be repeated
    Rejoin rejoin{};
    const char* form = "";  // what is said where `rejoin` finds a value: "has commas, no blanks"

    bool isOption() const { return name.starts_with("--"); }
    bool isFlag() const { return placeholder.empty(); }
};

// A name with dashes is an option. Any other is an argument: it must be given, in the order of the
// declarations. The variables must outlive `parse`, which fills them; of a repeated option, with the last
// value. Help is wrapped to 80 columns; it shows the variables' values as the defaults.
class CommandLine {
  public:
    // The command as its user calls it, and what it does.
    CommandLine(const std::string& command, const std::string& purpose);

    void text(const char* name, std::string& value, const std::string& help,
              ArgumentKind kind = ArgumentKind::Any);  // not blank
    void output(const char* name, std::string& value, const std::string& help,
                ArgumentKind kind = ArgumentKind::Any);  // the name of what is written, which is not "-"
    void texts(const char* name, std::vector<std::string>& values, const std::string& help,
               ArgumentKind kind = ArgumentKind::Any);  // one or more
    void choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                const std::string& help);
    void names(const char* name, std::string& list, const std::vector<std::string>& choices,
               const std::string& help);  // comma-separated; whether they are known, the caller asks
    void flag(const char* name, bool& value, const std::string& help);
    void alone(const char* name, const std::string& help);  // run.cpp answers it before parse

    // A decimal, finite number in the range; whole where Number is: int, std::uint64_t or double.
    template <class Number>
    void number(const char* name, Number& value, const Range& range, const std::string& help);
    template <class Number>
    void number(const char* name, std::optional<Number>& value, const Range& range, const std::string& help);

    // The option and any of the others can't be given together.
    void exclude(const char* option, std::initializer_list<const char*> others);

    // The option has no effect without the other.
    void needs(const char* option, const char* other);

    // With the option, these arguments may be left out, all together: numbers in a std::optional.
    void spares(const char* option, std::initializer_list<const char*> arguments);

    // Where words behind the option are parts of its value, `form` says how that is written: "has commas".
    void rejoins(const char* option, const char* form, Word::Rejoin rejoin);

    // Options that other commands have and this one has not, for a reason.
    void lacks(std::initializer_list<const char*> options, const char* reason);

    // What the help ends with: lines of at most 80 columns.
    void footer(const char* text) { footer_ = text; }

    // Where the process is to end with the command line, its exit status: 0 for --help and --version, 2 for
    // wrong usage, of which a line on stderr says what was expected and what was found.
    std::optional<int> parse(int argc, char** argv);

    // Whether the option was given.
    bool given(std::string_view option) const;

    // The line for a shell, without some of its options.
    std::string again(std::initializer_list<std::string_view> without) const;

    std::string help() const;
    std::string manual() const;                              // a section of a man page, in roff
    std::string completion(const std::string& shell) const;  // what bash, zsh or fish is to know
    const std::string& command() const { return command_; }
    const std::string& purpose() const { return purpose_; }
    const std::string& footer() const { return footer_; }
    const std::vector<Word>& words() const { return words_; }
    std::string order() const;  // "SCENE IMAGE_OUT LONG_EDGE_PIXELS"

  private:
    // What a line gives to a word.
    struct Given {
        const Word* word;
        std::string text;
        std::size_t at = 0;  // how many words of `rest_` are before it
    };
    using Pair = std::pair<std::string, std::string>;
    struct Spared {
        std::string option;
        std::vector<std::string> arguments;
    };

    std::optional<std::string> document(const std::vector<std::string>& line) const;
    void add(Word word);
    void sort(const std::vector<std::string>& line);
    void takeOption(const std::vector<std::string>& line, std::size_t& at);
    void giveArguments();
    void requireTogether() const;

    const Word* find(std::string_view option) const;
    std::vector<const Word*> arguments() const;
    std::vector<const Word*> expectedArguments() const;
    [[noreturn]] void failUnknown(const std::string& option) const;
    std::string meantOption(std::string_view name) const;
    void requireOrder() const;
    void requireWholeValues() const;
    void requireNumbers(const std::vector<std::size_t>& places) const;

    std::string program_, command_, purpose_, footer_;
    std::vector<Word> words_;
    std::vector<Pair> excluded_, needed_, lacking_;
    std::vector<Spared> spared_;

    std::vector<Given> given_;
    std::vector<std::string> rest_;  // the line's words that are no options
};

}  // namespace raytracer::commands
