// JsonDocument from text: its nodes are the events of nlohmann's parser.
#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>

#include <nlohmann/json.hpp>

#include "raytracer/json/json_document.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// nlohmann's parser copies its iterator. All copies of this one share their position, so the handler of the
// events knows how far the parser has read.
class CountingIterator {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    explicit CountingIterator(const char*& place) : place_(&place) {}
    reference operator*() const { return **place_; }
    CountingIterator& operator++() {
        ++*place_;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return *place_ == *other.place_; }

  private:
    const char** place_;
};

// "[...] parse error at line 1, column 2: syntax error while parsing value - what; last read: 'token';
// expected this": keeps "what; expected this". The quotation may be as long as the file.
std::string reasonOf(std::string message, const std::string& token) {
    message.erase(0, message.find(" - ") + 3);
    const std::string quotation = "; last read: '" + token + "'";
    if (const auto at = message.find(quotation); at != message.npos) message.erase(at, quotation.size());
    return message;
}

// Where an error is. The parser has read up to `end`: either a whole token that is not expected, and then the
// error is where that begins; or part of one, whose last character is the error.
std::size_t blamed(std::string_view text, std::size_t end, std::string_view reason,
                   const std::string& token) {
    const std::size_t last = end - 1;
    if (!reason.starts_with("unexpected ") || end > text.size()) return last;
    if (text[last] == '"') return end - token.size();
    if (!std::isalnum(static_cast<unsigned char>(text[last]))) return last;
    return text.find_last_of(" \t\r\n,:[]{}\"", last) + 1;  // npos + 1 is 0
}

}  // namespace

// Handles the events of nlohmann's SAX interface, which gives these functions their names. It throws rather
// than return false.
class JsonReader {
    using Kind = JsonDocument::Kind;
    using Node = JsonDocument::Node;

  public:
    explicit JsonReader(JsonDocument& document)
        : document_(document), nodes_(document.nodes_), text_(document.text_) {
        behindLast_ = read_ + (text_.starts_with(byteOrderMark) ? byteOrderMark.size() : 0);
    }

    void read() {
        constexpr std::size_t bytesForNode = 8;  // an estimate; memory that is not written to costs nothing
        nodes_.reserve(text_.size() / bytesForNode);
        const char* end = text_.data() + text_.size();
        nlohmann::json::sax_parse(CountingIterator(read_), CountingIterator(end), this);
        requireNoNul();
    }

    bool null() { return add(Kind::Null); }
    bool boolean(bool) { return add(Kind::Boolean); }
    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(value); }
    bool binary(std::vector<std::uint8_t>&) { return false; }  // JSON text has none
    bool string(std::string& value) { return text(Kind::String, value); }
    bool key(std::string& value) { return text(Kind::Key, value); }

    bool start_object(std::size_t) { return open(Kind::Object); }
    bool start_array(std::size_t) { return open(Kind::Array); }
    bool end_object() {
        requireKeysOnce();
        return end_array();
    }
    bool end_array() {
        nodes_[open_.back()].end = count();
        open_.pop_back();
        behindLast_ = read_;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error);

  private:
    std::uint32_t count() const { return static_cast<std::uint32_t>(nodes_.size()); }
    // The parser takes a NUL for the end of the text.
    void requireNoNul() const {
        if (read_ != text_.data() && read_[-1] == '\0')
            throw Error(document_.place(static_cast<std::size_t>(read_ - 1 - text_.data())),
                        "unexpected NUL");
    }
    [[noreturn]] void fail(std::uint32_t node, const std::string& message) const {
        throw document_.error(node, message);
    }

    bool add(Kind kind);
    bool number(double value);
    bool text(Kind kind, std::string& value);
    bool open(Kind kind);
    void requireKeysOnce();

    JsonDocument& document_;
    std::vector<Node>& nodes_;
    const std::string_view text_;
    const char* read_ = text_.data();  // how far the parser has read
    const char* behindLast_;           // the same, at the last event
    std::vector<std::uint32_t> open_;  // containers, the innermost last
    std::vector<std::string_view> keys_;
};

