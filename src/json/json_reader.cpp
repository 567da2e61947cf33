// JsonDocument from text: from what is plain by json_scanner.cpp; from all else, errors included, by the
// events of nlohmann's parser.
#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "json_nodes.h"

namespace raytracer {
namespace {

// "[...] parse error at line 1, column 2: syntax error while parsing value - what; last read: 'text';
// expected this": the library's own words, without its preamble and without a quotation that may be as long
// as the file.
std::string shortened(std::string message) {
    if (const auto reason = message.find(" - "); reason != message.npos) message.erase(0, reason + 3);
    const auto quotation = message.find("; last read: '");
    if (quotation == message.npos) return message;
    const auto expected = message.rfind("'; expected ");
    const std::string rest = expected == message.npos ? "" : message.substr(expected + 1);
    return message.substr(0, quotation) + rest;
}

// The parser's position is behind what it does not like: a token, named by its first character here, or the
// last character of something that is no token. Only of strings and numbers is the text that it keeps the
// token's alone.
std::size_t charactersBack(std::string_view message, std::string_view token) {
    const bool isText = message.starts_with("unexpected string") || message.starts_with("unexpected number");
    return isText ? token.size() : 1;
}

// What Windows writes as "Unicode" is no JSON, and the parser would only see a strange character.
void requireNoUtf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw JsonError(": expected UTF-8, found UTF-16");
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

// The handler of the events (nlohmann's SAX interface, whose names these are). It never returns false: it
// throws.
class JsonEvents {
    using Kind = JsonDocument::Kind;

  public:
    JsonEvents(JsonDocument& document, JsonNodes& nodes, std::string_view text)
        : document_(document), nodes_(nodes), text_(text) {}

    bool null() { return addNumber(Kind::Null, 0); }
    bool boolean(bool value) { return addNumber(Kind::Boolean, value); }
    bool number_integer(std::int64_t value) { return addNumber(Kind::Number, static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return addNumber(Kind::Number, static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return addNumber(Kind::Number, value); }
    bool binary(std::vector<std::uint8_t>&) { return false; }  // no such thing in JSON text
    bool string(const std::string& text) { return addText(Kind::String, text); }
    bool key(const std::string& text) { return addText(Kind::Key, text); }

    bool start_object(std::size_t) { return nodes_.open(Kind::Object), true; }
    bool start_array(std::size_t) { return nodes_.open(Kind::Array), true; }
    bool end_object();
    bool end_array() { return nodes_.close(), true; }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error);

  private:
    bool addNumber(Kind kind, double number) { return nodes_.addNumber(kind, number), true; }
    bool addText(Kind kind, const std::string& text);

    JsonDocument& document_;
    JsonNodes& nodes_;
    std::string_view text_;
};

bool JsonEvents::addText(Kind kind, const std::string& text) {
    if (text.size() > std::numeric_limits<std::uint32_t>::max()) throw JsonError(": a string of over 4 GiB");
    nodes_.addText(kind, nodes_.keep(text));
    return true;
}

bool JsonEvents::end_object() {
    if (const JsonDocument::Node* key = nodes_.twice())
        document_.fail(nodes_.innermost(),
                       "expected each key once, found " + inQuotes({key->text, key->length}) + " twice");
    return end_array();
}

bool JsonEvents::parse_error(std::size_t position, const std::string& token,
                             const nlohmann::json::exception& error) {
    constexpr int numberOverflow = 406;  // nlohmann's documentation: json.exception.out_of_range.406
    if (error.id == numberOverflow) {
        null();  // in its place
        document_.fail(nodes_.last(), "expected a finite number, found " + token.substr(0, 40));
    }
    const std::string message = shortened(error.what());
    throw JsonError(placeInText(text_, position - std::min(position, charactersBack(message, token))) +
                    message);
}

}  // namespace

// Once for each object rather than at each key, so that an object of a million keys takes no quadratic time.
const JsonDocument::Node* JsonNodes::twice() {
    constexpr std::size_t few = 8;  // as most objects have: not worth sorting
    keys_.clear();
    for (std::uint32_t key = innermost() + 1; key < size(); key = document_.end(key + 1))
        keys_.push_back(&nodes_[key]);
    const auto text = [](const Node* key) { return std::string_view(key->text, key->length); };
    if (keys_.size() > few) {
        std::ranges::sort(keys_, {}, text);
        const auto twice = std::ranges::adjacent_find(keys_, {}, text);
        return twice == keys_.end() ? nullptr : *twice;
    }
    for (auto key = keys_.begin(); key != keys_.end(); ++key)
        if (std::find_if(keys_.begin(), key, [&](const Node* other) { return text(other) == text(*key); }) !=
            key)
            return *key;
    return nullptr;
}

JsonDocument::JsonDocument(const char* begin, const char* end) {
    std::string_view text(begin, end);
    requireNoUtf16(text);
    JsonNodes nodes(*this);
    constexpr std::size_t bytesForNode = 8;  // a guess; memory that is not written to costs nothing
    nodes.reserve(text.size() / bytesForNode);
    if (scanPlainJson(text, nodes)) return;
    nodes.clear();
    JsonEvents events(*this, nodes, text);
    nlohmann::json::sax_parse(begin, end, &events);
}

}  // namespace raytracer
