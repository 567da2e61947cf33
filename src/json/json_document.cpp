#include "raytracer/json/json_document.h"

#include <algorithm>

#include "raytracer/json/json_pointer.h"

namespace raytracer {

std::string_view JsonDocument::string(std::uint32_t node) const {
    const Node& n = nodes_[node];
    return n.isDecoded ? std::string_view(n.decoded->text) : std::string_view(n.begin + 1, n.length);
}

std::size_t JsonDocument::begin(std::uint32_t node) const {
    const Node& n = nodes_[node];
    if (n.kind == Kind::Number) return std::uint64_t{n.offsetHigh} << 32 | n.offsetLow;
    return static_cast<std::size_t>((n.isDecoded ? n.decoded->begin : n.begin) - text_.data());
}

// Goes down from the root. This works while the text is parsed, too: a container that is not closed yet has
// an end beyond all nodes, so it contains the last one.
std::string JsonDocument::pointer(std::uint32_t node) const {
    std::string pointer;
    for (std::uint32_t at = 0; at != node;) {
        const bool isObject = kind(at) == Kind::Object;
        std::uint32_t child = at + 1 + isObject, position = 0;
        for (; end(child) <= node; ++position) child = end(child) + isObject;
        pointer += shownStep(isObject ? string(child - 1) : std::to_string(position));
        at = child;
    }
    return pointer;
}

bool JsonDocument::isEdited(std::uint32_t node) const {
    const std::size_t offset = begin(node);
    return std::ranges::any_of(
        edits_.ranges, [&](const TextRange& edit) { return edit.begin <= offset && offset < edit.end; });
}

Error JsonDocument::error(std::uint32_t node, const std::string& message, std::uint32_t where) const {
    if (isEdited(where))
        return {{path_}, (node == 0 ? "the scene" : pointer(node)) + ", by --set: " + message};
    Place at = place(begin(where));
    at.pointer = pointer(node);
    return {at, message};
}

}  // namespace raytracer
