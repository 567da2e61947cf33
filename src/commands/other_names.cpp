// Finds out what is meant by an unknown option.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "command_line.h"
#include "raytracer/tracer/term_names.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// Names that other programs, and people, use for our options and arguments.
struct OtherName {
    std::string_view name, ours;  // `ours` may have a value
};
constexpr OtherName otherNames[] = {
    {"depth", "--max-recursion"},
    {"bounces", "--max-recursion"},
    {"max-depth", "--max-recursion"},
    {"spp", "--samples"},
    {"antialiasing", "--samples"},
    {"aa", "--samples"},
    {"jobs", "--threads"},
    {"j", "--threads"},
    {"cores", "--threads"},
    {"verbose", "--stats"},
    {"v", "--version"},
    {"q", "--quiet"},
    {"silent", "--quiet"},
    {"normals", "--pass normals"},
    {"raycast", "--pass raycast"},
    {"ambient", "--only ambient"},
    {"diffuse", "--only diffuse"},
    {"specular", "--only specular"},
    {"float", "--precision float"},
    {"double", "--precision double"},
    {"bilinear", "--texture-filter bilinear"},
    {"nearest", "--texture-filter nearest"},
    {"region", "--crop"},
    {"threshold", "--tolerance"},
    {"o", "IMAGE_OUT"},
    {"out", "IMAGE_OUT"},
    {"output", "IMAGE_OUT"},
    {"o", "--diff"},
    {"out", "--diff"},
    {"output", "--diff"},
    {"o", "--report"},
    {"out", "--report"},
    {"output", "--report"},
    {"o", "--out"},
    {"size", "LONG_EDGE_PIXELS"},
    {"width", "LONG_EDGE_PIXELS"},
    {"height", "LONG_EDGE_PIXELS"},
    {"s", "LONG_EDGE_PIXELS"},
    {"resolution", "LONG_EDGE_PIXELS"},
    {"w", "LONG_EDGE_PIXELS"},
    {"scene", "SCENE"},
    {"input", "SCENE"},
    {"i", "SCENE"},
};

std::string_view withoutDashes(std::string_view name) {
    if (const auto behind = behindLongDash(name); !behind.empty()) name = behind;
    name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
    return name;
}

// The advice for --no-TERM; empty if there is no such term.
std::string withoutTerm(std::string_view name) {
    return isTerm(name) ? ": --only names the terms that are left" : "";
}

}  // namespace

void CommandLine::failUnknown(const std::string& option) const {
    const auto lacking = std::ranges::find(lacking_, option, &Pair::first);
    if (lacking != lacking_.end()) throw UsageError("there is no " + option + ": " + lacking->second);
    const std::string unknown = "unknown option " + option;
    const std::string_view name = withoutDashes(option);
    if (name.starts_with("no-")) throw UsageError(unknown + withoutTerm(name.substr(3)) + seeHelp);
    const std::string ours = meantOption(name);
    if (ours.empty()) throw UsageError(unknown + seeHelp);
    if (ours.starts_with("--")) throw UsageError(unknown + "; did you mean " + ours + "?");
    throw UsageError(unknown + "; the order is " + order());
}

// The option or argument that is meant: by an exact other name, else the nearest of this command's options,
// else by the nearest other name. Empty if there is none.
std::string CommandLine::meantOption(std::string_view name) const {
    NearestName own(name), others(name);
    for (const Word& word : words_)
        if (word.isOption()) own.consider(withoutDashes(word.name));
    std::map<std::string, std::string_view> here;  // other names of this command's options and arguments
    for (const OtherName& other : otherNames)
        if (std::ranges::find(words_, other.ours.substr(0, other.ours.find(' ')), &Word::name) !=
            words_.end()) {
            here.emplace(other.name, other.ours);
            others.consider(other.name);
        }
    if (const auto exact = here.find(std::string(name)); exact != here.end())
        return std::string(exact->second);
    if (own.found()) return "--" + own.name();
    return others.found() ? std::string(here.at(others.name())) : "";
}

}  // namespace raytracer::commands
