// Explains what is wrong with a command line's arguments.
#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>

#include "arguments.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// The name of an existing file with a blank, which the
// shell has split into two words; empty if there is none.
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

// Whether one of the arguments is of this kind, and the kind is not Any.
bool has(const std::vector<const Word*>& expected, ArgumentKind kind) {
    return kind != ArgumentKind::Any && std::ranges::count(expected, kind, &Word::kind) > 0;
}

// For each text, the place of an argument of its kind (or of kind Any, if
// there are enough texts for all arguments), behind the places of the
// texts before it. Ends before the first text for which no place is left.
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

// The first surplus text: one of a kind that has more texts than arguments. Null if there is none.
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

// Whether the first text is a scene whose name looks like a number: a file named "8".
bool isOddlyNamedScene(const std::vector<std::string>& texts, const std::vector<const Word*>& expected) {
    std::error_code error;
    return texts.size() == expected.size() && expected[0]->kind == ArgumentKind::Scene &&
           kindOf(texts[0]) == ArgumentKind::Number && std::filesystem::exists(texts[0], error);
}

// The scene or picture argument that is missing, if each text is of a known kind and there are not too many.
const Word* absentKind(const std::vector<std::string>& texts, const std::vector<const Word*>& expected) {
    const auto isKnown = [&](const std::string& text) { return has(expected, kindOf(text)); };
    if (texts.size() > expected.size() || !std::ranges::all_of(texts, isKnown)) return nullptr;
    for (const Word* word : expected)
        if (!nounOf(word->kind).empty() && std::ranges::count(texts, word->kind, kindOf) == 0) return word;
    return nullptr;
}

// "3 3" for "3,3"; empty if the text is not a list of whole numbers.
std::string numbersApart(const std::string& text) {
    const std::vector<std::string> numbers = split(text, ",");
    const bool isList = numbers.size() > 1 && std::ranges::all_of(numbers, isWholeNumber);
    return isList ? joined(numbers, " ") : "";
}

// "is out.png the picture", about the first text that is in the place of another argument; empty if none is.
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

// The arguments to expect, one for each word that is given. The repeatable one comes as often as leaves one
// word for each of the others.
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

// Throws UsageError if words behind an option are parts of its value.
void CommandLine::requireWholeValues() const {
    for (const auto& [word, text, at] : given_) {
        if (!word->rejoin) continue;
        const Word::Whole whole = word->rejoin(text, std::span(rest_).subspan(at));
        if (!whole.value.empty())
            throw UsageError(word->name + " " + whole.form + ": write " + word->name + " " + whole.value);
    }
}

// Throws UsageError if "-" (standard input) is given as the scene, or if a picture is an argument of a
// command that takes it with --picture.
void CommandLine::requireKinds() const {
    const std::vector<const Word*> expected = arguments();
    if (!rest_.empty() && rest_[0] == "-" && expected[0]->kind == ArgumentKind::Scene)
        throw UsageError("a scene is not read from standard input: name its file");
    const auto picture =
        std::ranges::find_if(rest_, [](const std::string& text) { return isPictureName(text); });
    if (find("--picture") && picture != rest_.end())
        throw UsageError("is " + *picture + " the picture? Give it with --picture; the order is " + order());
}

// Throws UsageError if a word is an option without its dashes: "/max-recursion 3", "max-recursion=3".
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

// Throws UsageError if a text that is not a number is in the place of one.
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

// Throws UsageError if there are too few or too many arguments, or if they are in a wrong order.
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
