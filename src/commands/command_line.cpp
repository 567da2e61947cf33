#include "command_line.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "arguments.h"
#include "raytracer/json/json_document.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

std::string helpWithRange(const std::string& help, const Range& range) {
    const std::string words = inWords(range);
    return words.empty() ? help : help + " (" + words.substr(1) + ")";
}

// A list that is too long for a line is in the help.
std::string expectedOf(const std::vector<std::string>& choices) {
    constexpr std::size_t longest = 60;
    const std::string list = listed(choices);
    return list.size() <= longest ? list : "a name in --help";
}

// Of a text that is none of the choices. Where the line, which begins with the command, has no room for all,
// the one that differs in its case alone is told, or else all choices.
[[noreturn]] void refuseChoice(const std::string& command, const char* name, const std::string& text,
                               const std::vector<std::string>& choices, const std::string& remedy) {
    NearestName nearest(text);
    for (const std::string& choice : choices) nearest.consider(choice);
    const std::string expected = expectedOf(choices), found = inQuotes(text);
    const std::string hint = remedy.empty() ? nearest.question() : remedy;
    const std::string line = command + ": " + name + ": expected " + expected + ", found " + found + hint;
    if (line.size() <= messageColumns) refuse(name, expected, found + hint);
    const bool isSame = nearest.found() && inLowerCase(nearest.name()) == inLowerCase(text);
    refuse(name, isSame ? nearest.name() : expected, found);
}

template <class Number>
constexpr const char* placeholderOf = std::is_integral_v<Number> ? "N" : "NUMBER";

std::string withDefault(const std::string& placeholder, const std::string& value) {
    return value.empty() ? placeholder : placeholder + "=" + value;
}

WrongUsage joinedWords(const std::string& option, const char* between, const std::string& other,
                       const char* end = "") {
    return {option + between + other + end};
}

// "-" is the name of a file, and -1 a number.
bool looksLikeOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && !numberOf<double>(word);
}

}  // namespace

CommandLine::CommandLine(const std::string& command, const std::string& purpose)
    : command_(command), purpose_(purpose) {
    // parse answers these, wherever they stand.
    add({"--help", "", "", "Print this; or -h", {}});
    add({"--version", "", "", "Print the version, the instruction sets and the precisions; or -V", {}});
}

void CommandLine::add(Word word) { words_.push_back(std::move(word)); }

void CommandLine::text(const char* name, std::string& value, const std::string& help, ArgumentKind kind) {
    const auto read = [&value](const std::string& text) { value = text; };
    add({name,
         withDefault(kind == ArgumentKind::Folder ? "FOLDER" : "TEXT", value),
         kind == ArgumentKind::Folder ? "a folder" : "a text",
         help,
         read,
         kind,
         {},
         false,
         true});
}

void CommandLine::output(const char* name, std::string& value, const std::string& help, ArgumentKind kind) {
    text(name, value, help, kind);
    if (kind != ArgumentKind::Folder) shown(name, "FILE", "a name");
    words_.back().read = [=, take = words_.back().read](const std::string& text) {
        if (text == "-") refuse(name, "a name", inQuotes(text) + ": only a render writes to stdout");
        take(text);
    };
}

void CommandLine::texts(const char* name, std::vector<std::string>& values, const std::string& help,
                        ArgumentKind kind) {
    const auto read = [&values](const std::string& text) { values.push_back(text); };
    add({name, "TEXT", "a text", help, read, kind, {}, true, true});
}

void CommandLine::choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                         const std::string& help, const Remedy& remedy) {
    const auto read = [=, command = command_, &value](const std::string& text) {
        if (std::ranges::find(choices, text) == choices.end())
            refuseChoice(command, name, text, choices, remedy ? remedy(text) : "");
        value = text;
    };
    add({name, withDefault("NAME", value), expectedOf(choices), help, read, ArgumentKind::Any, choices});
}

