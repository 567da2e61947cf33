// What is wrong with a command line, as its author would like to be told.
#include <algorithm>
#include <filesystem>
#include <map>
#include <span>
#include <system_error>

#include "command_line.h"
#include "raytracer/json/json_document.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// What other programs, and people, call our options and arguments.
struct OtherName {
    std::string_view name, ours;
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
    {"verbose", "--stats"},
    {"v", "--version"},
    {"q", "--quiet"},
    {"silent", "--quiet"},
    {"normals", "--pass"},
    {"o", "IMAGE_OUT"},
    {"out", "IMAGE_OUT"},
    {"output", "IMAGE_OUT"},
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

// A name with a blank, which a shell takes for two words; empty where there is none.
std::string fileWithBlank(const std::vector<std::string>& words) {
    std::error_code error;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        std::string joined = words[i] + " " + words[i + 1];
        if (std::filesystem::is_regular_file(joined, error)) return joined;
    }
    return {};
}

bool isOfKind(const std::string& text, ArgumentKind kind) {
    switch (kind) {
        case ArgumentKind::Scene: return endsIn(text, ".json");
        case ArgumentKind::Picture: return text == "-" || endsIn(text, ".png") || endsIn(text, ".pfm");
        case ArgumentKind::Number: return numberOf<double>(text).has_value();
        case ArgumentKind::Any:
        case ArgumentKind::Folder: break;
    }
    return false;
}

const char* nounOf(ArgumentKind kind) {
    switch (kind) {
        case ArgumentKind::Scene: return "the scene";
        case ArgumentKind::Picture: return "the picture";
        case ArgumentKind::Any:
        case ArgumentKind::Number:
        case ArgumentKind::Folder: break;
    }
    return "";
}

bool isAnywhere(const std::string& text, const std::vector<const Word*>& expected) {
    return std::ranges::any_of(expected, [&](const Word* word) { return isOfKind(text, word->kind); });
}

// For each text the place of an argument of its kind, behind those of the texts before it. Ends
// before the first text for which no place is left.
std::vector<std::size_t> placesInOrder(const std::vector<std::string>& texts,
                                       const std::vector<const Word*>& expected) {
    std::vector<std::size_t> places;
    std::size_t next = 0;
    for (const std::string& text : texts) {
        if (isAnywhere(text, expected))
            while (next < expected.size() && !isOfKind(text, expected[next]->kind)) ++next;
        if (next >= expected.size()) break;
        places.push_back(next);
        ++next;
    }
    return places;
}

// The first text of a kind of which there are more texts than arguments.
const std::string* surplusIn(const std::vector<std::string>& texts,
                             const std::vector<const Word*>& expected) {
    for (const ArgumentKind kind : {ArgumentKind::Scene, ArgumentKind::Picture, ArgumentKind::Number}) {
        auto places = std::ranges::count(expected, kind, &Word::kind);
        if (places == 0) continue;
        for (const std::string& text : texts)
            if (isOfKind(text, kind) && places-- == 0) return &text;
    }
    return nullptr;
}

// The argument that the text is the picture or the scene of, if it is another one than `here`.
const Word* meantInstead(const std::string& text, const Word* here,
                         const std::vector<const Word*>& expected) {
    const auto isMeant = [&](const Word* word) {
        return word->kind != ArgumentKind::Number && isOfKind(text, word->kind);
    };
    const auto meant = std::ranges::find_if(expected, isMeant);
    return meant == expected.end() || (here && isMeant(here)) ? nullptr : *meant;
}

}  // namespace

std::vector<const Word*> CommandLine::arguments() const {
    std::vector<const Word*> found;
    for (const Word& word : words_)
        if (!word.isOption()) found.push_back(&word);
    return found;
}

std::string CommandLine::order() const {
    std::string names;
    for (const Word* argument : arguments())
        names += (names.empty() ? "" : " ") + argument->name + (argument->isMany ? "..." : "");
    return names;
}

void CommandLine::failUnknown(const std::string& option) const {
    const auto lacking = std::ranges::find(lacking_, option, &Pair::first);
    if (lacking != lacking_.end()) throw WrongUsage{"there is no " + option + ": " + lacking->second};
    const std::string ours = meantOption(withoutDashes(option));
    const std::string unknown = "unknown option " + option;
    if (ours.empty()) throw WrongUsage{unknown, true};
    if (ours.starts_with("--")) throw WrongUsage{unknown + "; did you mean " + ours + "?"};
    throw WrongUsage{unknown + "; the order is " + order()};
}

