#include <catch2/catch.hpp>

#include "raytracer/util/nearest_name.h"

using raytracer::NearestName;

namespace {

std::string questionFor(const char* name, std::initializer_list<const char*> candidates) {
    NearestName nearest(name);
    for (const char* candidate : candidates) nearest.consider(candidate);
    return nearest.question();
}

}  // namespace

TEST_CASE("the nearest name has the fewest errors, or the same last words") {
    CHECK(questionFor("colour", {"specular", "color"}) == "; did you mean \"color\"?");
    CHECK(questionFor("colour", {"specular", "shininess"}) == "");
    CHECK(questionFor("recursion", {"precision", "max-recursion"}) == "; did you mean \"max-recursion\"?");
    CHECK(questionFor("number-of-samples", {"samples", "only"}) == "; did you mean \"samples\"?");
    CHECK(questionFor("diffuse", {"color_diffuse", "diffused"}) == "; did you mean \"diffused\"?");
    CHECK(questionFor("diffuse", {"color_diffuse", "color_ambient"}) == "; did you mean \"color_diffuse\"?");
    CHECK(questionFor("diffuse", {"diffuse_texture", "color_diffuse"}) ==
          "; did you mean \"color_diffuse\"?");
    CHECK(questionFor("edge", {"left_edge", "right_edge"}) == "");  // either could be meant
    CHECK(questionFor("sam", {"samples", "only"}) == "; did you mean \"samples\"?");
    CHECK(questionFor("difference", {"diff", "a"}) == "; did you mean \"diff\"?");
    CHECK(questionFor("edge_of_all", {"edg", "a"}) == "");
    CHECK(questionFor("target", {"target-time", "target-error"}) == "");
    CHECK(questionFor("-", {"e", "-a"}) == "");  // a name of one letter is like no other
    CHECK(questionFor("ab", {"b"}) == "; did you mean \"b\"?");
    CHECK(questionFor("use", {"color_use", "diffuse"}) == "");
    CHECK(questionFor("fuse_", {"color_diffuse"}) == "");
}
