// What is said of a text that is no JSON, and whether what is proposed is JSON.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "raytracer/json/json_document.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/text.h"

using namespace raytracer;

namespace {

// Why a text is no JSON, if that is what is wrong.
std::optional<NoJson> mistakeOf(const std::string& json) try {
    const JsonDocument document("x.json", json);
    return {};
} catch (const NoJson& error) {
    return error;
} catch (const Error&) {
    return {};
}

std::string whatIsWrong(const std::string& json) {
    const auto mistake = mistakeOf(json);
    return mistake ? mistake->what() : "none";
}

std::size_t offsetOf(std::string_view json, const Place& place) {
    std::size_t at = json.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
    for (std::size_t i = 1; i < place.line; ++i) at = json.find('\n', at) + 1;
    for (std::size_t i = 1; i < place.column; ++i) at += std::max<std::size_t>(utf8Bytes(json.substr(at)), 1);
    return at;
}

// Whether something was proposed; written, it must not be what is wrong next.
bool isProposed(const std::string& json) {
    const auto mistake = mistakeOf(json);
    if (!mistake || mistake->instead.empty()) return false;
    INFO(json << " -> " << mistake->what());
    CHECK(mistake->inFile().find(": write " + mistake->instead) != std::string::npos);
    const auto [begin, end] = mistake->range;
    const std::string mended = std::string(json).replace(begin, end - begin, mistake->instead);
    INFO(mended);
    const auto next = mistakeOf(mended);
    if (next) CHECK(offsetOf(mended, next->place()) >= begin + mistake->instead.size());
    return true;
}

}  // namespace