// By its exact other name, else by what is near to the names here, and last to the other names. It may be an
// argument; empty where there is none.
std::string CommandLine::meantOption(std::string_view name) const {
    NearestName own(name), others(name);
    for (const Word& word : words_)
        if (word.isOption()) own.consider(withoutDashes(word.name));
    std::map<std::string, std::string_view> here;  // the other names of what this command has
    for (const OtherName& other : otherNames)
        if (std::ranges::find(words_, other.ours, &Word::name) != words_.end()) {
            here.emplace(other.name, other.ours);
            others.consider(other.name);
        }
    if (const auto exact = here.find(std::string(name)); exact != here.end())
        return std::string(exact->second);
    if (own.found()) return "--" + own.name();
    return others.found() ? std::string(here.at(others.name())) : "";
}

// One for each that is given: the one that may be repeated, as often as leaves the others one each.
std::vector<const Word*> CommandLine::expectedArguments() const {
    std::vector<const Word*> expected = arguments();
    const auto many = std::ranges::find_if(expected, &Word::isMany);
    if (many != expected.end() && rest_.size() > expected.size())
        expected.insert(many, rest_.size() - expected.size(), *many);
    for (const Spared& spared : spared_)
        if (given(spared.option) && rest_.size() + spared.arguments.size() <= expected.size())
            std::erase_if(expected, [&](const Word* word) {
                return std::ranges::find(spared.arguments, word->name) != spared.arguments.end();
            });
    return expected;
}

// Throws where words behind an option are parts of its value.
void CommandLine::requireWholeValues() const {
    for (const auto& [word, text, at] : given_) {
        const std::string whole = word->rejoin ? word->rejoin(text, std::span(rest_).subspan(at)) : "";
        if (!whole.empty())
            throw WrongUsage{word->name + " " + word->form + ": write " + word->name + " " + whole};
    }
}

// Throws where a text that is no number has the place of one.
void CommandLine::requireNumbers(const std::vector<std::size_t>& places) const {
    const std::vector<const Word*> expected = expectedArguments();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Word& word = *expected[places[i]];
        if (word.kind != ArgumentKind::Number || isOfKind(rest_[i], word.kind)) continue;
        const bool isList = rest_[i].find_first_not_of("0123456789,") == std::string::npos;
        std::string apart = rest_[i];
        std::ranges::replace(apart, ',', ' ');
        throw WrongUsage{word.name + ": expected " + word.expected + ", found " + inQuotes(rest_[i]) +
                         (isList ? "; write " + apart : "")};
    }
}

// Throws where there are too few arguments, too many, or they are in another order.
void CommandLine::requireOrder() const {
    const std::vector<const Word*> expected = expectedArguments();
    const std::vector<std::size_t> places = placesInOrder(rest_, expected);
    const bool hasMore = places.size() < rest_.size();
    if (!hasMore && places.size() == expected.size()) return;
    const std::string theOrder = "the order is " + order();
    const std::string blank = hasMore ? fileWithBlank(rest_) : "";
    if (!blank.empty()) throw WrongUsage{"there is a file " + inQuotes(blank) + ": write its name in quotes"};
    requireWholeValues();
    const std::string* const surplus = hasMore ? surplusIn(rest_, expected) : nullptr;
    if (surplus) throw WrongUsage{"unexpected argument " + inQuotes(*surplus) + "; " + theOrder};
    for (std::size_t i = 0; hasMore && i < rest_.size(); ++i) {
        const Word* const here = i < expected.size() ? expected[i] : nullptr;
        if (const Word* const meant = meantInstead(rest_[i], here, expected))
            throw WrongUsage{"is " + rest_[i] + " " + nounOf(meant->kind) + "? T" + theOrder.substr(1)};
    }
    const auto isPicture = [](const std::string& text) {
        return text != "-" && isOfKind(text, ArgumentKind::Picture);
    };
    const auto picture = std::ranges::find_if(rest_, isPicture);
    const bool hasOption = std::ranges::find(words_, "--picture", &Word::name) != words_.end();
    if (hasOption && picture != rest_.end())
        throw WrongUsage{"is " + *picture + " the picture? Give it with --picture; " + theOrder};
    if (places.size() < expected.size()) requireNumbers(places);
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (std::ranges::find(places, i) == places.end())
            throw WrongUsage{expected[i]->name + " is missing; " + theOrder, true};
    throw WrongUsage{"unexpected argument " + inQuotes(rest_[places.size()]) + "; " + theOrder};
}

}  // namespace raytracer::commands
