#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "raytracer/json/json_writer.h"
#include "raytracer/util/text.h"

using raytracer::jsonString;
using raytracer::JsonWriter;

TEST_CASE("JsonWriter: objects by lines, plain arrays in one") {
    JsonWriter json;
    json.beginObject();
    json.key("name").value("x");
    json.key("size").values(std::array{600, 400});
    json.key("none").values(std::vector<std::string>());
    json.key("yes").value(true);
    json.key("rays").array(std::array{0.1, HUGE_VAL},
                           [&](double t) { json.beginObject().key("t").value(t).endObject(); });
    json.endObject();
    CHECK(json.text() ==
          "{\n  \"name\": \"x\",\n  \"size\": [600, 400],\n  \"none\": [],\n  \"yes\": true,\n  \"rays\": [\n"
          "    {\n      \"t\": 0.1\n    },\n    {\n      \"t\": null\n    }\n  ]\n}");
}

TEST_CASE("JsonWriter: numbers read back as they were") {
    const double numbers[] = {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 123456789012345678.0};
    for (const double number : numbers) {
        JsonWriter json;
        json.value(number);
        CHECK(std::strtod(json.text().c_str(), nullptr) == number);
    }
    JsonWriter largest;
    largest.value(std::numeric_limits<std::uint64_t>::max());
    CHECK(largest.text() == "18446744073709551615");
}

TEST_CASE("JsonWriter: infinities and NaN are null") {
    JsonWriter json;
    json.values(
        std::array{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()});
    CHECK(json.text() == "[null, null]");
}

TEST_CASE("JsonWriter: strings are escaped") {
    CHECK(jsonString("a \"b\" \\ \n \t") == "\"a \\\"b\\\" \\\\ \\n \\u0009\"");
    CHECK(jsonString("</script>") == "\"\\u003c/script>\"");
    CHECK(jsonString("Å") == "\"Å\"");
    CHECK(jsonString("\u202e\uffff\U0001f600\U0001ffff!") == "\"\\u202e\\uffff\U0001f600\\ud83f\\udfff!\"");
    CHECK(jsonString("\x7f \u009b \xff") == "\"\\u007f \\u009b \\u00ff\"");
}
