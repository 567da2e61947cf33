// A JSON text as a flat tree in one vector: 16 bytes for a value and 16 for a key. Every node knows where it
// begins in the text; strings are not copied.
//
// nlohmann::json would hold a std::map for each object, and would silently keep
// the last of two equal keys. A JsonDocument refuses duplicate keys. It computes
// a value's JSON pointer (RFC 6901) and line only when they are asked for.
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

// A range of a text, in bytes.
struct TextRange {
    std::size_t begin = 0, end = 0;
};

// A range of an edited text that is not from the file, and the number of the file's bytes that it replaces.
struct EditedRange : TextRange {
    std::size_t replaced = 0;
};

// Ranges that do not overlap, and the file's original text, which must outlive them.
struct TextEdits {
    std::vector<EditedRange> ranges;
    std::string_view original;
};

// The text has a number that is too large for a double.
struct NotFinite : Error {
    explicit NotFinite(const Error& error) : Error(error) {}
};

// The text is not JSON. If the message proposes to replace `range` of the text, `instead` is the replacement.
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

    // Parses the text of the file `path`: UTF-8, with or without a byte order mark. The text must outlive the
    // document. Throws Error if the text is not JSON, if an object has a key twice, if a number is too large
    // for a double, and if lists and objects are nested more than 256 deep. `edits` are the ranges of the
    // text that come from --set.
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

    std::size_t begin(std::uint32_t node) const;    // offset in the text
    std::string pointer(std::uint32_t node) const;  // empty for the root

    bool isEdited(std::uint32_t node) const;

    // An Error about a value, with the value's line, column and JSON pointer. If the value is edited, it has
    // the pointer and "by --set" instead.
    Error error(std::uint32_t node, const std::string& message) const { return error(node, message, node); }
    // The same, with the line and the column of another node.
    Error error(std::uint32_t node, const std::string& message, std::uint32_t where) const;

  private:
    friend class JsonReader;

    // A String or a Key with an escape sequence: its text is decoded, so it differs from the JSON text.
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
            std::uint32_t end;        // of an Array or an Object: the first node after its contents
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
