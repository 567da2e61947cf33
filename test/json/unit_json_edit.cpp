#include <catch2/catch.hpp>

#include "raytracer/json/json_edit.h"
#include "raytracer/util/error.h"

using namespace raytracer;

namespace {

constexpr const char* text =
    R"({"camera": {"eye": [0, 1.5, -2e3], "a/b~c": "x\"]y", "on": true}, "list": [[1, {"z": null}], "last"]})";

std::string after(const std::string& assignment, const std::string& of = text) {
    return edited("s.json", of, JsonEdit(assignment));
}

}  // namespace

TEST_CASE("A value of a JSON text is replaced, and nothing else") {
    const std::string whole = text;
    const auto with = [&](const std::string& from, const std::string& to) {
        return std::string(whole).replace(whole.find(from), from.size(), to);
    };
    CHECK(after("/camera/eye=[1,2,3]") == with("[0, 1.5, -2e3]", "[1,2,3]"));
    CHECK(after("/camera/eye/2=7") == with("-2e3", "7"));
    CHECK(after("/camera/a~1b~0c=plain text") == with("\"x\\\"]y\"", "\"plain text\""));
    CHECK(after("/camera/on=false") == with("true", "false"));
    CHECK(after("/list/0=\"=\"") == with("[1, {\"z\": null}]", "\"=\""));
    CHECK(after("/list/0/1/z={\"k\": []}") == with("null", "{\"k\": []}"));
    CHECK(after("/list/1=") == with("\"last\"", "\"\""));
    CHECK(after("/list=[]") == with("[[1, {\"z\": null}], \"last\"]", "[]"));
    CHECK(after("/a=2", "{\"a\":1}") == "{\"a\":2}");
    CHECK(after("/=2", "{\"\":1}") == "{\"\":2}");
    CHECK(after("/~01=2", "{\"/\":0,\"~1\":1}") == "{\"/\":0,\"~1\":2}");
    CHECK(after("/a\"b=2", "{\"a\\\"b\":1}") == "{\"a\\\"b\":2}");
}

TEST_CASE("A pointer to nothing is told, with the nearest") {
    const auto check = [](const std::string& assignment, const std::string& message) {
        CHECK_THROWS_WITH(after(assignment), message);
    };
    check("/camera/eyes/0=1",
          "s.json: --set /camera/eyes/0: there is no \"eyes\" in /camera; did you mean /camera/eye/0?");
    check("/camra=1", "s.json: --set /camra: there is no \"camra\" in the scene; did you mean /camera?");
    check("/camera/a~1b~0d=1",
          "s.json: --set /camera/a~1b~0d: there is no \"a~1b~0d\" in /camera; did you mean /camera/a~1b~0c?");
    check("/zzzz=1", "s.json: --set /zzzz: there is no \"zzzz\" in the scene");
    check("/list/2=1", "s.json: --set /list/2: /list has 2 elements, from 0: there is no \"2\"");
    check("/list/01=1", "s.json: --set /list/01: /list has 2 elements, from 0: there is no \"01\"");
    check("/a/b=1", "s.json: --set /a/b: there is no \"a\" in the scene");
    check("/camera/a~1b~c=1",
          "s.json: --set /camera/a~1b~c: there is no \"a~1b~c\" in /camera; did you mean /camera/a~1b~0c?");
    check("/camera/on/x=1", "s.json: --set /camera/on/x: /camera/on is no object and no list");
    check("camera=1", "raytracer: --set: expected /pointer=value, found \"camera=1\"");
    check("/camera", "raytracer: --set: expected /pointer=value, found \"/camera\"");
}
