// Makes a JsonDocument from a text: each node is an event of nlohmann's parser.
#include <algorithm>
#include <iterator>
#include <limits>

#include <nlohmann/json.hpp>

#include "number_mistake.h"
#include "raytracer/json/json_document.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"
#include "syntax_mistake.h"

namespace raytracer {
namespace {

// nlohmann's parser copies its iterator. All copies of this one share one position, so that JsonReader knows
// how far the parser has read.
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

}  // namespace

// Handles the events of nlohmann's SAX interface, which prescribes the functions' names. It throws rather
// than returning false.
class JsonReader {
    using Kind = JsonDocument::Kind;
    using Node = JsonDocument::Node;

  public:
    explicit JsonReader(JsonDocument& document)
        : document_(document), nodes_(document.nodes_), text_(document.text_) {
        behindLast_ = read_ + (text_.starts_with(byteOrderMark) ? byteOrderMark.size() : 0);
    }

    void read() {
        const std::size_t most = mostNodes();
        requireMemory(document_.path_, std::to_string(most) + " values and keys",
                      sizeof(Node) * static_cast<double>(most));
        nodes_.reserve(most);
        const char* end = text_.data() + text_.size();
        nlohmann::json::sax_parse(CountingIterator(read_), CountingIterator(end), this);
        requireNoNul();
    }

    bool null() { return add(Kind::Null); }
    bool boolean(bool) { return add(Kind::Boolean); }
    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(value); }
    bool binary(std::vector<std::uint8_t>&) { return false; }  // not in JSON text
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
        last_ = JsonEvent::Close;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error);

  private:
    std::uint32_t count() const { return static_cast<std::uint32_t>(nodes_.size()); }
    // Each but the first is behind one of these characters, which texts may have, too.
    std::size_t mostNodes() const {
        return 1 + static_cast<std::size_t>(std::ranges::count_if(
                       text_, [](char c) { return c == '[' || c == '{' || c == ',' || c == ':'; }));
    }
    // nlohmann's parser takes a NUL for the end of the text.
    void requireNoNul() const {
        if (read_ != text_.data() && read_[-1] == '\0')
            throw document_.syntaxError(static_cast<std::size_t>(read_ - 1 - text_.data()), "unexpected NUL");
    }

    bool add(Kind kind);
    bool number(double value);
    bool text(Kind kind, std::string& value);
    bool open(Kind kind);
    void requireKeysOnce();
    SyntaxState state() const;

    JsonDocument& document_;
    LargeVector<Node>& nodes_;
    const std::string_view text_;
    const char* read_ = text_.data();  // how far the parser has read
    const char* behindLast_;           // how far it had read at the last event
    JsonEvent last_ = JsonEvent::None;
    std::vector<std::uint32_t> open_;  // containers, the innermost last
    std::vector<std::string_view> keys_;
};

