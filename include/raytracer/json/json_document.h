// A JSON text as a flat tree: 16 bytes a value and 16 a key, in one vector; strings stay where they are in
// the text.
//
// nlohmann::json would hold a std::map for each object and let the last of two equal keys win in silence;
// this finds duplicate keys, and lets each value say its JSON pointer (RFC 6901) without storing it.
#pragma once

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// what() is the part of a SceneError after the file's name: ":LINE:COLUMN: ...", ": /json/pointer: ...", or,
// about the whole document, ": ...".
struct JsonError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class JsonDocument {
  public:
    // A member of an object is two nodes: its key, then its value.
    enum class Kind : std::uint8_t { Null, Boolean, Number, String, Array, Object, Key };

    struct Node {
        union {
            double number;     // of a Number, always finite; of a Boolean, 0 or 1
            const char* text;  // of a String or a Key
        };
        union {
            std::uint32_t length;  // of a String or a Key, in bytes
            std::uint32_t end;     // of an Array or an Object: the first node behind all that is in it
        };
        Kind kind;
    };

    // UTF-8, with a byte order mark or without; it must outlive the document. Throws JsonError for what is no
    // JSON, for a key that an object has twice, and for a number too large for a double. Nesting of any depth
    // takes no stack.
    JsonDocument(const char* begin, const char* end);
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    // The root is node 0; a container's first element or key is the node after it.
    const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    std::string_view string(std::uint32_t node) const { return {nodes_[node].text, nodes_[node].length}; }

    // The first node behind this value and all in it: its next sibling or that one's key, if it has one.
    std::uint32_t end(std::uint32_t node) const { return isContainer(node) ? nodes_[node].end : node + 1; }

    std::string pointer(std::uint32_t node) const;  // empty for the root

    // A JsonError at a value, with its JSON pointer.
    [[noreturn]] void fail(std::uint32_t node, const std::string& message) const;

  private:
    friend class JsonNodes;

    bool isContainer(std::uint32_t node) const {
        return nodes_[node].kind == Kind::Array || nodes_[node].kind == Kind::Object;
    }

    std::vector<Node> nodes_;
    std::deque<std::string> strings_;  // those that are not in the text as they are
};

// `text` in quotes with control characters escaped, for a message; shortened if it is long.
std::string inQuotes(std::string_view text);

// The JSON pointer that leads from `pointer` to its member `key`.
std::string pointerToMember(std::string pointer, std::string_view key);

}  // namespace raytracer
