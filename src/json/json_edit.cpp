#include "raytracer/json/json_edit.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "json_scan.h"
#include "pointer_mistake.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// The end of the value that begins at `begin`. The text must be JSON.
std::size_t valueEnd(std::string_view text, std::size_t begin) {
    if (isOneOf(text[begin], "{[")) return closingOf(text, begin) + 1;
    if (text[begin] != '"') return std::min(text.find_first_of(",]} \t\r\n", begin), text.size());
    std::size_t end = begin + 1;
    while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return end + 1;
}

using Kind = JsonDocument::Kind;

// A range of a text, and the text that replaces it.
struct Replacement {
    TextRange range;
    std::string text;
};

// The insertion that adds a value to the container at which a pointer ends: as an object's first member or an
// array's last element. Empty if the pointer does not ask for that.
std::optional<Replacement> addition(const JsonDocument& document, std::string_view text,
                                    const PointerEnd& end, const JsonEdit& edit) {
    const std::string_view step = end.left.substr(1);
    const bool isArray = document.kind(end.node) == Kind::Array && step == "-";
    if (!isArray && (document.kind(end.node) != Kind::Object || step.find('/') != step.npos)) return {};
    const bool isEmpty = document.end(end.node) == end.node + 1;
    const std::size_t begin = document.begin(end.node);
    const std::size_t offset = isArray ? valueEnd(text, begin) - 1 : begin + 1;
    if (isArray) return Replacement{{offset, offset}, (isEmpty ? "" : ", ") + edit.value};
    return Replacement{{offset, offset}, jsonString(keyOf(step)) + ": " + edit.value + (isEmpty ? "" : ", ")};
}

Replacement replacement(const JsonDocument& document, const std::string& path, std::string_view text,
                        const JsonEdit& edit) {
    const PointerEnd end = follow(document, edit.pointer);
    const auto requireNothing = [&](const std::string& wrong) {
        if (!wrong.empty()) throw Error({path}, "--set " + edit.pointer + ": " + wrong);
    };
    if (!end.left.empty()) {
        requireNothing(aboutPointerForm(document, edit.pointer));
        if (auto added = addition(document, text, end, edit)) return *added;
        requireNothing(aboutLostPointer(document, edit.pointer));
    }
    const std::size_t begin = document.begin(end.node);
    return {{begin, valueEnd(text, begin)}, edit.value};
}

// Records a replacement among the edits. Edits behind its range move, edits inside it become part of it, and
// an edit around it changes its size.
void takeIn(std::vector<EditedRange>& edits, const Replacement& by) {
    const std::size_t begin = by.range.begin, end = by.range.end;
    EditedRange now{{begin, begin + by.text.size()}, end - begin};
    std::vector<EditedRange> others;
    bool isInside = false;
    for (EditedRange edit : edits) {
        const auto move = [&](std::size_t& at) { at = at - (end - begin) + by.text.size(); };
        const bool isBehind = edit.begin >= end && edit.end > begin;
        const bool isIn = !isBehind && edit.begin >= begin && edit.end <= end;
        const bool isAround = !isBehind && !isIn && edit.end > begin;
        isInside = isInside || isAround;
        if (isBehind) move(edit.begin);
        if (isBehind || isAround) move(edit.end);
        if (isIn) now.replaced = now.replaced - (edit.end - edit.begin) + edit.replaced;
        else others.push_back(edit);
    }
    if (!isInside) others.push_back(now);
    edits = std::move(others);
}

void apply(const JsonEdit& edit, const std::string& path, EditedJson& json) {
    const JsonDocument document(path, json.text, json.edits);
    const Replacement by = replacement(document, path, json.text, edit);
    takeIn(json.edits.ranges, by);
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
        const char first = text[skipped(text, 0)];
        return {first == '[' ? Kind::Array : first == '{' ? Kind::Object : Kind::Number, reason(error)};
    } catch (const Error& error) {
        return {Kind::String, reason(error)};
    }
}

// Throws Error for "/a:1", where "/a=1" was meant, and for "/a=1,/b/c=2", which are two edits. "/a=x,/b=2" is
// allowed: the value may be a name.
static void refuseOtherSigns(const std::string& assignment) {
    const std::size_t equals = assignment.find('='), colon = assignment.find(':');
    if (equals == assignment.npos && colon != assignment.npos && assignment.starts_with('/'))
        throw Error({"raytracer"}, "--set " + assignment.substr(0, colon) + ": write = for the : behind it");
    for (std::size_t comma = equals; (comma = assignment.find(',', comma + 1)) != assignment.npos;) {
        const std::size_t begin = std::min(assignment.find_first_not_of(' ', comma + 1), assignment.size());
        const std::size_t next = assignment.find('=', begin);
        const std::string pointer = assignment.substr(begin, next - begin);
        const bool isPointer = next != assignment.npos && pointer.starts_with('/') &&
                               pointer.find('/', 1) != pointer.npos &&
                               pointer.find_first_of(" \"{[,") == pointer.npos;
        if (isPointer && !readingOf(assignment.substr(equals + 1)).why.empty())
            throw Error({"raytracer"}, "--set has one value: write another --set before " + pointer);
    }
}

JsonEdit::JsonEdit(const std::string& assignment) {
    refuseOtherSigns(assignment);
    const std::size_t equals = assignment.find('=');
    if (equals == assignment.npos || equals == 0)
        throw Error({"raytracer"}, "--set: expected /pointer=value, found " + inQuotes(assignment));
    pointer = assignment.substr(0, equals);
    value = assignment.substr(equals + 1);
    const JsonReading reading = readingOf(value);
    if (reading.kind == Kind::String && !reading.why.empty()) value = jsonString(value);
}

EditedJson edited(const std::string& path, std::string_view text, std::span<const std::string> assignments) {
    EditedJson json{std::string(text), {{}, text}};
    for (const std::string& assignment : assignments) apply(JsonEdit(assignment), path, json);
    return json;
}

}  // namespace raytracer
