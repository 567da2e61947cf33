#include "json_scan.h"

#include <vector>

namespace raytracer {
namespace {

struct Opened {
    std::size_t place, indent;           // the bracket's offset, and the indentation of its line
    std::optional<std::size_t> members;  // their indentation; npos if the first is on the bracket's line
};

bool isKey(std::string_view line, std::size_t indent) {
    if (line[indent] != '"') return false;
    const std::size_t end = line.find('"', indent + 1);
    const std::size_t next = end == line.npos ? end : line.find_first_not_of(" \t", end + 1);
    return next != line.npos && line[next] == ':';
}

// Whether the line's indentation says that it is not in the object. Only tells of a line that begins with a
// key, or closes an object that has members.
bool isOutdented(Opened& object, std::string_view line, std::size_t indent) {
    if (line[indent] == '}') return indent < object.indent && object.members.value_or(0) > indent;
    if (!isKey(line, indent)) return false;
    if (!object.members) object.members = indent;
    return indent <= object.indent && *object.members > indent;
}

void followBrackets(std::vector<Opened>& open, std::string_view text, std::string_view line,
                    std::size_t indent) {
    const auto begin = static_cast<std::size_t>(line.data() - text.data());
    outsideTexts(line, indent, [&](std::size_t at) {
        if (isOneOf(line[at], "{[")) {
            open.push_back({begin + at, indent, {}});
            const std::size_t next = line.find_first_not_of(" \t\r", at + 1);
            if (next != line.npos) open.back().members = line.npos;
        }
        if (isOneOf(line[at], "}]") && !open.empty()) open.pop_back();
        return true;
    });
}

}  // namespace

std::ptrdiff_t excess(std::string_view text, char closing) {
    const char opening = closing == '}' ? '{' : '[';
    std::ptrdiff_t count = 0;
    outsideTexts(text, 0, [&](std::size_t at) {
        count += (text[at] == closing) - (text[at] == opening);
        return true;
    });
    return count;
}

std::size_t closingOf(std::string_view text, std::size_t opening) {
    std::size_t end = text.size();
    int depth = 0;
    outsideTexts(text, opening, [&](std::size_t at) {
        depth += isOneOf(text[at], "([{") - isOneOf(text[at], ")]}");
        if (depth == 0) end = at;
        return depth > 0;
    });
    return end;
}

std::optional<Outdented> outdented(std::string_view text) {
    std::vector<Opened> open;
    for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
        end = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, end - start);
        const std::size_t indent = line.find_first_not_of(" \t\r");
        if (indent == line.npos) continue;
        const bool isInObject = open.size() > 1 && text[open.back().place] == '{';
        if (isInObject && isOutdented(open.back(), line, indent))
            return Outdented{start + indent, open.back().place};
        followBrackets(open, text, line, indent);
    }
    return {};
}

}  // namespace raytracer