// A node begins after the last event, behind blanks, a comma or a colon. After a number, the parser has read
// one character more, but never the first of another value.
bool JsonReader::add(Kind kind) {
    if (nodes_.size() == std::numeric_limits<std::uint32_t>::max()) fail(0, "too many values");
    const char* begin = behindLast_;
    while (*begin == ' ' || *begin == '\n' || *begin == '\t' || *begin == '\r' || *begin == ',' ||
           *begin == ':')
        ++begin;
    Node& node = nodes_.emplace_back();
    node.begin = begin;
    node.kind = kind;
    behindLast_ = read_;
    return true;
}

bool JsonReader::number(double value) {
    add(Kind::Number);
    Node& node = nodes_.back();
    const auto offset = static_cast<std::uint64_t>(node.begin - text_.data());
    node.offsetLow = static_cast<std::uint32_t>(offset);
    node.offsetHigh = static_cast<std::uint16_t>(offset >> 32);
    node.number = value;
    return true;
}

// Text with an escape sequence is longer than what it stands for.
bool JsonReader::text(Kind kind, std::string& value) {
    add(kind);
    Node& node = nodes_.back();
    if (value.size() > std::numeric_limits<std::uint32_t>::max()) fail(count() - 1, "a string of over 4 GiB");
    node.length = static_cast<std::uint32_t>(value.size());
    node.isDecoded = read_ - node.begin != static_cast<std::ptrdiff_t>(value.size() + 2);
    if (node.isDecoded) {
        document_.decoded_.push_back({std::move(value), node.begin});
        node.decoded = &document_.decoded_.back();
    }
    return true;
}

bool JsonReader::open(Kind kind) {
    constexpr std::size_t deepest = 256;  // a scene has 5
    open_.push_back(count());
    add(kind);
    if (open_.size() > deepest)
        throw Error(document_.place(static_cast<std::size_t>(nodes_.back().begin - text_.data())),
                    "expected at most 256 lists and objects inside of each other");
    nodes_.back().end = std::numeric_limits<std::uint32_t>::max();  // until closed: see pointer()
    return true;
}

// Once for each object, not at each key, so that the time for a million keys is not quadratic.
void JsonReader::requireKeysOnce() {
    constexpr std::size_t few = 8;  // most objects have no more; sorting is not worth it
    keys_.clear();
    for (std::uint32_t key = open_.back() + 1; key < count(); key = document_.end(key + 1))
        keys_.push_back(document_.string(key));
    auto twice = keys_.begin();
    if (keys_.size() > few) {
        std::ranges::sort(keys_);
        twice = std::ranges::adjacent_find(keys_);
    } else {
        while (twice != keys_.end() && std::find(keys_.begin(), twice, *twice) == twice) ++twice;
    }
    if (twice != keys_.end())
        fail(open_.back(), "expected each key once, found " + inQuotes(*twice) + " twice");
}

bool JsonReader::parse_error(std::size_t position, const std::string& token,
                             const nlohmann::json::exception& error) {
    constexpr int numberOverflow = 406;  // nlohmann's documentation: json.exception.out_of_range.406
    if (error.id == numberOverflow) {
        number(0);  // a node in the number's place
        fail(count() - 1, "expected a finite number, found " + token.substr(0, 40));
    }
    requireNoNul();
    const std::string reason = reasonOf(error.what(), token);
    throw Error(document_.place(blamed(text_, position, reason, token)), reason);
}

JsonDocument::JsonDocument(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {
    if (isUtf16(text)) throw Error({path_}, "expected UTF-8, found UTF-16");
    JsonReader(*this).read();
}

Place JsonDocument::place(std::size_t offset) const {
    std::string_view before = text_.substr(0, offset);
    if (before.starts_with(byteOrderMark)) before.remove_prefix(byteOrderMark.size());  // has no width
    const auto lines = std::ranges::count(before, '\n');
    before.remove_prefix(before.rfind('\n') + 1);  // npos + 1 is 0
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    const auto column = std::ranges::count_if(before, startsCharacter) + 1;
    return {path_, static_cast<std::size_t>(lines) + 1, static_cast<std::size_t>(column)};
}

}  // namespace raytracer
