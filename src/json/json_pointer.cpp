#include "raytracer/json/json_pointer.h"

#include <algorithm>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// The child to which a step leads, or 0 if there is none: node 0 is the root, and nobody's child.
std::uint32_t childOf(const JsonDocument& document, std::uint32_t node, std::string_view step) {
    const bool isObject = document.kind(node) == JsonDocument::Kind::Object;
    if (!isObject && document.kind(node) != JsonDocument::Kind::Array) return 0;
    std::size_t position = 0;
    for (std::uint32_t at = node + 1; at < document.end(node); at = document.end(at + isObject), ++position)
        if (pointerStep(isObject ? document.string(at) : std::to_string(position)) == step)
            return at + isObject;
    return 0;
}

}  // namespace

std::string pointerStep(std::string_view key) {
    std::string step = "/";
    for (const char c : key) {
        if (c == '~') step += "~0";
        else if (c == '/') step += "~1";
        else step += c;
    }
    return step;
}

std::string shownStep(std::string_view key) {
    const std::string shown = inQuotes(key);
    return shown.ends_with('"') ? pointerStep(key) : "/" + shown;  // "text" or "the beginning of a text"...
}

std::string keyOf(std::string_view step) {
    std::string key;
    for (std::size_t i = 0; i < step.size(); ++i) {
        const bool isEscape =
            step[i] == '~' && i + 1 < step.size() && (step[i + 1] == '0' || step[i + 1] == '1');
        if (isEscape) key += step[++i] == '0' ? '~' : '/';
        else key += step[i];
    }
    return key;
}

PointerEnd follow(const JsonDocument& document, std::string_view pointer, std::uint32_t from) {
    PointerEnd end{from, pointer};
    while (!end.left.empty()) {
        const std::size_t size = std::min(end.left.find('/', 1), end.left.size());
        const std::uint32_t child = childOf(document, end.node, end.left.substr(0, size));
        if (child == 0) break;
        end = {child, end.left.substr(size)};
    }
    return end;
}

}  // namespace raytracer
