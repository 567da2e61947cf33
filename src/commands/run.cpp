// Finds the command that a command line is for, and runs it.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/json/json_document.h"
#include "raytracer/numerics/instruction_set.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

struct Command {
    std::string_view name;
    int (*run)(int argc, char** argv);
};
constexpr Command commandTable[] = {
    {"assemble", assemble}, {"compare", compare},   {"explain", explain},
    {"grade", grade},       {"tradeoff", tradeoff},
};

// Words that people write for commands, but that are no command's name.
struct Nameless {
    std::string_view name, instead;
};
constexpr Nameless nameless[] = {
    {"render", "SCENE IMAGE_OUT LONG_EDGE_PIXELS"},
    {"watch", "SCENE IMAGE_OUT LONG_EDGE_PIXELS --watch"},
    {"help", "--help"},
    {"version", "--version"},
    {"schema", "--print-schema"},
    {"man", "--print-manual"},
    {"manual", "--print-manual"},
    {"completion", "--print-completion bash"},
};

// Whether the first word looks like a command rather than a scene: it has no ending, and there is no file
// with that name, not even with a blank in it.
bool looksLikeCommand(const std::vector<std::string>& words) {
    const std::string& word = words[0];
    std::error_code error;
    const auto exists = [&](const std::string& file) {
        return std::filesystem::exists(file, error) || error;
    };
    return word.find_first_of("./\\=") == word.npos && std::isalpha(static_cast<unsigned char>(word[0])) &&
           !exists(word) && !(words.size() > 1 && exists(word + " " + words[1]));
}

// The only command whose name begins with the word; empty if there is none.
std::string_view commandBegunBy(std::string_view word) {
    constexpr std::size_t least = 3;  // letters
    const auto begins = [&](const Command& command) { return command.name.starts_with(word); };
    if (word.size() < least || std::ranges::count_if(commandTable, begins) != 1) return {};
    return std::ranges::find_if(commandTable, begins)->name;
}

// The message about an unknown command; empty if a scene is meant.
std::string unknownCommand(const std::string& word) {
    const std::string unknown = "raytracer: unknown command " + inQuotes(word);
    for (const Nameless& known : nameless)
        if (word == known.name) return unknown + "; write raytracer " + std::string(known.instead);
    NearestName nearest(word);
    for (const Command& command : commandTable) nearest.consider(command.name);
    if (const auto begun = commandBegunBy(word); !begun.empty()) return unknown + didYouMean(begun);
    if (nearest.found()) return unknown + nearest.question();
    if (!nearbyFile(word).empty()) return {};
    return "raytracer: " + inQuotes(word) + " is no scene and no command (" + joined(commandNames(), ", ") +
           ")";
}

// Prints a command's part of the man page or of the completions.
void printPart(std::string name, int (*command)(int, char**), std::vector<std::string> words) {
    std::vector<char*> argv{name.data()};
    for (std::string& word : words) argv.push_back(word.data());
    command(static_cast<int>(argv.size()), argv.data());
}

// Prints those parts of all commands that have a name.
void printParts(const std::vector<std::string>& words) {
    for (const Command& command : commandTable) printPart(std::string(command.name), command.run, words);
}

void printManual() {
    const std::string version = programVersion();
    print(
        ".TH RAYTRACER 1 \"\" \"raytracer " + version.substr(0, version.find(' ')) +
        "\"\n.SH NAME\nraytracer \\- renders JSON scenes by classic ray tracing\n.SH SYNOPSIS\n.B raytracer\n"
        "[options] SCENE IMAGE_OUT LONG_EDGE_PIXELS\n.br\n.B raytracer\nCOMMAND [options] ...\n.SH "
        "DESCRIPTION\n"
        "Turns a scene, a JSON file, into a picture; the commands compare pictures, grade programs, explain "
        "a\n"
        "pixel and measure what speed costs. Each command's section follows.\n");
    printPart("raytracer", render, {"--print-manual"});
    printParts({"--print-manual"});
}

// The command without a name comes last: it matches whatever the others do not.
void printCompletions(const std::string& shell) {
    printParts({"--print-completion", shell});
    printPart("raytracer", render, {"--print-completion", shell});
}

