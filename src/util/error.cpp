#include "raytracer/util/error.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

std::string afterFile(const Place& place, const std::string& message) {
    const std::string inPlace = joined({place.pointer.value_or(""), message}, ": ");
    if (place.column > 0)
        return std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + inPlace;
    return place.line > 0 ? "line " + std::to_string(place.line) + ": " + inPlace : inPlace;
}

// The characters of a line, with a blank for a tab, and a question mark for what cannot be shown.
std::vector<std::string> characters(std::string_view line) {
    std::vector<std::string> all;
    for (std::size_t size = 1; !line.empty(); line.remove_prefix(size)) {
        size = std::max<std::size_t>(utf8Bytes(line), 1);
        const bool isShown = printableBytes(line) > 0;
        all.emplace_back(line[0] == '\t' ? " " : isShown ? line.substr(0, size) : "?");
    }
    return all;
}

}  // namespace

Error::Error(Place place, const std::string& message, std::string_view line)
    : std::runtime_error(joined({place.file, afterFile(place, message)}, place.column > 0 ? ":" : ": ")),
      place_(std::move(place)),
      inFile_(afterFile(place_, message)),
      line_(line) {}

std::vector<std::string> Error::excerpt(std::size_t columns) const {
    constexpr std::size_t indent = 4, context = 20;  // context: columns before the mark if not all fit
    const std::vector<std::string> all = characters(line_);
    if (all.empty() || place_.column == 0 || columns <= indent + context) return {};
    const std::size_t mark = std::min(place_.column - 1, all.size()), most = columns - indent;
    std::vector<std::size_t> start{0};  // the column of each character, and of the end
    for (const std::string& character : all) start.push_back(start.back() + columnCount(character));
    std::size_t first = 0;
    if (start[mark] >= most)
        while (start[mark] - start[first] > context) ++first;
    std::string text(indent, ' ');
    for (std::size_t i = first; i < all.size() && start[i + 1] - start[first] <= most; ++i) text += all[i];
    return {text, std::string(indent + start[mark] - start[first], ' ') + "^"};
}

Error systemError(const std::string& file, const std::string& purpose, const std::string& more) {
    return {{file}, joined({purpose, std::generic_category().message(errno)}, ": ") + more};
}

}  // namespace raytracer
