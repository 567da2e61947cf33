#include "raytracer/json/json_edit.h"

#include <algorithm>
#include <optional>

#include "raytracer/json/json_document.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/json/json_view.h"
#include "raytracer/util/nearest_name.h"

namespace raytracer {
namespace {

// Where the value ends that begins here, of a text that is JSON.
const char* valueEnd(const char* at, const char* end) {
    const auto stringEnd = [&](const char* quote) {
        for (++quote; *quote != '"'; ++quote) quote += *quote == '\\';
        return quote + 1;
    };
    if (*at == '"') return stringEnd(at);
    if (*at != '{' && *at != '[')
        return std::find_if(
            at, end, [](char c) { return std::string_view(",]} \t\r\n").find(c) != std::string_view::npos; });
    int depth = 0;
    do {
        if (*at == '"') {
            at = stringEnd(at);
            continue;
        }
        depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
        ++at;
    } while (depth > 0);
    return at;
}

using Kind = JsonDocument::Kind;

// What else the pointer may mean.
std::string question(const JsonDocument& document, const PointerEnd& end, std::string_view key) {
    NearestName nearest(key);
    for (std::uint32_t at = end.node + 1; at < document.end(end.node); at = document.end(at + 1))
        nearest.consider(pointerStep(document.string(at)).substr(1));
    if (!nearest.found()) return "";
    const std::string behind(end.left.substr(1 + key.size()));
    return "; did you mean " + document.pointer(end.node) + "/" + nearest.name() + behind + "?";
}

// Why a pointer does not lead further.
std::string missing(const JsonDocument& document, const PointerEnd& end) {
    const std::string here = end.node == 0 ? "the scene" : document.pointer(end.node);
    const std::string_view step = end.left.substr(1, end.left.find('/', 1) - 1);
    const std::string isNot = "there is no " + inQuotes(step);
    switch (document.kind(end.node)) {
        case Kind::Object: return isNot + " in " + here + question(document, end, step);
        case Kind::Array: {
            const std::size_t count = JsonView(document, end.node).size();
            return here + " has " + std::to_string(count) + (count == 1 ? " element" : " elements") +
                   ", from 0: " + isNot + "; " + document.pointer(end.node) + "/- adds one";
        }
        default: return here + " is no object and no list";
    }
}

// The pointer with / where other programs have points and brackets: shapes[0].material
std::string withSlashes(std::string_view pointer) {
    std::string slashes;
    for (const char c : pointer)
        if (c != ']') slashes += c == '.' || c == '[' ? '/' : c;
    return slashes;
}

// Throws Error where the pointer leads on with slashes for what parts its steps.
void requireSlashes(const JsonDocument& document, const PointerEnd& end, const JsonEdit& edit,
                    const std::string& path) {
    const std::string left = withSlashes(end.left), pointer = document.pointer(end.node) + left;
    if (left == end.left) return;
    const PointerEnd other = follow(document, pointer);
    const bool isKey = document.kind(other.node) == Kind::Object && other.left.rfind('/') == 0;
    if (other.node != end.node && (other.left.empty() || isKey))
        throw Error({path}, "--set " + edit.pointer + ": steps are parted by /: write " + pointer);
}

// Other text for a range of it.
struct Replacement {
    TextRange range;
    std::string text;
};

// What adds a value to the container at which a pointer ends: a member, which comes first, or a last element.
std::optional<Replacement> addition(const JsonDocument& document, std::string_view text,
                                    const PointerEnd& end, const JsonEdit& edit) {
    const std::string_view step = end.left.substr(1);
    const bool isArray = document.kind(end.node) == Kind::Array && step == "-";
    if (!isArray && (document.kind(end.node) != Kind::Object || step.find('/') != step.npos)) return {};
    const bool isEmpty = document.end(end.node) == end.node + 1;
    const char* const begin = document.begin(end.node);
    const char* const place = isArray ? valueEnd(begin, text.data() + text.size()) - 1 : begin + 1;
    const auto offset = static_cast<std::size_t>(place - text.data());
    if (isArray) return Replacement{{offset, offset}, (isEmpty ? "" : ", ") + edit.value};
    return Replacement{{offset, offset}, jsonString(keyOf(step)) + ": " + edit.value + (isEmpty ? "" : ", ")};
}

Replacement replacement(const JsonDocument& document, const std::string& path, std::string_view text,
                        const JsonEdit& edit) {
    const PointerEnd end = follow(document, edit.pointer);
    if (!end.left.empty()) {
        requireSlashes(document, end, edit, path);
        if (auto added = addition(document, text, end, edit)) return *added;
        throw Error({path}, "--set " + edit.pointer + ": " + missing(document, end));
    }
    const char* const begin = document.begin(end.node);
    return {{static_cast<std::size_t>(begin - text.data()),
             static_cast<std::size_t>(valueEnd(begin, text.data() + text.size()) - text.data())},
            edit.value};
}

// Where a range is after a part of the text, before it or within it, was replaced; of a range within that
// part nothing is left.
void move(TextRange& range, const Replacement& by) {
    const auto [begin, end] = by.range;
    const auto moved = [&, end = end, begin = begin](std::size_t at) {
        return at - (end - begin) + by.text.size();
    };
    if (range.end <= begin) return;
    if (range.begin >= end) range = {moved(range.begin), moved(range.end)};
    else range.end = range.begin <= begin && range.end >= end ? moved(range.end) : range.begin;
}

void apply(const JsonEdit& edit, const std::string& path, EditedJson& json) {
    const JsonDocument document(path, json.text, json.edits);
    const Replacement by = replacement(document, path, json.text, edit);
    for (TextRange& range : json.edits) move(range, by);
    json.edits.push_back({by.range.begin, by.range.begin + by.text.size()});
    json.text.replace(by.range.begin, by.range.end - by.range.begin, by.text);
}

}  // namespace

JsonReading readingOf(std::string_view text) {
    const auto reason = [](const Error& error) {
        const std::string& message = error.inFile();
        return error.place().column > 0 ? message.substr(message.find(": ") + 2) : message;
    };
    try {
        return {JsonDocument("", text).kind(0)};
    } catch (const NotFinite& error) {
        const char first = text[text.find_first_not_of(" \t\r\n")];
        return {first == '[' ? Kind::Array : first == '{' ? Kind::Object : Kind::Number, reason(error)};
    } catch (const Error& error) {
        return {Kind::String, reason(error)};
    }
}

JsonEdit::JsonEdit(const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals != assignment.npos && equals > 0 && !assignment.starts_with('/')) {
        // In textures/a.b the point belongs to a name.
        const std::string steps = assignment.substr(0, equals);
        const std::string slashes = steps.find('/') == steps.npos ? withSlashes(steps) : steps;
        throw Error({"raytracer"}, "--set: a pointer begins with /: write " +
                                       inQuotes("/" + slashes + assignment.substr(equals)));
    }
    if (equals == assignment.npos || !assignment.starts_with('/'))
        throw Error({"raytracer"}, "--set: expected /pointer=value, found " + inQuotes(assignment));
    pointer = assignment.substr(0, equals);
    value = assignment.substr(equals + 1);
    const JsonReading reading = readingOf(value);
    if (reading.kind == Kind::String && !reading.why.empty()) value = jsonString(value);
}

EditedJson edited(const std::string& path, std::string_view text, std::span<const std::string> assignments) {
    EditedJson json{std::string(text), {}};
    for (const std::string& assignment : assignments) apply(JsonEdit(assignment), path, json);
    return json;
}

}  // namespace raytracer
