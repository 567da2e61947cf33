// Writes JSON to a string, for --stats, --json and the reports.
//
//     JsonWriter json;
//     json.beginObject();
//     json.key("size").values(std::array{600, 400});
//     json.endObject();
//     puts(json.text().c_str());
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// The caller must follow the grammar: in an object every value has a key, and each begin has its end. Nothing
// is checked. In an object each key begins a line; an array of plain values stays on one line.
class JsonWriter {
  public:
    JsonWriter& beginObject() { return begin('{'); }
    JsonWriter& endObject() { return end('}'); }

    JsonWriter& key(std::string_view name);

    // Text is UTF-8. A number reads back as the same double. Infinities and NaN, which JSON cannot write,
    // become null.
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(double number);
    template <std::integral Number>
    JsonWriter& value(Number number) {
        if constexpr (std::same_as<Number, bool>) return plain(number ? "true" : "false");
        else return plain(std::to_string(number));
    }
    JsonWriter& null() { return plain("null"); }

    // An array: of these values, or of what write(element) writes for each element.
    template <class Range>
    JsonWriter& values(const Range& range) {
        return array(range, [this](const auto& element) { this->value(element); });
    }
    template <class Range, class Write>
    JsonWriter& array(const Range& range, Write write) {
        begin('[');
        for (const auto& element : range) write(element);
        return end(']');
    }

    const std::string& text() const { return text_; }

  private:
    struct Container {
        bool empty = true;
        bool lines = false;  // each element has its own line
    };

    JsonWriter& begin(char bracket);
    JsonWriter& end(char bracket);
    JsonWriter& plain(std::string_view token);
    void separate(bool onItsOwnLine);
    void newLine();

    std::string text_;
    std::vector<Container> open_;
    bool afterKey_ = false;
};

// The shortest text that reads back as this double (0.1, where %.17g has 0.10000000000000001), in every
// locale.
std::string shortestNumber(double number);

}  // namespace raytracer
