// A JSON text as a flat tree: 32 bytes a value in one vector, each distinct string once.
//
// nlohmann::json would hold a std::map for each object and let the last of two equal keys win in silence; this takes
// its parser's events, finds duplicate keys, and lets each value say its JSON pointer (RFC 6901) without storing it.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace raytracer {

// what() is the part of a SceneError after the file's name: ":LINE:COLUMN: ...", ": /json/pointer: ...", or, about the
// whole document, ": ...".
struct JsonError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Each distinct string once, numbered from 0 in order of first appearance.
class StringPool {
  public:
    std::uint32_t add(const std::string& text);
    const std::string& operator[](std::uint32_t id) const { return *texts_[id]; }

  private:
    std::unordered_map<std::string, std::uint32_t> ids_;
    std::vector<const std::string*> texts_;  // the keys of ids_, which stay where they are
};

class JsonDocument {
  public:
    enum class Kind : std::uint8_t { Null, Boolean, Number, String, Array, Object };

    struct Node {
        double number = 0;         // of a Number, always finite; of a Boolean, 0 or 1
        std::uint32_t string = 0;  // of a String, in the pool
        std::uint32_t key = 0;     // of an Object's member, in the pool
        std::uint32_t parent = 0;
        std::uint32_t end = 0;  // the first node behind this value and all in it: its next sibling, if it has one
        Kind kind = Kind::Null;
    };

    // UTF-8, with a byte order mark or without. Throws JsonError for what is no JSON, for a key that an object has
    // twice, and for a number too large for a double. Nesting of any depth takes no stack.
    JsonDocument(const char* begin, const char* end);

    // The root is node 0; a container's first element is the node after it.
    const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    const std::string& string(const Node& node) const { return strings_[node.string]; }
    const std::string& key(const Node& node) const { return strings_[node.key]; }

    std::string pointer(std::uint32_t node) const;  // empty for the root

    // A JsonError at a value, with its JSON pointer.
    [[noreturn]] void fail(std::uint32_t node, const std::string& message) const;

  private:
    friend class JsonReader;  // json_reader.cpp, where the constructor is too

    std::uint32_t positionInArray(std::uint32_t node) const;

    std::vector<Node> nodes_;
    StringPool strings_;
};

// `text` in quotes with control characters escaped, for a message; shortened if it is long.
std::string inQuotes(std::string_view text);

// The JSON pointer that leads from `pointer` to its member `key`.
std::string pointerToMember(std::string pointer, std::string_view key);

}  // namespace raytracer