TEST_CASE("json: what is wrong is said in words, where it is") {
    const std::string comma = "a comma is missing here";
    CHECK(whatIsWrong("[1  true]") == "x.json:1:3: " + comma);
    CHECK(whatIsWrong("[1  -2.5e3]") == "x.json:1:3: " + comma);
    CHECK(whatIsWrong("[1.5e3\n\"a \\n b\"]") == "x.json:1:7: " + comma);
    CHECK(whatIsWrong("[1  {}]") == "x.json:1:3: " + comma);
    CHECK(whatIsWrong("[[]  []]") == "x.json:1:4: " + comma);
    CHECK(whatIsWrong("[1,") == "x.json:1:4: \"]\" is missing at the end of the list");
    CHECK(whatIsWrong("{\"a\": [\n1}") == "x.json:2:2: \"]\" is missing at the end of the list of line 1");
    CHECK(whatIsWrong("[1 - 2]") == "x.json:1:2: JSON does not calculate: write the result of \"1 - 2\"");
    CHECK(whatIsWrong("[-007]") == "x.json:1:2: a number has no zero in front: write -7");
    CHECK(whatIsWrong("[-.5]") == "x.json:1:2: a point stands between digits: write -0.5");
    CHECK(whatIsWrong("[-]") == "x.json:1:2: expected a number, found \"-\"");
    CHECK(whatIsWrong("[1.2.3]") == "x.json:1:2: expected a number, found \"1.2.3\"");
    CHECK(whatIsWrong("[\"\\uD834\\uDD1E \\ud800\"]") ==
          "x.json:1:16: half a character: \\ud800 to \\udfff stand in pairs");
    CHECK(whatIsWrong("[\"\\u12\"]") == "x.json:1:3: expected four hexadecimal digits behind \\u");
    CHECK(whatIsWrong("[\"\x01\"]") == "x.json:1:3: a control character in a text");
    CHECK(whatIsWrong("[] ]") == "x.json:1:4: a bracket too many");
    CHECK(whatIsWrong("[],") == "x.json:1:3: a comma too many: the scene ends before it");
    CHECK(whatIsWrong("[[1]}]") == "x.json:1:5: a bracket too many");
    CHECK(whatIsWrong("[\"}\", {}}]") == "x.json:1:9: a bracket too many");
    CHECK(whatIsWrong("{\"a\": [1]}, \"b\": 2}") == "x.json:1:10: a bracket too many");
    CHECK(whatIsWrong("[true]x") == "x.json:1:7: expected the end of the file, found \"x\"");
    CHECK(whatIsWrong("[\"a,\"]x") == "x.json:1:7: expected the end of the file, found \"x\"");
    CHECK(whatIsWrong("[[true]x]") == "x.json:1:8: a comma is missing here");
    CHECK(whatIsWrong("[1, 2, \"a\": 3}") == "x.json:1:6: \"]\" is missing at the end of the list");
    CHECK(whatIsWrong("[\"a, \"b\"]") == "x.json:1:2: a text has no end: \" is missing");
    CHECK(whatIsWrong("[\"a\"b]") == "x.json:1:5: a comma is missing here");
    CHECK(whatIsWrong("[--1]") == "x.json:1:2: expected a number, found \"--1\"");
    CHECK(whatIsWrong("[1 -- 2]") == "x.json:1:4: a comment, which JSON does not have: delete it");
    CHECK(whatIsWrong("[-pi*f(2, 3), 4]") ==
          "x.json:1:2: JSON does not calculate: write the result of \"-pi*f(2, 3)\"");
    CHECK(whatIsWrong("{\"a\": 0,125}") == "x.json:1:8: a number has a decimal point: write 0.125");
    for (const char* text :
         {"\xef\xbb", "\xff", "\xc0\x80", "\x80{}", "\x89PNG\r\n", "\xff\xd8\xff\xe0", "PK\3\4"})
        CHECK(whatIsWrong(text) == "x.json:1:1: expected JSON, found what is no text");
    CHECK(whatIsWrong("[1, \xe4]") == "x.json:1:5: a byte that is no UTF-8: save the file as UTF-8");
    CHECK(whatIsWrong("[1,\u20602]") == "x.json:1:4: an invisible character (U+2060): delete it");
    CHECK(whatIsWrong("[] /*") == "x.json:1:4: a comment, which JSON does not have: delete it");
    CHECK(whatIsWrong("{\"a\": [5\n % 2]}") == "x.json:1:9: a comma is missing here");
    CHECK(whatIsWrong("{\"a\": 1,\n\"b\": 2") ==
          "x.json:2:7: \"}\" is missing at the end of the object of line 1");
    CHECK(whatIsWrong("{\"a\": 1}: 2") == "x.json:1:9: expected the end of the file, found \":\"");
    CHECK(whatIsWrong("{\"a\": 1: 2}") == "x.json:1:8: expected a comma, found \":\"");
    CHECK(whatIsWrong("{\"a\": 1, 2: 3}") == "x.json:1:10: a key stands in double quotes: write \"2\"");
    CHECK(whatIsWrong("\xef\xbb\xbf{{\"camera\": 1}}") == "x.json:1:2: a bracket too many");
    CHECK(whatIsWrong("{\"a\": {{\"b\": 1}, {\"b\": 2}}}") ==
          "x.json:1:7: a list stands in [ and ], not in { and }");
    CHECK(whatIsWrong("{\"a\": 1; b: 2}") == "x.json:1:8: expected a comma, found \";\"");
    CHECK(whatIsWrong("{\"a\": 1; the b}") == "x.json:1:8: a comment, which JSON does not have: delete it");
}

TEST_CASE("json: what a message proposes is JSON in its place") {
    const char* const words[] = {
        "+1",        "+.5",    "-.5",    "5.",          "-05.",    "007",        "1,5",        "1,000",
        "1,000,000", "1 000",  "1, 000", "1.000,5",     "1_000",   "1'000",      "0,1, 4",     "0,\n1",
        "1 m",       "1deg",   "+1 m",   "(40)",        "(1, 2)",  "vec3(1, 2)", "x: 1, y: 2", "tru",
        "yes no",    "r\"a\"", "red",    "red ball",    "C:\\x",   "1.2.3",      "#fff",       "#ff8000",
        "pi",        "1/2",    "--1",    "[x=1, y=.2]", "[+1, 2]", "1,2,3",      "1.5,2",      "+1,5"};
    const char* const behinds[] = {"}",       ", \"b\": 1}", ",\n\"b\": 1}", ", c: 1}",
                                   ", 2: 3}", ", 7}",        " 8}",          "\n}",
                                   "",        "]",           ": 1}",         "\"a\"}"};
    int proposals = 0;
    for (const std::string before : {"{\"color\": ", "{\"x\": 1, ", "{", "[", "[1, ", ""})
        for (const std::string word : words)
            for (const std::string behind : behinds) proposals += isProposed(before + word + behind);
    for (const auto& entry : std::filesystem::directory_iterator("test/bad/syntax"))
        proposals += isProposed(std::string(FileBytes(entry.path().string()).text()));
    CHECK(proposals > 400);
}