void printCompletion(const std::string& shell) {
    if (shell == "bash") {
        print(
            "_raytracer() {\n    local current=${COMP_WORDS[COMP_CWORD]} words=\"\" command=render\n"
            "    [[ \" " +
            joined(commandNames(), " ") +
            " \" == *\" ${COMP_WORDS[1]} \"* ]] && command=${COMP_WORDS[1]}\n"
            "    ((COMP_CWORD == 1)) && words=\"" +
            joined(commandNames(), " ") +
            "\"\n"
            "    case \"$command ${COMP_WORDS[COMP_CWORD - 1]}\" in\n");
        printCompletions(shell);
        print(
            "    esac\n    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\n"
            "complete -o default -F _raytracer raytracer\n");
    } else if (shell == "zsh") {
        print("#compdef raytracer\n_raytracer() {\n    if ((CURRENT == 2)); then compadd " +
              joined(commandNames(), " ") + "; fi\n    case $words[2] in\n    " +
              joined(commandNames(), "|") +
              ") shift words; ((CURRENT--)) ;;\n    esac\n    case $words[1] in\n");
        printCompletions(shell);
        print("    esac\n}\n_raytracer \"$@\"\n");
    } else {
        print("set -l names " + joined(commandNames(), " ") + "\n");
        printCompletions(shell);
    }
}

// Options that print a document, to be installed beside the program.
constexpr std::string_view documents[] = {"--print-schema", "--print-manual", "--print-completion"};

std::string_view withoutValue(std::string_view word) { return word.substr(0, word.find('=')); }

// Throws UsageError unless the option `asked` and its value are the only words of the line.
void requireAlone(const std::vector<std::string>& words, const std::string& asked, bool isCompletion,
                  const std::vector<std::string>& values) {
    const bool hasValue = asked.find('=') != asked.npos;
    const std::string found = ", found " + (values.empty() ? "nothing" : inQuotes(values[0]));
    std::string name(withoutValue(asked));
    if (!isCompletion && hasValue) throw UsageError(name + ": expected no value" + found);
    if (isCompletion && (values.empty() || std::ranges::find(shells, values[0]) == std::end(shells)))
        throw UsageError(name + ": expected " + listed({std::begin(shells), std::end(shells)}) + found);
    if (isCompletion) name += " " + values[0];
    if (&asked != &words[0] || values.size() > isCompletion) throw UsageError(name + " stands alone");
}

bool asksForHelp(std::string_view word) { return word == "--help" || word == "-h"; }

// Prints the document that the line asks for. Returns false if it asks for none, or for --help.
bool printDocument(const std::vector<std::string>& words) {
    if (std::any_of(words.begin(), std::ranges::find(words, "--"), asksForHelp)) return false;
    const auto asked = std::ranges::find_if(words, [](const std::string& word) {
        return std::ranges::find(documents, withoutValue(word)) != std::end(documents);
    });
    if (asked == words.end()) return false;
    const std::string_view what = withoutValue(*asked);
    std::vector<std::string> values(asked + 1, words.end());
    if (what.size() < asked->size()) values.insert(values.begin(), asked->substr(what.size() + 1));
    requireAlone(words, *asked, what == "--print-completion", values);
    if (what == "--print-schema") print(schema_text::scene);
    else if (what == "--print-manual") printManual();
    else printCompletion(values[0]);
    return true;
}

int renderOrPrint(int argc, char** argv) {
    return printDocument({argv + std::min(argc, 1), argv + argc}) ? 0 : render(argc, argv);
}

// Runs a command, and puts its name before the message of a UsageError.
int called(const std::string& name, int (*command)(int, char**), int argc, char** argv) {
    try {
        return command(argc, argv);
    } catch (const UsageError& error) {
        throw Error({name}, error.what());
    }
}

}  // namespace

std::vector<std::string> commandNames() {
    std::vector<std::string> names;
    for (const Command& command : commandTable) names.emplace_back(command.name);
    return names;
}

int run(int argc, char** argv) {
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (words.size() == 2 && asksForHelp(words[0])) std::swap(argv[1], argv[2]);  // --help compare
    defaultInstructionSet();  // throws if RAYTRACER_SIMD is wrong, before any command does its work
    for (const Command& command : commandTable)
        if (argc > 1 && command.name == argv[1])
            return called("raytracer " + std::string(command.name), command.run, argc - 1, argv + 1);
    const std::string unknown = !words.empty() && looksLikeCommand(words) ? unknownCommand(words[0]) : "";
    if (unknown.empty()) return called("raytracer", renderOrPrint, argc, argv);
    tell(unknown);
    return 2;
}

}  // namespace raytracer::commands
