// What is wrong with a command line, as its author would like to be told.
#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>

#include "arguments.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// A name with a blank, which a shell takes for two words; empty where there is none.
std::string fileWithBlank(const std::vector<std::string>& words) {
    std::error_code error;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        std::string joined = words[i] + " " + words[i + 1];
        if (std::filesystem::is_regular_file(joined, error)) return joined;
    }
    return {};
}

ArgumentKind kindOf(const std::string& text) {
    if (endsIn(text, ".json")) return ArgumentKind::Scene;
    if (text == "-" || isPictureName(text)) return ArgumentKind::Picture;
    return numberOf<double>(text) ? ArgumentKind::Number : ArgumentKind::Any;
}

std::string nounOf(ArgumentKind kind) {
    if (kind == ArgumentKind::Scene) return "the scene";
    return kind == ArgumentKind::Picture ? "the picture" : "";
}

// Whether an argument is of this kind, which is not any.
bool has(const std::vector<const Word*>& expected, ArgumentKind kind) {
    return kind != ArgumentKind::Any && std::ranges::count(expected, kind, &Word::kind) > 0;
}

// For each text the place of an argument of its kind, behind those of the texts before it; or of any kind,
// where there are texts enough for all. Ends before the first text for which no place is left.
std::vector<std::size_t> placesInOrder(const std::vector<std::string>& texts,
                                       const std::vector<const Word*>& expected) {
    std::vector<std::size_t> places;
    std::size_t next = 0;
    for (const std::string& text : texts) {
        const bool hasAll = texts.size() - places.size() >= expected.size() - next;
        const auto fits = [&](ArgumentKind kind) {
            return kind == ArgumentKind::Any ? hasAll : kind == kindOf(text);
        };
        if (has(expected, kindOf(text)))
            while (next < expected.size() && !fits(expected[next]->kind)) ++next;
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
            if (kindOf(text) == kind && places-- == 0) return &text;
    }
    return nullptr;
}

// Whether the first is a scene by its place, as a file whose name says nothing: "8".
bool isOddlyNamedScene(const std::vector<std::string>& texts, const std::vector<const Word*>& expected) {
    std::error_code error;
    return texts.size() == expected.size() && expected[0]->kind == ArgumentKind::Scene &&
           kindOf(texts[0]) == ArgumentKind::Number && std::filesystem::exists(texts[0], error);
}

// The scene or the picture that no text is, where each text is of some kind and none is too many.
const Word* absentKind(const std::vector<std::string>& texts, const std::vector<const Word*>& expected) {
    const auto isKnown = [&](const std::string& text) { return has(expected, kindOf(text)); };
    if (texts.size() > expected.size() || !std::ranges::all_of(texts, isKnown)) return nullptr;
    for (const Word* word : expected)
        if (!nounOf(word->kind).empty() && std::ranges::count(texts, word->kind, kindOf) == 0) return word;
    return nullptr;
}

// "3 3" of "3,3"; empty where the text is no list of numbers.
std::string numbersApart(const std::string& text) {
    const std::vector<std::string> numbers = split(text, ",");
    const bool isList = numbers.size() > 1 && std::ranges::all_of(numbers, isWholeNumber);
    return isList ? joined(numbers, " ") : "";
}

// "is out.png the picture", of the first text that has another's place; empty where none has.
std::string swappedIn(const std::vector<std::string>& texts, const std::vector<const Word*>& expected) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const ArgumentKind kind = kindOf(texts[i]);
        const bool isHere = i < expected.size() && expected[i]->kind == kind;
        if (!isHere && has(expected, kind) && !nounOf(kind).empty())
            return "is " + texts[i] + " " + nounOf(kind);
    }
    return {};
}

}  // namespace

std::vector<const Word*> CommandLine::arguments() const {
    std::vector<const Word*> found;
    for (const Word& word : words_)
        if (!word.isOption()) found.push_back(&word);
    return found;
}

std::string CommandLine::order() const {
    std::vector<std::string> names;
    for (const Word* argument : arguments())
        names.push_back(argument->name + (argument->isMany ? "..." : ""));
    return joined(names, " ");
}