// A node begins behind the last event and any blanks, comma or colon. Behind a number, the parser has read
// one character too many, but that is never the first one of another value.
bool JsonReader::add(Kind kind) {
    if (nodes_.size() == std::numeric_limits<std::uint32_t>::max())
        throw document_.error(0, "too many values");
    const char* begin = behindLast_;
    while (*begin == ' ' || *begin == '\n' || *begin == '\t' || *begin == '\r' || *begin == ',' ||
           *begin == ':')
        ++begin;
    Node& node = nodes_.emplace_back(Node{});
    node.begin = begin;
    node.kind = kind;
    last_ = kind == Kind::Key ? JsonEvent::Key : JsonEvent::Value;
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

// A string is longer in the text than its value, even without its quotes, if it has an escape sequence.
bool JsonReader::text(Kind kind, std::string& value) {
    add(kind);
    Node& node = nodes_.back();
    if (value.size() > std::numeric_limits<std::uint32_t>::max())
        throw document_.error(count() - 1, "a text of over 4 GiB");
    node.length = static_cast<std::uint32_t>(value.size());
    node.isDecoded = read_ - node.begin != static_cast<std::ptrdiff_t>(value.size() + 2);
    if (node.isDecoded) {
        document_.decoded_.push_back({std::move(value), node.begin});
        node.decoded = &document_.decoded_.back();
    }
    return true;
}

bool JsonReader::open(Kind kind) {
    constexpr std::size_t deepest = 256;  // a scene needs 5
    open_.push_back(count());
    add(kind);
    if (open_.size() > deepest)
        throw document_.syntaxError(document_.begin(count() - 1),
                                    "expected at most 256 lists and objects inside of each other");
    last_ = JsonEvent::Open;
    nodes_.back().end = std::numeric_limits<std::uint32_t>::max();  // until closed: see pointer()
    return true;
}

// Called once for each object, not for each key, so that the time for a million keys is not quadratic.
void JsonReader::requireKeysOnce() {
    keys_.clear();
    for (std::uint32_t key = open_.back() + 1; key < count(); key = document_.end(key + 1))
        keys_.push_back(document_.string(key));
    std::ranges::sort(keys_);
    const auto twice = std::ranges::adjacent_find(keys_);
    if (twice == keys_.end()) return;
    std::uint32_t second = open_.back() + 1;
    for (bool isSecond = false; document_.string(second) != *twice || !isSecond;
         second = document_.end(second + 1))
        isSecond = isSecond || document_.string(second) == *twice;
    throw document_.error(open_.back(), "expected each key once, found " + inQuotes(*twice) + " twice",
                          second);
}

// The end of a number by JSON's grammar: a leading zero is a number of its own.
static std::size_t endOfNumber(std::string_view text, std::size_t at) {
    const std::size_t first = at + (text[at] == '-');
    if (text[first] == '0' && isDigitAt(text, first + 1)) return first + 1;
    double number = 0;
    return static_cast<std::size_t>(readNumber(text.data() + at, text.data() + text.size(), number) -
                                    text.data());
}

// The parser has read one character too many behind a number, so the number's end is found again.
SyntaxState JsonReader::state() const {
    SyntaxState state{text_, last_};
    const auto offset = [&](const char* place) { return static_cast<std::size_t>(place - text_.data()); };
    state.end = offset(behindLast_);
    if (!nodes_.empty()) state.begin = document_.begin(count() - 1);
    if (last_ == JsonEvent::Value && nodes_.back().kind == Kind::Number)
        state.end = endOfNumber(text_, state.begin);
    state.stopped = std::min(offset(read_), text_.size()) - (read_ != text_.data());
    if (open_.empty()) return state;
    state.opening = document_.begin(open_.back());
    state.container = text_[state.opening];
    return state;
}

bool JsonReader::parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) {
    constexpr int numberOverflow = 406;  // nlohmann's documentation: json.exception.out_of_range.406
    if (error.id == numberOverflow) {
        number(0);  // a node in the number's place
        throw NotFinite(
            document_.error(count() - 1, "expected a finite number, found " + token.substr(0, 40)));
    }
    requireNoNul();
    const SyntaxMistake mistake = syntaxMistake(state());
    throw NoJson(document_.syntaxError(mistake.offset, mistake.message), mistake.range, mistake.instead);
}

JsonDocument::JsonDocument(std::string path, std::string_view text, TextEdits edits)
    : path_(std::move(path)), text_(text), edits_(std::move(edits)) {
    if (const auto wide = wideEncoding(text); !wide.empty())
        throw Error({path_}, "expected UTF-8, found " + wide + ": save it as UTF-8");
    JsonReader(*this).read();
}

std::size_t JsonDocument::originalOffset(std::size_t offset) const {
    std::size_t original = offset;
    for (const EditedRange& edit : edits_.ranges)
        if (edit.end <= offset) original = original - (edit.end - edit.begin) + edit.replaced;
    return original;
}

Place JsonDocument::place(std::size_t offset) const {
    std::string_view before =
        edits_.ranges.empty() ? text_.substr(0, offset) : edits_.original.substr(0, originalOffset(offset));
    if (before.starts_with(byteOrderMark)) before.remove_prefix(byteOrderMark.size());  // has no width
    const auto lines = std::ranges::count(before, '\n');
    before.remove_prefix(before.rfind('\n') + 1);  // npos + 1 is 0
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    const auto column = std::ranges::count_if(before, startsCharacter) + 1;
    return {path_, static_cast<std::size_t>(lines) + 1, static_cast<std::size_t>(column)};
}

Error JsonDocument::syntaxError(std::size_t offset, const std::string& message) const {
    const std::size_t start = text_.substr(0, offset).rfind('\n') + 1;  // npos + 1 is 0
    std::string_view line = text_.substr(start, text_.find('\n', start) - start);
    const Place at = place(offset);
    if (at.line == 1 && line.starts_with(byteOrderMark)) line.remove_prefix(byteOrderMark.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    return {at, message, line};
}

}  // namespace raytracer
