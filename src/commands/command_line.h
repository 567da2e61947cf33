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

#include "raytracer/util/error.h"

namespace raytracer::commands {

// About the command line. run() names the command before the message.
struct UsageError : Error {
    using Error::Error;
};

inline constexpr const char* seeHelp = " (see --help)";

// Throws UsageError: "--samples: expected a number, found nothing".
[[noreturn]] void refuse(const std::string& name, const std::string& expected, const std::string& found);

// The numbers that an option takes: from `least` to `most`, but not `least` itself where `open`.
struct Range {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    bool open = false;

    bool has(double number) const { return number >= least && number <= most && !(open && number == least); }
};
constexpr Range atLeast(double least) { return {.least = least}; }
constexpr Range above(double least) { return {.least = least, .open = true}; }

constexpr std::string_view shells[] = {"bash", "zsh", "fish"};  // that --print-completion knows

// What an argument is, as far as its text shows that: so that arguments in a wrong order are recognised.
enum class ArgumentKind { Any, Scene, Picture, Number, Folder };

// An option or an argument, as it was declared.
struct Word {
    using Read = std::function<void(const std::string& text)>;
    // A value that its author has written apart: "has commas, no blanks", "0,0,5,5". Empty where that is not
    // so.
    struct Whole {
        const char* form = "";
        std::string value;
    };
    // Of an option's text and the words behind it that are no options.
    using Rejoin = std::function<Whole(const std::string& text, std::span<const std::string> behind)>;

    std::string name;                       // "--samples", or an argument: "SCENE"
    std::string help;                       // one paragraph
    Read read{};                            // takes a text, or throws UsageError
    std::string placeholder{};              // of the value: "N"; empty: a flag
    std::string usual{};                    // the value, where none is given
    std::string expected{};                 // the value in words: "a whole number from 1 to 65536"
    ArgumentKind kind = ArgumentKind::Any;  // of the text
    std::vector<std::string> choices{};     // all that the text may be, where it is one of few
    bool isMany = false;                    // may be repeated
    bool isText = false;                    // which is not blank
    Rejoin rejoin{};

    bool isOption() const { return name.starts_with("--"); }
    bool isFlag() const { return placeholder.empty(); }
    std::string shown() const { return placeholder + (usual.empty() ? "" : "=" + usual); }  // "N=3"
};

// A name with dashes is an option. Any other is an argument: it must be given, in the order of the
// declarations. The variables must outlive `parse`, which fills them; of a repeated option, with the last
// value. Help is wrapped to 80 columns; it shows the variables' values as the defaults.
class CommandLine {
  public:
    // The command's name, which may be empty, and what it does.
    CommandLine(const std::string& name, const std::string& purpose);

    void text(const char* name, std::string& value, const std::string& help,
              ArgumentKind kind = ArgumentKind::Any);  // not blank
    void output(const char* name, std::string& value, const std::string& help,
                ArgumentKind kind = ArgumentKind::Any);  // the name of what is written, which is not "-"
    void texts(const char* name, std::vector<std::string>& values, const std::string& help,
               ArgumentKind kind = ArgumentKind::Any);  // one or more
    // `remedy`: what to write for a text that is none of them, "; write --only diffuse", or nothing.
    using Remedy = std::function<std::string(const std::string& text)>;
    void choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                const std::string& help, const Remedy& remedy = {});
    void names(const char* name, std::string& list, const std::vector<std::string>& choices,
               const std::string& help);  // comma-separated; whether they are known, the caller asks
    void flag(const char* name, bool& value, const std::string& help);
    void alone(const char* name, const std::string& help,
               const std::vector<std::string>& values = {});  // run.cpp answers it before parse

    // How the help shows the option's value, and what is said where it is not there: "K/N".
    void shown(const char* option, const char* placeholder, const char* expected = nullptr);

    // A decimal, finite number in the range; whole where Value is. Value: int, std::uint64_t or
    // double, or a std::optional of one.
    template <class Value>
    void number(const char* name, Value& value, const Range& range, const std::string& help);

    // The option and any of the others can't be given together.
    void exclude(const char* option, std::initializer_list<const char*> others);

    // The option has no effect without the other.
    void needs(const char* option, const char* other);

    // With the option, these arguments may be left out, all together: numbers in a std::optional.
    void spares(const char* option, std::initializer_list<const char*> arguments);

    // Words behind the option may be parts of its value.
    void rejoins(const char* option, Word::Rejoin rejoin);

    // What is said of arguments that are too many, too few or in another order; empty: what fits any command.
    using Answer = std::function<std::string(std::span<const std::string> arguments)>;
    void answers(Answer answer) { answer_ = std::move(answer); }

    // Options that other commands have and this one has not, for a reason.
    void lacks(std::initializer_list<const char*> options, const char* reason);

    // What the help ends with: lines of at most 80 columns.
    void footer(const char* text) { footer_ = text; }

    // True where the line asks for --help or --version, which is printed. Throws UsageError, which says what
    // was expected and what was found.
    bool parse(int argc, char** argv);

    // Whether the option was given.
    bool given(std::string_view option) const;

    // The line for a shell, without some of its options.
    std::string again(std::initializer_list<std::string_view> without) const;

    std::string help() const;
    std::string manual() const;                              // a section of a man page, in roff
    std::string completion(const std::string& shell) const;  // what bash, zsh or fish is to know
    const std::string& name() const { return name_; }
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

    std::optional<std::string> document(const std::vector<std::string>& line) const;
    void sort(const std::vector<std::string>& line);
    void takeOption(const std::vector<std::string>& line, std::size_t& at);
    void giveArguments();
    void requireTogether() const;
    bool answered(const std::vector<std::string>& line) const;
    std::string lateCommand(const std::vector<std::string>& line) const;

    const Word* find(std::string_view option) const;
    std::vector<const Word*> arguments() const;
    std::vector<const Word*> expectedArguments() const;
    [[noreturn]] void failUnknown(const std::string& option) const;
    std::string meantOption(std::string_view name) const;
    void requireOrder() const;
    void requireWholeValues() const;
    void requireKinds() const;
    void requireDashes() const;
    void requireNumbers(const std::vector<std::size_t>& places,
                        const std::vector<const Word*>& expected) const;

    std::string program_, name_, purpose_, footer_;
    std::string command_;  // as its user calls it
    std::vector<Word> words_;
    std::vector<Pair> excluded_, needed_, lacking_;
    std::string sparing_;
    std::vector<std::string> spared_;
    Answer answer_;

    std::vector<Given> given_;
    std::vector<std::string> rest_;  // the line's words that are no options
};

}  // namespace raytracer::commands
