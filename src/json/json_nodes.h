// The nodes of a JsonDocument while they are made: what both of its parsers write with.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "raytracer/json/json_document.h"

namespace raytracer {

class JsonNodes {
  public:
    using Kind = JsonDocument::Kind;
    using Node = JsonDocument::Node;

    explicit JsonNodes(JsonDocument& document) : document_(document), nodes_(document.nodes_) {}

    void clear() { nodes_.clear(), open_.clear(); }
    void reserve(std::size_t count) { nodes_.reserve(count); }

    void addNumber(Kind kind, double number) {
        Node& node = add(kind);
        node.number = number;
    }
    // Of a String or a Key, whose text must outlive the document, or be kept by it.
    void addText(Kind kind, std::string_view text) {
        Node& node = add(kind);
        node.text = text.data();
        node.length = static_cast<std::uint32_t>(text.size());
    }
    std::string_view keep(const std::string& text) { return document_.strings_.emplace_back(text); }

    void open(Kind kind) {
        open_.push_back(size());
        add(kind).end = std::numeric_limits<std::uint32_t>::max();  // for now: see JsonDocument::pointer
    }
    void close() {
        nodes_[open_.back()].end = size();
        open_.pop_back();
    }

    bool anyOpen() const { return !open_.empty(); }
    bool isInObject() const { return nodes_[open_.back()].kind == Kind::Object; }
    std::uint32_t innermost() const { return open_.back(); }
    std::uint32_t last() const { return size() - 1; }

    // A key that the innermost object has twice, or null.
    const Node* twice();

  private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
    Node& add(Kind kind) {
        if (nodes_.size() == std::numeric_limits<std::uint32_t>::max()) throw JsonError(": too many values");
        Node& node = nodes_.emplace_back();
        node.kind = kind;
        return node;
    }

    JsonDocument& document_;
    std::vector<Node>& nodes_;
    std::vector<std::uint32_t> open_;  // containers, the innermost last
    std::vector<const Node*> keys_;
};

// The usual text of a scene, fast: false, and nothing said, where there is anything else in it (an escape
// sequence, a letter beyond ASCII, an error of any kind), so that nlohmann's parser must look at it.
bool scanPlainJson(std::string_view text, JsonNodes& nodes);

}  // namespace raytracer
