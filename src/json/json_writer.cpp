#include "raytracer/json/json_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string unicodeEscape(char c) { return formatted("\\u%04x", static_cast<unsigned char>(c)); }

// Of the character that the text begins with, of which `size` bytes can be shown.
std::string escape(std::string_view text, std::size_t size) {
    if (text[0] == '"' || text[0] == '\\') return {'\\', text[0]};
    if (text[0] == '\n') return "\\n";
    return size > 0 && text[0] != '<' ? std::string(text.substr(0, size)) : unicodeEscape(text[0]);
}

}  // namespace

std::string shortestNumber(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string jsonString(std::string_view text) {
    std::string quoted = "\"";
    while (!text.empty()) {
        // U+0080 to U+009F: terminals take these as the beginning of a command.
        const bool isControl = text.size() > 1 && text[0] == '\xc2' && (text[1] & 0xe0) == 0x80;
        if (isControl) text.remove_prefix(1);
        const std::size_t size = isControl ? 0 : printableBytes(text);
        quoted += escape(text, size);
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return quoted + '"';
}

JsonWriter& JsonWriter::key(std::string_view name) {
    separate(true);
    text_ += jsonString(name) + ": ";
    afterKey_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) { return plain(jsonString(text)); }

JsonWriter& JsonWriter::value(double number) {
    return std::isfinite(number) ? plain(shortestNumber(number)) : null();
}

JsonWriter& JsonWriter::begin(char bracket) {
    separate(true);
    text_ += bracket;
    open_.emplace_back();
    return *this;
}

JsonWriter& JsonWriter::end(char bracket) {
    const bool lines = open_.back().lines;
    open_.pop_back();
    if (lines) newLine();
    text_ += bracket;
    return *this;
}

JsonWriter& JsonWriter::plain(std::string_view token) {
    separate(false);
    text_ += token;
    return *this;
}

void JsonWriter::separate(bool onItsOwnLine) {
    if (afterKey_ || open_.empty()) {
        afterKey_ = false;
        return;
    }
    Container& container = open_.back();
    if (!container.empty) text_ += onItsOwnLine ? "," : ", ";
    container.empty = false;
    if (!onItsOwnLine) return;
    container.lines = true;
    newLine();
}

void JsonWriter::newLine() {
    text_ += '\n';
    text_.append(2 * open_.size(), ' ');
}

}  // namespace raytracer
