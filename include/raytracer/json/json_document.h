// A JSON text as a flat tree: 16 bytes a value and 16 a key, in one vector. Every node knows where it begins
// in the text; strings stay there.
//
// nlohmann::json would hold a std::map for each object, and of two equal keys it would keep the last in
// silence. A JsonDocument refuses duplicate keys. It computes a value's JSON pointer (RFC 6901) and line only
// when they are asked for.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracer/util/error.h"
#include "raytracer/util/large_vector.h"
#include "raytracer/util/text.h"

namespace raytracer {

// Of a text, in bytes.
struct TextRange {
    std::size_t begin = 0, end = 0;
};

// Of an edited text: what is not the file's, and how many of the file's bytes it stands for.
struct EditedRange : TextRange {
    std::size_t replaced = 0;
};

// Ranges that do not overlap, and the file's text, which must outlive them.
struct TextEdits {
    std::vector<EditedRange> ranges;
    std::string_view original;
};

// What is wrong is a number that a double cannot hold.
struct NotFinite : Error {
    explicit NotFinite(const Error& error) : Error(error) {}
};

// The text is no JSON. Where the message proposes other text for a range of it, `instead` is that.
struct NoJson : Error {
    NoJson(const Error& error, TextRange where, std::string proposed)
        : Error(error), range(where), instead(std::move(proposed)) {}
    TextRange range;
    std::string instead;
};

class JsonDocument {
  public:
    // A member of an object is two nodes: its key, then its value.
    enum class Kind : std::uint8_t { Null, Boolean, Number, String, Array, Object, Key };

    // The text of the file `path`: UTF-8, with a byte order mark or without. It must outlive the document.
    // Throws Error for what is no JSON, for a key that an object has twice, and for a number too large for a
    // double. Deep nesting does not use the stack. `edits`: what of the text is not the file's, but --set's.
    JsonDocument(std::string path, std::string_view text, TextEdits edits = {});
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    // The root is node 0; a container's first element or key is the node after it.
    Kind kind(std::uint32_t node) const { return nodes_[node].kind; }
    bool boolean(std::uint32_t node) const { return *nodes_[node].begin == 't'; }
    double number(std::uint32_t node) const { return nodes_[node].number; }  // finite
    std::string_view string(std::uint32_t node) const;                       // of a String or a Key

    // The first node after this value and all that is in it: the next sibling, or in an object its key.
    std::uint32_t end(std::uint32_t node) const { return isContainer(node) ? nodes_[node].end : node + 1; }

    std::size_t begin(std::uint32_t node) const;    // in the text
    std::string pointer(std::uint32_t node) const;  // empty for the root

    bool isEdited(std::uint32_t node) const;

    // An Error about a value, with the value's line, column and JSON pointer; about one that is edited, with
    // the pointer and "by --set".
    Error error(std::uint32_t node, const std::string& message) const { return error(node, message, node); }
    // The same, with the line and the column of another node.
    Error error(std::uint32_t node, const std::string& message, std::uint32_t where) const;

  private:
    friend class JsonReader;

    // A String or a Key with an escape sequence, so that the text does not have it as it is.
    struct Decoded {
        std::string text;
        const char* begin;
    };

    struct Node {
        union {
            const char* begin;       // in the text
            const Decoded* decoded;  // where isDecoded
            double number;           // of a Number, which begins at text_[offset]
        };
        union {
            std::uint32_t length;     // of a String or a Key, in bytes
            std::uint32_t end;        // of an Array or an Object: the first node after all that is in it
            std::uint32_t offsetLow;  // of a Number
        };
        std::uint16_t offsetHigh;
        Kind kind;
        bool isDecoded;
    };
    static_assert(sizeof(Node) == 16);

    std::size_t originalOffset(std::size_t offset) const;  // in the file's text
    Place place(std::size_t offset) const;                 // line and column of text_[offset], in the file
    Error syntaxError(std::size_t offset, const std::string& message) const;  // with the line's text
    bool isContainer(std::uint32_t node) const {
        return kind(node) == Kind::Array || kind(node) == Kind::Object;
    }

    std::string path_;
    std::string_view text_;
    TextEdits edits_;
    LargeVector<Node> nodes_;
    std::deque<Decoded> decoded_;
};

}  // namespace raytracer