void CommandLine::names(const char* name, std::string& list, const std::vector<std::string>& choices,
                        const std::string& help) {
    text(name, list, help);
    words_.back().choices = choices;
}

void CommandLine::flag(const char* name, bool& value, const std::string& help) {
    add({name, "", "", help, [&value](const std::string&) { value = true; }});
}

void CommandLine::alone(const char* name, const std::string& help, const std::vector<std::string>& values) {
    add({name, values.empty() ? "" : "NAME", listed(values), help, {}, ArgumentKind::Any, values});
}

void CommandLine::shown(const char* option, const char* placeholder, const char* expected) {
    Word& word = *std::ranges::find(words_, option, &Word::name);
    word.placeholder = placeholder;
    word.expected = expected ? expected : placeholder;
}

template <class Number>
void CommandLine::number(const char* name, Number& value, const Range& range, const std::string& help) {
    const std::string usual = formatted("%.6g", static_cast<double>(value));
    add({name, withDefault(placeholderOf<Number>, usual), expectedNumber<Number>(range),
         helpWithRange(help, range),
         [=, &value](const std::string& text) { value = numberIn<Number>(name, text, range); },
         ArgumentKind::Number});
}

template <class Number>
void CommandLine::number(const char* name, std::optional<Number>& value, const Range& range,
                         const std::string& help) {
    add({name, placeholderOf<Number>, expectedNumber<Number>(range), helpWithRange(help, range),
         [=, &value](const std::string& text) { value = numberIn<Number>(name, text, range); },
         ArgumentKind::Number});
}

template void CommandLine::number(const char*, int&, const Range&, const std::string&);
template void CommandLine::number(const char*, double&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<int>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<double>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<std::uint64_t>&, const Range&,
                                  const std::string&);

void CommandLine::exclude(const char* option, std::initializer_list<const char*> others) {
    for (const char* other : others) excluded_.emplace_back(option, other);
}

void CommandLine::needs(const char* option, const char* other) { needed_.emplace_back(option, other); }

void CommandLine::spares(const char* option, std::initializer_list<const char*> arguments) {
    spared_.push_back({option, {arguments.begin(), arguments.end()}});
}

void CommandLine::rejoins(const char* option, Word::Rejoin rejoin) {
    std::ranges::find(words_, option, &Word::name)->rejoin = std::move(rejoin);
}

void CommandLine::lacks(std::initializer_list<const char*> options, const char* reason) {
    for (const char* option : options) lacking_.emplace_back(option, reason);
}

const Word* CommandLine::find(std::string_view option) const {
    if (option == "-h") option = "--help";
    if (option == "-V") option = "--version";
    const auto found = std::ranges::find(words_, option, &Word::name);
    return found != words_.end() && found->isOption() ? &*found : nullptr;
}

bool CommandLine::given(std::string_view option) const {
    return std::ranges::any_of(given_, [&](const Given& one) { return one.word->name == option; });
}

std::string CommandLine::again(std::initializer_list<std::string_view> without) const {
    std::string line = inShellQuotes(program_);
    for (const auto& [word, text, at] : given_) {
        if (std::ranges::find(without, word->name) != without.end()) continue;
        if (word->isOption()) line += " " + word->name;
        const bool isLikeOption = !word->isOption() && looksLikeOption(text);  // it was behind "--"
        if (!word->isFlag()) line += " " + inShellQuotes((isLikeOption ? "./" : "") + text);
    }
    return line;
}

