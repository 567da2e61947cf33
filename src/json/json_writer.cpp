#include "raytracer/json/json_writer.h"

#include <charconv>
#include <cmath>

#include "raytracer/util/text.h"

namespace raytracer {

std::string shortestNumber(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
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
