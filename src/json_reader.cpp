// JsonDocument from text, by the events of nlohmann's parser.
#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "json_document.h"

namespace raytracer {
namespace {

// "[...] parse error at line 1, column 2: syntax error while parsing value - what; last read: 'text'; expected this":
// the library's own words, without its preamble and without a quotation that may be as long as the file.
std::string shortened(std::string message) {
    if (const auto reason = message.find(" - "); reason != message.npos) message.erase(0, reason + 3);
    const auto quotation = message.find("; last read: '");
    if (quotation == message.npos) return message;
    const auto expected = message.rfind("'; expected ");
    const std::string rest = expected == message.npos ? "" : message.substr(expected + 1);
    return message.substr(0, quotation) + rest;
}

// The parser's position is behind what it does not like: a token, named by its first character here, or the last
// character of something that is no token. Only of strings and numbers is the text that it keeps the token's alone.
std::size_t charactersBack(std::string_view message, std::string_view token) {
    const bool isText = message.starts_with("unexpected string") || message.starts_with("unexpected number");
    return isText ? token.size() : 1;
}

// What Windows writes as "Unicode" is no JSON, and the parser would only see a strange character.
void requireNoUtf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) throw JsonError(": expected UTF-8, found UTF-16");
}

// ":LINE:COLUMN: ", both from 1, the column in characters, as editors count.
std::string placeInText(std::string_view text, std::size_t offset) {
    std::string_view before = text.substr(0, std::min(offset, text.size()));
    if (before.starts_with("\xef\xbb\xbf")) before.remove_prefix(3);  // a byte order mark has no width
    const auto line = std::ranges::count(before, '\n') + 1;
    before.remove_prefix(before.rfind('\n') + 1);  // npos + 1 is 0
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    const auto column = std::ranges::count_if(before, startsCharacter) + 1;
    return ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

}  // namespace

// The handler of the events (nlohmann's SAX interface, whose names these are). It never returns false: it throws.
class JsonReader {
    using Kind = JsonDocument::Kind;

  public:
    JsonReader(JsonDocument& document, std::string_view text) : document_(document), text_(text) {}

    bool null() { return addValue(Kind::Null); }
    bool boolean(bool value) { return addValue(Kind::Boolean, value); }
    bool number_integer(std::int64_t value) { return addValue(Kind::Number, static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return addValue(Kind::Number, static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return addValue(Kind::Number, value); }
    bool binary(std::vector<std::uint8_t>&) { return false; }  // no such thing in JSON text

    bool string(const std::string& text) {
        addValue(Kind::String);
        document_.nodes_.back().string = document_.strings_.add(text);
        return true;
    }

    bool key(const std::string& text) {
        key_ = document_.strings_.add(text);
        return true;
    }

    bool start_object(std::size_t) { return open(Kind::Object); }
    bool start_array(std::size_t) { return open(Kind::Array); }

    bool end_object() {
        requireDistinctKeys(open_);
        return end_array();
    }

    bool end_array() {
        JsonDocument::Node& node = document_.nodes_[open_];
        node.end = size();
        open_ = node.parent;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error);

  private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(document_.nodes_.size()); }
    bool addValue(Kind kind, double number = 0);
    bool open(Kind kind);
    void requireDistinctKeys(std::uint32_t object);
    [[noreturn]] void failAtNextValue(const std::string& message);

    JsonDocument& document_;
    std::string_view text_;
    std::uint32_t open_ = 0;  // the innermost container
    std::uint32_t key_ = 0;   // the next value's, if that container is an object
    std::vector<std::uint32_t> keysOfObject_;
};

bool JsonReader::addValue(Kind kind, double number) {
    if (document_.nodes_.size() == std::numeric_limits<std::uint32_t>::max()) throw JsonError(": too many values");
    document_.nodes_.push_back({.number = number, .key = key_, .parent = open_, .end = size() + 1, .kind = kind});
    return true;
}

bool JsonReader::open(Kind kind) {
    addValue(kind);
    open_ = size() - 1;
    return true;
}

// Once for each object rather than at each key, so that an object of a million keys takes no quadratic time.
void JsonReader::requireDistinctKeys(std::uint32_t object) {
    keysOfObject_.clear();
    for (std::uint32_t i = object + 1; i < size(); i = document_.nodes_[i].end)
        keysOfObject_.push_back(document_.nodes_[i].key);
    std::ranges::sort(keysOfObject_);
    const auto twice = std::ranges::adjacent_find(keysOfObject_);
    if (twice != keysOfObject_.end())
        document_.fail(object, "expected each key once, found " + inQuotes(document_.strings_[*twice]) + " twice");
}

void JsonReader::failAtNextValue(const std::string& message) {
    addValue(Kind::Null);
    document_.fail(size() - 1, message);
}

bool JsonReader::parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) {
    constexpr int numberOverflow = 406;  // nlohmann's documentation: json.exception.out_of_range.406
    if (error.id == numberOverflow)
        failAtNextValue("expected a finite number, found " + token.substr(0, 40));
    const std::string message = shortened(error.what());
    throw JsonError(placeInText(text_, position - std::min(position, charactersBack(message, token))) + message);
}

JsonDocument::JsonDocument(const char* begin, const char* end) {
    requireNoUtf16({begin, end});
    JsonReader reader(*this, {begin, end});
    nlohmann::json::sax_parse(begin, end, &reader);
}

}  // namespace raytracer
