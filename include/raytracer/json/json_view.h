// Reads a value of a JsonDocument as the type that it must have. If it has another type, throws an Error with
// the value's place: "scene.json: /camera/eye: expected 3 numbers, found a list of 2".
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "raytracer/json/json_document.h"

namespace raytracer {

// A view is two machine words, and passed by value. The document must outlive it.
class JsonView {
  public:
    class Iterator;
    struct Children;

    explicit JsonView(const JsonDocument& document, std::uint32_t node = 0)
        : document_(&document), node_(node) {}

    JsonDocument::Kind kind() const { return document_->kind(node_); }
    bool boolean() const;
    double number() const;
    std::string_view string() const;
    // Reads an array of exactly out.size() numbers. `expected` is what an error message calls it; by default,
    // "3 numbers" and the like.
    void numbers(std::span<double> out, const std::string& expected = {}) const;
    glm::dvec3 vec3() const;

    // The position of this string in `choices`.
    std::size_t choice(std::span<const std::string_view> choices) const;

    std::string_view key() const;  // of an object's member
    Children elements() const;     // of an array
    Children members() const;      // of an object
    std::size_t size() const;      // of either, else 0; takes linear time
    JsonView element(std::size_t index) const;

    // Throws unless this is an array of `count` elements. `expected` is what the message calls that.
    void requireElements(std::size_t count, const char* expected) const;

    std::optional<JsonView> find(std::string_view key) const;  // an object's member
    bool isString(std::string_view text) const;

    std::string pointer() const { return document_->pointer(node_); }
    Error error(const std::string& message) const { return document_->error(node_, message); }
    // An Error about this object, with the line and column of a member's key.
    Error errorAtKey(JsonView member, const std::string& message) const {
        return document_->error(node_, message, member.node_ - 1);
    }
    // Whether this member's key comes from --set, so that the whole member does.
    bool hasEditedKey() const { return document_->isEdited(node_ - 1); }
    [[noreturn]] void fail(const std::string& message) const { throw error(message); }
    // Throws "expected ..., found " and this value. `wanted` is the expected kind: if this is a string that
    // contains such a value, the message says to remove the quotes.
    [[noreturn]] void failExpected(const std::string& expected,
                                   JsonDocument::Kind wanted = JsonDocument::Kind::String) const;

  private:
    void require(JsonDocument::Kind wanted, const char* expected) const {
        if (kind() != wanted) failExpected(expected, wanted);
    }
    std::string inWords() const;
    bool hasKey() const;
    bool isColor() const;
    [[noreturn]] void failExpectedNumbers(const std::string& expected, std::size_t count) const;
    std::string numbersMeant(std::size_t count) const;
    std::vector<std::string> coordinates() const;
    std::string whyText(JsonDocument::Kind wanted) const;
    std::string form(JsonDocument::Kind wanted) const;

    const JsonDocument* document_;
    std::uint32_t node_;
};

class JsonView::Iterator {
  public:
    // `ahead`: the number of nodes from a sibling's end to
    // the next value: 1 in an object, for the key; else 0.
    Iterator(const JsonDocument& document, std::uint32_t node, std::uint32_t ahead)
        : document_(&document), node_(node), ahead_(ahead) {}
    JsonView operator*() const { return JsonView(*document_, node_ + ahead_); }
    Iterator& operator++() {
        node_ = document_->end(node_ + ahead_);
        return *this;
    }
    bool operator==(const Iterator& other) const { return node_ == other.node_; }

  private:
    const JsonDocument* document_;
    std::uint32_t node_, ahead_;
};

struct JsonView::Children {
    Iterator first, last;
    Iterator begin() const { return first; }
    Iterator end() const { return last; }
};

}  // namespace raytracer
