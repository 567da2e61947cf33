// Both ways to read JSON, the scanner of plain text and nlohmann's parser, make the same document.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "raytracer/json/json_document.h"

using namespace raytracer;

namespace {

// The same after a letter beyond ASCII, which the scanner leaves to nlohmann.
void requireSameElements(const std::string& elements) {
    const std::string plain = "[" + elements + "]", other = "[\"\xc3\xa9\"," + elements + "]";
    const JsonDocument a(plain.data(), plain.data() + plain.size()),
        b(other.data(), other.data() + other.size());
    REQUIRE(a.end(0) + 1 == b.end(0));
    for (std::uint32_t i = 1; i < a.end(0); ++i) {
        REQUIRE(a[i].kind == b[i + 1].kind);
        if (a[i].kind == JsonDocument::Kind::String || a[i].kind == JsonDocument::Kind::Key)
            REQUIRE(a.string(i) == b.string(i + 1));
        else if (a[i].kind == JsonDocument::Kind::Array || a[i].kind == JsonDocument::Kind::Object)
            REQUIRE(a.end(i) + 1 == b.end(i + 1));
        else
            REQUIRE(std::bit_cast<std::uint64_t>(a[i].number) ==
                    std::bit_cast<std::uint64_t>(b[i + 1].number));
    }
}

}  // namespace

TEST_CASE("json: numbers are the same to the bit, however they are read") {
    requireSameElements(
        "0,-0,-0.0,0.0,-0e5,1,-1,0.1,-0.1,12345.678,123456789012345,0.12345678901234,-9.99999999999999");
    requireSameElements(
        "9007199254740993,18446744073709551615,18446744073709551616,1e22,1e23,-1E-7,1.5e+300,1e-400,5e-324");
    std::mt19937_64 random(11);
    std::string elements = "0";
    for (int i = 0; i < 20000; ++i) {
        char text[64];
        const double number =
            std::ldexp(static_cast<double>(random() % 1000000007), static_cast<int>(random() % 60) - 40);
        const char* const formats[] = {"%.17g", "%.9g", "%.6f", "%.3f", "%.0f", "%g"};
        std::snprintf(text, sizeof text, formats[i % 6], i % 2 ? number : -number);
        elements += std::string(",") + text;
    }
    requireSameElements(elements);
}

TEST_CASE("json: words, strings and containers are the same, however they are read") {
    requireSameElements(
        "true,false,null,\"\",\"a b\",[],{},[[]],{\"a\":1,\"b\":{\"c\":[1,{}]}} , [ 1 ,\t2 ]\n");
}