// The option at line[at], "--samples 4" or "--samples=4"; `at` is left at its last word.
void CommandLine::takeOption(const std::vector<std::string>& line, std::size_t& at) {
    const std::size_t equals = line[at].find('=');
    const std::string name = line[at].substr(0, equals);
    const Word* const option = find(name);
    if (!option) failUnknown(name);
    const bool hasValue = equals != std::string::npos;
    if (option->isFlag()) {
        if (hasValue) refuse(name, "no value", inQuotes(line[at].substr(equals + 1)));
        return given_.push_back({option, "", rest_.size()});
    }
    if (hasValue) return given_.push_back({option, line[at].substr(equals + 1), rest_.size()});
    if (at + 1 == line.size() || find(line[at + 1])) refuse(name, option->expected, "nothing");
    const std::string& text = line[++at];
    if (text.starts_with('=') && (text.size() > 1 || at + 1 < line.size()))
        throw WrongUsage{"unexpected \"=\"; write " + name + " " +
                         (text.size() > 1 ? text.substr(1) : line[at + 1])};
    given_.push_back({option, text, rest_.size()});
}

// The line's words into options and the rest; all that is behind "--" is rest.
void CommandLine::sort(const std::vector<std::string>& line) {
    const auto end = std::ranges::find(line, "--");
    for (std::size_t at = 0; at < std::size_t(end - line.begin()); ++at) {
        if (looksLikeOption(line[at]) || !behindLongDash(line[at]).empty()) takeOption(line, at);
        else rest_.push_back(line[at]);
    }
    if (end != line.end()) rest_.insert(rest_.end(), end + 1, line.end());
}

void CommandLine::giveArguments() {
    requireOrder();
    const std::vector<const Word*> expected = expectedArguments();
    for (std::size_t i = 0; i < rest_.size(); ++i) given_.push_back({expected[i], rest_[i]});
}

void CommandLine::requireTogether() const {
    for (const auto& [option, other] : excluded_)
        if (given(option) && given(other))
            throw joinedWords(option, " and ", other, " exclude each other: give one of them");
    for (const auto& [option, other] : needed_)
        if (given(option) && !given(other)) throw joinedWords(option, " has no effect without ", other);
}

// Whether the line asks for help or for the version, before anything that is not known; with the exit status.
std::optional<int> CommandLine::answered(const std::vector<std::string>& line) const {
    for (std::size_t at = 0; at < line.size() && line[at] != "--"; ++at) {
        const std::string& word = line[at];
        const Word* const option = find(word);
        if (!option && looksLikeOption(word) && !find(word.substr(0, word.find('=')))) break;
        if (!option) continue;
        const bool isHelp = option->name == "--help", isVersion = option->name == "--version";
        if (isHelp || isVersion) {
            print(isHelp ? help() : versionText());
            return 0;
        }
        if (!option->isFlag() && at + 1 < line.size() && !find(line[at + 1])) ++at;  // over its value
    }
    return std::nullopt;
}

// A command that is not the first word, and no option's value; empty where there is none.
std::string CommandLine::lateCommand(const std::vector<std::string>& line) const {
    for (std::size_t at = 0; at < line.size() && line[at] != "--"; ++at) {
        const Word* const option = find(line[at]);
        if (option && !option->isFlag()) ++at;
        else if (std::ranges::find(commands_, line[at]) != commands_.end()) return line[at];
    }
    return {};
}

// Where nothing is the default, an empty text would pass for that: "$VARIABLE" of a variable that is not set.
static void take(const Word& word, const std::string& text) {
    if (word.isText && text.find_first_not_of(" \t\n") == text.npos)
        refuse(word.name, word.expected, inQuotes(text));
    word.read(text);
}

std::optional<int> CommandLine::parse(int argc, char** argv) {
    program_ = argv[0];
    const std::vector<std::string> line(argv + 1, argv + argc);
    try {
        if (const auto text = document(line)) {
            print(*text);
            return 0;
        }
        if (const auto status = answered(line)) return status;
        sort(line);
        giveArguments();
        for (const auto& [word, text, at] : given_) take(*word, text);
        requireTogether();
    } catch (const WrongUsage& wrong) {
        const std::string late = lateCommand(line);
        tell(command_ + ": " +
             (late.empty() ? wrong.message + (wrong.hint ? " (see --help)" : "")
                           : "the command stands first: raytracer " + late + " ..."));
        return 2;
    }
    return std::nullopt;
}

}  // namespace raytracer::commands
