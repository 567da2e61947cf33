#include "pointer_mistake.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

#include "raytracer/json/json_pointer.h"
#include "raytracer/json/json_view.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

using Kind = JsonDocument::Kind;
using Steps = std::vector<std::string>;

Steps stepsOf(std::string_view pointer, std::string_view separators) {
    Steps steps(1);
    for (const char c : pointer) {
        if (separators.find(c) == separators.npos) steps.back() += c;
        else if (!steps.back().empty()) steps.emplace_back();
    }
    if (steps.back().empty()) steps.pop_back();
    const bool hasRoot = !steps.empty() && (steps[0] == "$" || steps[0] == "-");
    return hasRoot ? Steps(steps.begin() + 1, steps.end()) : steps;
}

// The pointer of the array's element whose "name" is this; empty if there is none.
std::string named(const JsonDocument& document, std::uint32_t list, std::string_view name) {
    if (document.kind(list) != Kind::Array) return {};
    for (const JsonView element : JsonView(document, list).elements()) {
        const auto found = element.kind() == Kind::Object ? element.find("name") : std::nullopt;
        if (found && found->isString(name)) return element.pointer();
    }
    return {};
}

bool isPlainKey(std::string_view key) {
    const auto isPlain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    return std::isalpha(static_cast<unsigned char>(key[0])) && std::ranges::all_of(key, isPlain);
}

// The pointer made of the steps, where a step may also be the name of an array's element. The last
// step may be "-", or a new key of an object other than the root. Empty if the steps lead nowhere.
std::string leading(const JsonDocument& document, const Steps& steps) {
    std::string pointer;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::uint32_t here = follow(document, pointer).node;
        const bool isLast = i + 1 == steps.size(), isObject = document.kind(here) == Kind::Object;
        const std::string next = pointer + "/" + steps[i];
        const std::string element = named(document, here, steps[i]);
        const bool isNew = isObject ? here != 0 && isPlainKey(steps[i]) : steps[i] == "-";
        const bool isFound = follow(document, next).left.empty();
        if (isFound || !element.empty()) pointer = isFound ? next : element;
        else return isLast && isNew && (isObject || document.kind(here) == Kind::Array) ? next : "";
    }
    return pointer;
}

// The pointer of the only value in the document to which the steps lead, starting at any key. Empty if there
// is none, or more than one.
std::string onlyPlace(const JsonDocument& document, const Steps& steps) {
    std::string behind;
    for (std::size_t i = 1; i < steps.size(); ++i) behind += "/" + steps[i];
    std::uint32_t place = 0;
    for (std::uint32_t node = 0; node < document.end(0); ++node) {
        if (document.kind(node) != Kind::Key || document.string(node) != steps[0]) continue;
        const PointerEnd end = follow(document, behind, node + 1);
        if (!end.left.empty()) continue;
        if (place != 0) return {};
        place = end.node;
    }
    return place == 0 ? "" : document.pointer(place);
}

// The pointer that is meant by one with other separators, without its first steps, or with names of elements.
std::string meant(const JsonDocument& document, const std::string& pointer) {
    const Steps bySlash = stepsOf(pointer, "/"), byAny = stepsOf(pointer, "/.:[]\\");
    for (const Steps& steps : {bySlash, byAny}) {
        std::string found = leading(document, steps);
        if (!found.empty() && follow(document, found).left.empty()) return found;
    }
    std::string added = leading(document, byAny);
    if (!added.empty() || byAny.empty() || pointer.starts_with('/')) return added;
    return onlyPlace(document, byAny);
}

// "; did you mean ...?" with the key of the object that
// is nearest to one that it lacks; empty if none is near.
std::string question(const JsonDocument& document, const PointerEnd& end, std::string_view key) {
    NearestName nearest(key);
    for (std::uint32_t at = end.node + 1; at < document.end(end.node); at = document.end(at + 1))
        nearest.consider(pointerStep(document.string(at)).substr(1));
    if (!nearest.found()) return "";
    const std::string behind(end.left.substr(1 + key.size()));
    return "; did you mean " + document.pointer(end.node) + "/" + nearest.name() + behind + "?";
}

// The message for an index that an array lacks. An array of numbers is a point or a colour, of a fixed size:
// it is not proposed to add an element.
std::string notInList(const JsonView list, std::string_view step, bool isLast) {
    const std::size_t count = list.size();
    const std::string here = list.pointer();
    const bool isOfNumbers = count > 0 && list.element(0).kind() == Kind::Number;
    return here + " has " + std::to_string(count) + (count == 1 ? " element" : " elements") +
           ", from 0: there is no " + inQuotes(step) +
           (isOfNumbers || !isLast ? "" : "; " + here + "/- adds one");
}

}  // namespace

std::string aboutPointerForm(const JsonDocument& document, const std::string& pointer) {
    if (pointer.ends_with(' ')) return "a blank stands before =: delete it";
    const bool hasSlash = pointer.starts_with('/');
    if (hasSlash && pointer.ends_with('/'))
        return {};  // "/lights/" may lack the key, or have a slash too many
    const std::string place = meant(document, pointer);
    if (place == pointer || (hasSlash && place.empty())) return {};
    const std::string remedy = place.empty() ? "" : ": write " + place;
    if (!hasSlash) return "a pointer begins with /" + remedy;
    const PointerEnd end = follow(document, pointer);
    const std::string step(end.left.substr(1, end.left.find('/', 1) - 1));
    if (const std::string element = named(document, end.node, step); !element.empty())
        return inQuotes(step) + " is a name" + remedy;
    return "steps are parted by /" + remedy;
}

std::string aboutLostPointer(const JsonDocument& document, const std::string& pointer) {
    const PointerEnd end = follow(document, pointer);
    const std::string here = end.node == 0 ? "the scene" : document.pointer(end.node);
    const std::string_view step = end.left.substr(1, end.left.find('/', 1) - 1);
    if (document.kind(end.node) == Kind::Object)
        return "there is no " + inQuotes(step) + " in " + here + question(document, end, step);
    if (document.kind(end.node) != Kind::Array) return here + " is no object and no list";
    if (step == "-") return "- adds an element, and ends its pointer: write " + here + "/-";
    return notInList(JsonView(document, end.node), step, step.size() + 1 == end.left.size());
}

}  // namespace raytracer
