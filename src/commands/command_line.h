// Declares a command's options and arguments, parses its command line, explains mistakes and makes its help.
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

// An error in the command line. run() puts the command's name before the message.
struct UsageError : Error {
    using Error::Error;
};

inline constexpr const char* seeHelp = " (see --help)";

// Throws UsageError: "--samples: expected a number, found nothing".
[[noreturn]] void refuse(const std::string& name, const std::string& expected, const std::string& found);

// The numbers that an option takes: from `least` to `most`; without `least` itself if `open`.
struct Range {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    bool open = false;

    bool has(double number) const { return number >= least && number <= most && !(open && number == least); }
};
constexpr Range atLeast(double least) { return {.least = least}; }
constexpr Range above(double least) { return {.least = least, .open = true}; }

constexpr std::string_view shells[] = {"bash", "zsh", "fish"};  // those of --print-completion

// What an argument is, as far as its text shows that. Arguments in a wrong order are recognised by it.
enum class ArgumentKind { Any, Scene, Picture, Number, Folder };

// The declaration of an option or an argument.
struct Word {
    using Read = std::function<void(const std::string& text)>;
    // A value that was split into several words, put together again: what is wrong with it ("has commas, no
    // blanks") and the whole value ("0,0,5,5"). `value` is empty if the value was not split.
    struct Whole {
        const char* form = "";
        std::string value;
    };
    // Gets an option's text, and the words behind it that are not options.
    using Rejoin = std::function<Whole(const std::string& text, std::span<const std::string> behind)>;

    std::string name;                       // "--samples", or an argument: "SCENE"
    std::string help;                       // one paragraph
    Read read{};                            // stores the value of a text, or throws UsageError
    std::string placeholder{};              // for the value: "N"; empty: a flag
    std::string usual{};                    // the default value
    std::string expected{};                 // the value in words: "a whole number from 1 to 65536"
    ArgumentKind kind = ArgumentKind::Any;  // kind of the text
    std::vector<std::string> choices{};     // the possible texts, if they are few; else empty
    bool isMany = false;                    // whether it may be repeated
    bool isText = false;                    // whether it is a text, which must not be blank
    Rejoin rejoin{};

    bool isOption() const { return name.starts_with("--"); }
    bool isFlag() const { return placeholder.empty(); }
    std::string shown() const { return placeholder + (usual.empty() ? "" : "=" + usual); }  // "N=3"
};

// A name with dashes declares an option. Any other declares an argument: arguments must be given, in the
// order of their declarations. parse() fills the variables, which must outlive it; of a repeated option the
// last value counts. The help is wrapped to 80 columns; it shows the variables' values as the defaults.
class CommandLine {
  public:
    // The command's name, which may be empty, and what it does.
    CommandLine(const std::string& name, const std::string& purpose);

    void text(const char* name, std::string& value, const std::string& help,
              ArgumentKind kind = ArgumentKind::Any);  // must not be blank
    void output(const char* name, std::string& value, const std::string& help,
                ArgumentKind kind = ArgumentKind::Any);  // the name of an output file, which must not be "-"
    void texts(const char* name, std::vector<std::string>& values, const std::string& help,
               ArgumentKind kind = ArgumentKind::Any);  // one or more
    // `remedy` makes advice for a text that is none of the choices: "; write --only diffuse", or empty.
    using Remedy = std::function<std::string(const std::string& text)>;
    void choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                const std::string& help, const Remedy& remedy = {});
    void names(const char* name, std::string& list, const std::vector<std::string>& choices,
               const std::string& help);  // comma-separated; the caller checks them
    void flag(const char* name, bool& value, const std::string& help);
    void alone(const char* name, const std::string& help,
               const std::vector<std::string>& values = {});  // run.cpp answers it before parse()

    // Sets the placeholder that the help shows for the option's value ("K/N"), and what a message says is
    // expected (by default the placeholder).
    void shown(const char* option, const char* placeholder, const char* expected = nullptr);

    // A finite decimal number in the range; a whole number if Value is an integer. Value is int, double, or a
    // std::optional of int, double or std::uint64_t.
    template <class Value>
    void number(const char* name, Value& value, const Range& range, const std::string& help);

    // The option cannot be given together with any of the others.
    void exclude(const char* option, std::initializer_list<const char*> others);

    // The option has no effect without the other.
    void needs(const char* option, const char* other);

    // If the option is given, all of these arguments together
    // may be left out. Their variables are std::optional.
    void spares(const char* option, std::initializer_list<const char*> arguments);

    // Words behind the option may be parts of its value: `rejoin` puts them together for the message.
    void rejoins(const char* option, Word::Rejoin rejoin);

    // Makes the message about arguments that are too many,
    // too few or in a wrong order; empty: the usual message.
    using Answer = std::function<std::string(std::span<const std::string> arguments)>;
    void answers(Answer answer) { answer_ = std::move(answer); }

    // Options that other commands have and this one lacks, with the reason for the message.
    void lacks(std::initializer_list<const char*> options, const char* reason);

    // Sets the end of the help: lines of at most 80 columns.
    void footer(const char* text) { footer_ = text; }

    // Returns true if the line asks for --help or --version, after printing the answer. Throws UsageError,
    // which says what was expected and what was found.
    bool parse(int argc, char** argv);

    // Whether the option was given.
    bool given(std::string_view option) const;

    // The command line, quoted for a shell, without some of its options.
    std::string again(std::initializer_list<std::string_view> without) const;

    std::string help() const;
    std::string manual() const;                              // a section of a man page, in roff
    std::string completion(const std::string& shell) const;  // the script for bash, zsh or fish
    const std::string& name() const { return name_; }
    const std::string& purpose() const { return purpose_; }
    const std::string& footer() const { return footer_; }
    const std::vector<Word>& words() const { return words_; }
    std::string order() const;  // "SCENE IMAGE_OUT LONG_EDGE_PIXELS"

  private:
    // The text that a line has for a declared word.
    struct Given {
        const Word* word;
        std::string text;
        std::size_t at = 0;  // how many words of `rest_` come before it
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
    std::string command_;  // as the user calls it: "raytracer compare"
    std::vector<Word> words_;
    std::vector<Pair> excluded_, needed_, lacking_;
    std::string sparing_;
    std::vector<std::string> spared_;
    Answer answer_;

    std::vector<Given> given_;
    std::vector<std::string> rest_;  // the line's words that are not options
};

}  // namespace raytracer::commands
