#include "json_document.h"

#include <algorithm>

#include "raytracer/json_writer.h"

namespace raytracer {

std::uint32_t StringPool::add(const std::string& text) {
    const auto [entry, isNew] = ids_.try_emplace(text, static_cast<std::uint32_t>(texts_.size()));
    if (isNew) texts_.push_back(&entry->first);
    return entry->second;
}

std::uint32_t JsonDocument::positionInArray(std::uint32_t node) const {
    std::uint32_t position = 0;
    for (std::uint32_t i = nodes_[node].parent + 1; i != node; i = nodes_[i].end) ++position;
    return position;
}

std::string JsonDocument::pointer(std::uint32_t node) const {
    std::vector<std::uint32_t> path;
    for (; node != 0; node = nodes_[node].parent) path.push_back(node);
    std::string pointer;
    for (auto i = path.rbegin(); i != path.rend(); ++i) {
        const bool isMember = nodes_[nodes_[*i].parent].kind == Kind::Object;
        pointer = pointerToMember(std::move(pointer), isMember ? key(nodes_[*i]) : std::to_string(positionInArray(*i)));
    }
    return pointer;
}

void JsonDocument::fail(std::uint32_t node, const std::string& message) const {
    throw JsonError((node == 0 ? "" : ": " + pointer(node)) + ": " + message);
}

// Long enough for any name that people give, short enough for one line of a terminal.
std::string inQuotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    if (text.size() <= longest) return jsonString(text);
    std::size_t end = longest;
    const auto isInCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };  // UTF-8
    while (end > 0 && isInCharacter(text[end])) --end;
    return jsonString(text.substr(0, end)) + "...";
}

std::string pointerToMember(std::string pointer, std::string_view key) {
    pointer += '/';
    const std::string escaped = jsonString(key);
    for (const char c : std::string_view(escaped).substr(1, escaped.size() - 2)) {
        if (c == '~') pointer += "~0";
        else if (c == '/') pointer += "~1";
        else pointer += c;
    }
    return pointer;
}

}  // namespace raytracer
