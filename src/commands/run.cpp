// Which command a line is for.
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

#include "raytracer/commands/commands.h"
#include "raytracer/json/json_document.h"
#include "raytracer/json/nearest_name.h"
#include "raytracer/util/standard_streams.h"

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

// What people write for a command that has no name.
struct Nameless {
    std::string_view name, instead;
};
constexpr Nameless nameless[] = {
    {"render", "SCENE IMAGE_OUT LONG_EDGE_PIXELS"},
    {"help", "--help"},
    {"version", "--version"},
};

// A scene's name mostly has an ending, and else there is a file of that name.
bool looksLikeCommand(const std::string& word) {
    std::error_code error;
    return word.find_first_of("./\\") == word.npos && std::isalpha(static_cast<unsigned char>(word[0])) &&
           !std::filesystem::exists(word, error) && !error;
}

std::string unknownCommand(const std::string& word) {
    const std::string unknown = "raytracer: unknown command " + inQuotes(word) + "; ";
    for (const Nameless& known : nameless)
        if (word == known.name) return unknown + "write raytracer " + std::string(known.instead);
    NearestName nearest(word);
    for (const Command& command : commandTable) nearest.consider(command.name);
    if (nearest.found()) return unknown.substr(0, unknown.size() - 2) + nearest.question();
    std::string names;
    for (const Command& command : commandTable) names += " " + std::string(command.name) + ",";
    names.pop_back();
    return unknown + "there are" + names + ", or a scene's name first";
}

}  // namespace

int run(int argc, char** argv) {
    for (const Command& command : commandTable)
        if (argc > 1 && command.name == argv[1]) return command.run(argc - 1, argv + 1);
    if (argc < 2 || !looksLikeCommand(argv[1])) return render(argc, argv);
    tell(unknownCommand(argv[1]));
    return 2;
}

}  // namespace raytracer::commands
