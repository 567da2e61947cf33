#include "raytracer/json/json_edit.h"

#include <algorithm>
#include <optional>

#include "raytracer/json/json_document.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"

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

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string escaped(const std::string& key) { return replaced(replaced(key, "~", "~0"), "/", "~1"); }
std::string unescaped(const std::string& token) { return replaced(replaced(token, "~1", "/"), "~0", "~"); }

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

// Goes down a document, along the tokens of a pointer.
class Descent {
  public:
    Descent(const JsonDocument& document, std::string path, const std::string& pointer)
        : document_(document), path_(std::move(path)), pointer_(pointer) {}

    std::uint32_t follow() {
        for (std::size_t begin = 1; begin <= pointer_.size() && !pointer_.empty();) {
            const std::size_t end = std::min(pointer_.find('/', begin), pointer_.size());
            step(unescaped(pointer_.substr(begin, end - begin)), pointer_.substr(end));
            begin = end + 1;
        }
        return node_;
    }

  private:
    using Kind = JsonDocument::Kind;

    void step(const std::string& token, const std::string& rest) {
        const Kind kind = document_.kind(node_);
        if (kind == Kind::Object) node_ = member(token, rest);
        else if (kind == Kind::Array) node_ = element(token);
        else fail(here() + " is no object and no list");
    }

    std::uint32_t member(const std::string& token, const std::string& rest) const {
        NearestName nearest(token);
        for (std::uint32_t key = node_ + 1; key < document_.end(node_); key = document_.end(key + 1)) {
            if (document_.string(key) == token) return key + 1;
            nearest.consider(document_.string(key));
        }
        const std::string instead = document_.pointer(node_) + "/" + escaped(nearest.name()) + rest;
        fail("there is no " + inQuotes(token) + " in " + here() +
             (nearest.found() ? "; did you mean " + instead + "?" : ""));
    }

    std::uint32_t element(const std::string& token) const {
        std::uint32_t size = 0, found = 0;
        for (std::uint32_t node = node_ + 1; node < document_.end(node_); node = document_.end(node), ++size)
            if (std::to_string(size) == token) found = node;
        if (found > 0) return found;
        fail(here() + " has " + std::to_string(size) + " elements, from 0: there is no " + inQuotes(token));
    }

    std::string here() const { return node_ == 0 ? "the scene" : document_.pointer(node_); }
    [[noreturn]] void fail(const std::string& message) const {
        throw Error({path_}, "--set " + pointer_ + ": " + message);
    }

    const JsonDocument& document_;
    std::string path_, pointer_;
    std::uint32_t node_ = 0;
};

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
    const std::uint32_t node = Descent(document, path, edit.pointer).follow();
    const char* const begin = document.begin(node);
    const char* const end = valueEnd(begin, text.data() + text.size());
    return std::string(text.data(), begin) + edit.value + std::string(end, text.data() + text.size());
}

}  // namespace raytracer