// One for each that is given: the one that may be repeated, as often as leaves the others one each.
std::vector<const Word*> CommandLine::expectedArguments() const {
    std::vector<const Word*> expected = arguments();
    const auto many = std::ranges::find_if(expected, &Word::isMany);
    if (many != expected.end() && rest_.size() > expected.size())
        expected.insert(many, rest_.size() - expected.size(), *many);
    if (given(sparing_) && rest_.size() + spared_.size() <= expected.size())
        std::erase_if(expected, [&](const Word* word) {
            return std::ranges::find(spared_, word->name) != spared_.end();
        });
    return expected;
}

// Throws where words behind an option are parts of its value.
void CommandLine::requireWholeValues() const {
    for (const auto& [word, text, at] : given_) {
        if (!word->rejoin) continue;
        const Word::Whole whole = word->rejoin(text, std::span(rest_).subspan(at));
        if (!whole.value.empty())
            throw UsageError(word->name + " " + whole.form + ": write " + word->name + " " + whole.value);
    }
}

// Throws where a picture has the place of a scene or of a number, or standard input that of a scene.
void CommandLine::requireKinds() const {
    const std::vector<const Word*> expected = arguments();
    if (!rest_.empty() && rest_[0] == "-" && expected[0]->kind == ArgumentKind::Scene)
        throw UsageError("a scene is not read from standard input: name its file");
    const auto picture =
        std::ranges::find_if(rest_, [](const std::string& text) { return isPictureName(text); });
    if (find("--picture") && picture != rest_.end())
        throw UsageError("is " + *picture + " the picture? Give it with --picture; the order is " + order());
}

// Throws where a word is an option without its dashes: "/max-recursion 3", "max-recursion=3".
void CommandLine::requireDashes() const {
    for (std::size_t i = 0; i < rest_.size(); ++i) {
        const std::size_t slash = rest_[i].starts_with('/'), equals = rest_[i].find('=');
        const Word* const option = find("--" + rest_[i].substr(slash, equals - slash));
        if (!option) continue;
        std::string value = equals == std::string::npos ? "" : rest_[i].substr(equals + 1);
        if (value.empty() && !option->isFlag() && i + 1 < rest_.size()) value = rest_[i + 1];
        throw UsageError("unexpected argument " + inQuotes(rest_[i]) + "; write " + option->name +
                         (value.empty() ? "" : " " + value));
    }
}

// Throws where a text that is no number has the place of one.
void CommandLine::requireNumbers(const std::vector<std::size_t>& places,
                                 const std::vector<const Word*>& expected) const {
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Word& word = *expected[places[i]];
        if (word.kind != ArgumentKind::Number || kindOf(rest_[i]) == word.kind) continue;
        if (const std::string apart = numbersApart(rest_[i]); !apart.empty())
            refuse(word.name, word.expected, inQuotes(rest_[i]) + "; write " + apart);
        word.read(rest_[i]);  // says what it expects
    }
}

// Throws where there are too few arguments, too many, or they are in another order.
void CommandLine::requireOrder() const {
    requireKinds();
    const std::vector<const Word*> expected = expectedArguments();
    if (isOddlyNamedScene(rest_, expected)) return;
    const std::vector<std::size_t> places = placesInOrder(rest_, expected);
    const bool hasMore = places.size() < rest_.size();
    if (!hasMore && places.size() == expected.size()) return;
    const std::string theOrder = "the order is " + order();
    const std::string blank = hasMore ? fileWithBlank(rest_) : "";
    if (!blank.empty()) throw UsageError("there is a file " + inQuotes(blank) + ": write its name in quotes");
    if (const std::string said = answer_ ? answer_(rest_) : ""; !said.empty()) throw UsageError(said);
    requireWholeValues();
    requireDashes();
    const Word* const absent = hasMore ? absentKind(rest_, expected) : nullptr;
    if (absent) throw UsageError(absent->name + " is missing; " + theOrder + seeHelp);
    const std::string* const surplus = hasMore ? surplusIn(rest_, expected) : nullptr;
    if (surplus) throw UsageError("unexpected argument " + inQuotes(*surplus) + "; " + theOrder);
    const std::string swapped = hasMore ? swappedIn(rest_, expected) : "";
    if (!swapped.empty()) throw UsageError(swapped + "? T" + theOrder.substr(1));
    if (places.size() < expected.size()) requireNumbers(places, expected);
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (std::ranges::find(places, i) == places.end())
            throw UsageError(expected[i]->name + " is missing; " + theOrder + seeHelp);
    throw UsageError("unexpected argument " + inQuotes(rest_[places.size()]) + "; " + theOrder);
}

}  // namespace raytracer::commands
