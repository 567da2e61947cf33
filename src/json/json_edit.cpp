#include "raytracer/json/json_edit.h"

#include <algorithm>

#include "raytracer/json/json_document.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/json/json_view.h"
#include "raytracer/util/nearest_name.h"

namespace raytracer {
namespace {

bool isJson(const std::string& text) {
    try {
        const JsonDocument document("", text);
        return true;
    } catch (const Error&) {
        return false;
    }
}

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
        case Kind::Array:
            return here + " has " + std::to_string(JsonView(document, end.node).size()) +
                   " elements, from 0: " + isNot;
        default: return here + " is no object and no list";
    }
}

}  // namespace

JsonEdit::JsonEdit(const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == assignment.npos || !assignment.starts_with('/'))
        throw Error({"raytracer"}, "--set: expected /pointer=value, found " + inQuotes(assignment));
    pointer = assignment.substr(0, equals);
    value = assignment.substr(equals + 1);
    if (!isJson(value)) value = jsonString(value);
}

std::string edited(const std::string& path, std::string_view text, const JsonEdit& edit) {
    const JsonDocument document(path, text);
    const PointerEnd found = follow(document, edit.pointer);
    if (!found.left.empty()) throw Error({path}, "--set " + edit.pointer + ": " + missing(document, found));
    const char* const begin = document.begin(found.node);
    const char* const end = valueEnd(begin, text.data() + text.size());
    return std::string(text.data(), begin) + edit.value + std::string(end, text.data() + text.size());
}

}  // namespace raytracer
