// What a JSON text's nodes are, where each begins, and where an error says that it is.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "raytracer/json/json_document.h"

using namespace raytracer;
using Kind = JsonDocument::Kind;

namespace {

std::uint64_t bitsOf(double number) { return std::bit_cast<std::uint64_t>(number); }

// A text made token by token, with what the document must have of each node.
struct MadeJson {
    struct Node {
        Kind kind;
        std::size_t begin;  // in `text`
        double number;
        std::string string;
        std::size_t end;  // the node behind it and all in it
    };

    explicit MadeJson(unsigned seed) : random(seed) {
        if (seed % 3 == 0) text = "\xef\xbb\xbf";
        blanks();
        value(0);
        blanks();
    }

    std::mt19937 random;
    std::string text;
    std::vector<Node> nodes;

  private:
    unsigned below(unsigned count) { return static_cast<unsigned>(random() % count); }
    void blanks() {
        for (unsigned i = below(3); i > 0; --i) text += " \t\n\r"[below(4)];
    }
    std::size_t begin(Kind kind) {
        nodes.push_back({kind, text.size(), 0, {}, nodes.size() + 1});
        return nodes.size() - 1;
    }
    void value(unsigned depth);
    void number();
    void string(Kind kind);
    void container(Kind kind, unsigned depth);
};

void MadeJson::value(unsigned depth) {
    const unsigned choice = below(depth < 6 ? 8 : 5);
    if (choice == 0) {
        begin(Kind::Null);
        text += "null";
    } else if (choice == 1) {
        const bool truth = below(2) == 0;
        nodes[begin(Kind::Boolean)].number = truth;
        text += truth ? "true" : "false";
    } else if (choice <= 3) {
        number();
    } else if (choice == 4) {
        string(Kind::String);
    } else {
        container(choice == 5 ? Kind::Object : Kind::Array, depth);
    }
}

// strtod is the reference: correctly rounded in the C library. A whole -0 is 0 to nlohmann's parser.
void MadeJson::number() {
    char written[400];
    const double value = std::ldexp(below(1000000007), static_cast<int>(below(200)) - 100);
    const char* const formats[] = {"%.17g", "%.9g", "%.6f", "%.3f", "%.0f", "%g", "%.17e", "%.30f"};
    std::snprintf(written, sizeof written, formats[below(8)], below(2) == 0 ? value : -value);
    nodes[begin(Kind::Number)].number =
        std::strtod(written, nullptr) + (std::string(written) == "-0" ? 0.0 : -0.0);
    text += written;
}

void MadeJson::string(Kind kind) {
    const std::pair<const char*, const char*> parts[] = {{"a", "a"},
                                                         {" b:,]}", " b:,]}"},
                                                         {"\xc3\xa9", "\xc3\xa9"},
                                                         {"\\n", "\n"},
                                                         {"\\\"", "\""},
                                                         {"\\u00e9", "\xc3\xa9"},
                                                         {"\\ud83d\\ude00", "\xf0\x9f\x98\x80"},
                                                         {"\\\\", "\\"}};
    const std::size_t node = begin(kind);
    text += '"';
    if (kind == Kind::Key) {  // no two alike
        text += std::to_string(node);
        nodes[node].string += std::to_string(node);
    }
    const unsigned plain = below(2);  // most strings of a scene have no escape sequence
    for (unsigned i = below(6); i > 0; --i) {
        const auto& [written, meant] = parts[below(plain ? 3 : 8)];
        text += written;
        nodes[node].string += meant;
    }
    text += '"';
}

void MadeJson::container(Kind kind, unsigned depth) {
    const std::size_t node = begin(kind);
    text += kind == Kind::Object ? '{' : '[';
    const unsigned count = below(depth < 2 ? 12 : 4);
    for (unsigned i = 0; i < count; ++i) {
        if (i > 0) text += ',';
        blanks();
        if (kind == Kind::Object) {
            string(Kind::Key);
            blanks();
            text += ':';
            blanks();
        }
        value(depth + 1);
        blanks();
    }
    if (count == 0) blanks();
    text += kind == Kind::Object ? '}' : ']';
    nodes[node].end = nodes.size();
}

void requireNode(const JsonDocument& document, std::uint32_t i, const MadeJson& made) {
    const MadeJson::Node& node = made.nodes[i];
    INFO("node " << i << " at byte " << node.begin << " of " << made.text);
    REQUIRE(document.kind(i) == node.kind);
    REQUIRE(document.begin(i) == node.begin);
    REQUIRE(document.end(i) == node.end);
    if (node.kind == Kind::Boolean) REQUIRE(document.boolean(i) == (node.number != 0));
    if (node.kind == Kind::Number) REQUIRE(bitsOf(document.number(i)) == bitsOf(node.number));
    if (node.kind == Kind::String || node.kind == Kind::Key) REQUIRE(document.string(i) == node.string);
}

std::string errorOf(const std::string& text) try {
    JsonDocument("x.json", text);
    return "none";
} catch (const Error& error) {
    return error.what();
}

}  // namespace

TEST_CASE("json: every node of a random text is what was written, and begins where it was") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        const MadeJson made(seed);
        const JsonDocument document("x.json", made.text);
        REQUIRE(document.end(0) == made.nodes.size());
        for (std::uint32_t i = 0; i < document.end(0); ++i) requireNode(document, i, made);
    }
}

