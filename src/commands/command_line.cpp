#include "command_line.h"

#include <algorithm>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/json/json_document.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// What is expected, in words. A list of choices that is too long for a line is left to the help.
std::string expectedOf(const std::vector<std::string>& choices) {
    constexpr std::size_t longest = 60;
    const std::string list = listed(choices);
    return list.size() <= longest ? list : "a name in --help";
}

// Throws UsageError for a text that is none of the choices. The message has all choices and a hint if that
// fits into a line. Otherwise it has the choice that differs only in case, if there is one, or all choices.
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

// "-" is the name of a file and "-1" a number: these are not options.
bool looksLikeOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && !numberOf<double>(word);
}

}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& purpose)
    : name_(name), purpose_(purpose), command_(joined({"raytracer", name}, " ")) {
    // parse() answers these, wherever they are on the line.
    words_.push_back({"--help", "Print this; or -h"});
    words_.push_back({"--version", "Print the version, the instruction sets and the precisions; or -V"});
}

void CommandLine::text(const char* name, std::string& value, const std::string& help, ArgumentKind kind) {
    const auto read = [&value](const std::string& text) { value = text; };
    const bool isFolder = kind == ArgumentKind::Folder;
    words_.push_back({.name = name,
                      .help = help,
                      .read = read,
                      .placeholder = isFolder ? "FOLDER" : "TEXT",
                      .usual = value,
                      .expected = isFolder ? "a folder" : "a text",
                      .kind = kind,
                      .isText = true});
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
    std::string none;
    text(name, none, help, kind);
    words_.back().read = [&values](const std::string& text) { values.push_back(text); };
    words_.back().isMany = true;
}

void CommandLine::choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                         const std::string& help, const Remedy& remedy) {
    const auto read = [=, command = command_, &value](const std::string& text) {
        if (std::ranges::find(choices, text) == choices.end())
            refuseChoice(command, name, text, choices, remedy ? remedy(text) : "");
        value = text;
    };
    words_.push_back({.name = name,
                      .help = help,
                      .read = read,
                      .placeholder = "NAME",
                      .usual = value,
                      .expected = expectedOf(choices),
                      .choices = choices});
}

void CommandLine::names(const char* name, std::string& list, const std::vector<std::string>& choices,
                        const std::string& help) {
    text(name, list, help);
    words_.back().choices = choices;
}

void CommandLine::flag(const char* name, bool& value, const std::string& help) {
    words_.push_back({name, help, [&value](const std::string&) { value = true; }});
}

void CommandLine::alone(const char* name, const std::string& help, const std::vector<std::string>& values) {
    words_.push_back({.name = name,
                      .help = help,
                      .placeholder = values.empty() ? "" : "SHELL",
                      .expected = listed(values),
                      .choices = values});
}

void CommandLine::shown(const char* option, const char* placeholder, const char* expected) {
    Word& word = *std::ranges::find(words_, option, &Word::name);
    word.placeholder = placeholder;
    word.expected = expected ? expected : placeholder;
}

void CommandLine::exclude(const char* option, std::initializer_list<const char*> others) {
    for (const char* other : others) excluded_.emplace_back(option, other);
}

void CommandLine::needs(const char* option, const char* other) { needed_.emplace_back(option, other); }

void CommandLine::spares(const char* option, std::initializer_list<const char*> arguments) {
    sparing_ = option;
    spared_.assign(arguments.begin(), arguments.end());
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
        const bool isLikeOption = !word->isOption() && looksLikeOption(text);  // it stood behind "--"
        if (!word->isFlag()) line += " " + inShellQuotes((isLikeOption ? "./" : "") + text);
    }
    return line;
}

// Takes the option at line[at], "--samples 4" or "--samples=4", and moves `at` to its last word.
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
    if (text.starts_with('=') && (text.size() > 1 ? !option->isText : at + 1 < line.size())) {
        const std::string value = text.size() > 1 ? text.substr(1) : line[at + 1];
        if (option->read) option->read(value);  // says what it expects
        throw UsageError("unexpected \"=\"; write " + name + " " + value);
    }
    given_.push_back({option, text, rest_.size()});
}

// Sorts the line's words into options and arguments (rest_). All words behind "--" are arguments.
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
    const auto both = std::ranges::find_if(
        excluded_, [&](const auto& options) { return given(options.first) && given(options.second); });
    if (both != excluded_.end())
        throw UsageError(both->first + " and " + both->second + " exclude each other: give one of them");
    const auto alone = std::ranges::find_if(
        needed_, [&](const auto& options) { return given(options.first) && !given(options.second); });
    if (alone != needed_.end()) throw UsageError(alone->first + " has no effect without " + alone->second);
}

// Whether the line asks for help or for the version, before any unknown option. Then the answer is printed.
bool CommandLine::answered(const std::vector<std::string>& line) const {
    for (std::size_t at = 0; at < line.size() && line[at] != "--"; ++at) {
        const std::string& word = line[at];
        const Word* const option = find(word);
        if (!option && looksLikeOption(word) && !find(word.substr(0, word.find('=')))) break;
        if (!option) continue;
        const bool isHelp = option->name == "--help", isVersion = option->name == "--version";
        if (isHelp || isVersion) {
            print(isHelp ? help() : versionText());
            return true;
        }
        if (!option->isFlag() && at + 1 < line.size() && !find(line[at + 1])) ++at;  // skips its value
    }
    return false;
}

// A command's name that is neither the first word nor an option's value; empty if there is none.
std::string CommandLine::lateCommand(const std::vector<std::string>& line) const {
    const std::vector<std::string> commands = commandNames();
    for (std::size_t at = 0; at < line.size() && line[at] != "--"; ++at) {
        const Word* const option = find(line[at]);
        if (option && !option->isFlag()) ++at;
        else if (std::ranges::find(commands, line[at]) != commands.end()) return line[at];
    }
    return {};
}

// Refuses a blank text, which would pass for an option that is not given: "$VARIABLE" of an unset variable.
static void take(const Word& word, const std::string& text) {
    if (word.isText && text.find_first_not_of(" \t\n") == text.npos)
        refuse(word.name, word.expected, inQuotes(text));
    word.read(text);
}

bool CommandLine::parse(int argc, char** argv) {
    program_ = argv[0];
    const std::vector<std::string> line(argv + 1, argv + argc);
    try {
        if (const auto text = document(line)) {
            print(*text);
            return true;
        }
        if (answered(line)) return true;
        sort(line);
        giveArguments();
        for (const auto& [word, text, at] : given_) take(*word, text);
        requireTogether();
    } catch (const UsageError&) {
        const std::string late = name_.empty() ? lateCommand(line) : "";
        if (late.empty()) throw;
        throw UsageError("the command stands first: raytracer " + late + " ...");
    }
    return false;
}

}  // namespace raytracer::commands
