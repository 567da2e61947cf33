#include <catch2/catch.hpp>

#include "raytracer/util/text.h"

using namespace raytracer;

TEST_CASE("formatted text is printf's, of any length") {
    CHECK(formatted("%s", "").empty());
    CHECK(formatted("%.3g %d %%", 0.12345, -7) == "0.123 -7 %");
    const std::string page(100000, 'x');
    CHECK(formatted("<%s>", page.c_str()) == "<" + page + ">");
}