TEST_CASE("json: numbers at the ends of double's range") {
    const std::string text =
        "[-0,-0.0,0e5,9007199254740993,18446744073709551615,18446744073709551616,1e22,1e23,"
        "-1E-7,1.5e+300,1e-400,5e-324,1.7976931348623157e308]";
    const double numbers[] = {0.0,
                              -0.0,
                              0,
                              9007199254740992.0,
                              18446744073709551616.0,
                              18446744073709551616.0,
                              1e22,
                              1e23,
                              -1e-7,
                              1.5e300,
                              0,
                              5e-324,
                              1.7976931348623157e308};
    const JsonDocument document("", text);
    std::uint32_t node = 1;
    for (const double number : numbers) CHECK(bitsOf(document.number(node++)) == bitsOf(number));
    CHECK(document.end(0) == node);
}

TEST_CASE("json: a text cut short anywhere, or with a byte of it replaced, is refused or read, never more") {
    std::mt19937 random(4);
    for (unsigned seed = 0; seed < 100; ++seed) {
        const MadeJson made(seed);
        for (int i = 0; i < 20; ++i) {
            std::string text = made.text.substr(0, random() % (made.text.size() + 1));
            if (i % 2 && !text.empty()) text[random() % text.size()] = static_cast<char>(random());
            // In memory of its very size, so that a sanitizer sees what reads beyond its end.
            const std::vector<char> exact(text.begin(), text.end());
            try {
                const JsonDocument document("x.json", {exact.data(), exact.size()});
                for (std::uint32_t node = 0; node < document.end(0); ++node)
                    CHECK(document.begin(node) < exact.size());
            } catch (const Error& error) {
                CHECK(error.place().file == "x.json");
            }
        }
    }
}

TEST_CASE("json: a value's error has its line and column beside its pointer") {
    const std::string text = "{\n  \"a\\u0062\": [1, 2],\n  \"\xc3\xa9\": {\"c\": \"d\"} }";
    const JsonDocument document("x.json", text);
    const auto check = [&](std::uint32_t node, std::size_t line, std::size_t column,
                           const std::string& pointer) {
        const Error error = document.error(node, "what");
        CHECK(error.place().file == "x.json");
        CHECK(error.place().line == line);
        CHECK(error.place().column == column);
        CHECK(error.place().pointer == pointer);
        CHECK(error.what() == "x.json:" + std::to_string(line) + ":" + std::to_string(column) + ": " +
                                  (pointer.empty() ? "" : pointer + ": ") + "what");
        CHECK(error.excerpt(80).empty());
    };
    check(0, 1, 1, "");
    check(2, 2, 14, "/ab");
    check(4, 2, 18, "/ab/1");
    check(6, 3, 8, "/\xc3\xa9");
    check(8, 3, 14, "/\xc3\xa9/c");
    // As RFC 6901 has it, without JSON's own escapes.
    const JsonDocument odd("x.json", R"({"a\"b\\<\u0001": {"~/": 1}})");
    CHECK(odd.pointer(4) == "/a\"b\\<\x01/~0~1");
    const std::string longest(60, 'a'), longer(61, 'b');
    const std::string keys = "{\"" + longest + "\": {\"" + longer + "\": 1}}";
    CHECK(JsonDocument("x.json", keys).pointer(4) == "/" + longest + "/\"" + longer.substr(1) + "\"...");
}

TEST_CASE("json: an error of meaning, found before the text has been read to its end, has a place") {
    CHECK(errorOf("[0, {\"a\": 1, \"b\": 2, \"a\": 3}]") ==
          "x.json:1:22: /1: expected each key once, found \"a\" twice");
    CHECK(errorOf("{\"a\":1,\"b\":2,\"c\":3,\"d\":4,\"e\":5,\"f\":6,\"g\":7,\"h\":8,\n\"b\":9}") ==
          "x.json:2:1: expected each key once, found \"b\" twice");
    CHECK(errorOf("[0, [1e999]]") == "x.json:1:6: /1/0: expected a finite number, found 1e999");
}

TEST_CASE("an error of syntax shows its line, and a mark below") {
    using Lines = std::vector<std::string>;
    const auto excerptOf = [](const std::string& text, std::size_t columns) {
        try {
            const JsonDocument document("x.json", text);
        } catch (const Error& error) {
            return error.excerpt(columns);
        }
        return Lines();
    };
    CHECK(excerptOf("[1,\r\n\t+2\r\n]", 80) == Lines{"     +2", "     ^"});
    CHECK(excerptOf("[\"\u202e\u009b\", x]", 80) == Lines{"    [\"??\", x]", "           ^"});
    CHECK(excerptOf("[\"\u00e4\x1b\xff", 80) == Lines{"    [\"\u00e4??", "       ^"});
    CHECK(excerptOf("[" + std::string(200, ' ') + "+2" + std::string(200, ' ') + "]", 60) ==
          Lines{std::string(24, ' ') + "+2" + std::string(34, ' '), std::string(24, ' ') + "^"});
    CHECK(excerptOf("[1,\n", 80).empty());
    // East Asian characters and emoji take two columns, a mark on a letter none.
    CHECK(excerptOf("[\"\u7403\U0001f534u\u0308\", +2]", 80) ==
          Lines{"    [\"\u7403\U0001f534u\u0308\", +2]", "              ^"});
    std::string balls, ten;
    for (int i = 0; i < 40; ++i) (i < 10 ? ten : balls) += "\u7403";
    CHECK(excerptOf("[\"" + balls + ten + "\", +2" + balls + "]", 60) ==
          Lines{"    " + ten.substr(0, 24) + "\", +2" + balls.substr(0, 51), std::string(23, ' ') + "^"});
}
