#include <catch2/catch.hpp>

#include "raytracer/json/json_edit.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/util/error.h"

using namespace raytracer;

namespace {

constexpr const char* text =
    R"({"camera": {"eye": [0, 1.5, -2e3], "a/b~c": "x\"]y", "on": true}, "list": [[1, {"z": null}], "last"]})";

std::string after(const std::string& assignment, const std::string& of = text) {
    return edited("s.json", of, {&assignment, 1}).text;
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
    for (const std::string name : {"nan", "inf"})
        CHECK(after("/list/1=" + name) == with("\"last\"", '"' + name + '"'));
    CHECK(after("/list/1=") == with("\"last\"", "\"\""));
    CHECK(after("/list=[]") == with("[[1, {\"z\": null}], \"last\"]", "[]"));
    CHECK(after("/a=2", "{\"a\":1}") == "{\"a\":2}");
    CHECK(after("/=2", "{\"\":1}") == "{\"\":2}");
    CHECK(after("/~01=2", "{\"/\":0,\"~1\":1}") == "{\"/\":0,\"~1\":2}");
    CHECK(after("/a\"b=2", "{\"a\\\"b\":1}") == "{\"a\\\"b\":2}");
}

TEST_CASE("A key that an object does not have, and an element behind an array's last, are added") {
    CHECK(after("/b=2", "{\"a\":1}") == "{\"b\": 2, \"a\":1}");
    CHECK(after("/b=2", "{ }") == "{\"b\": 2 }");
    CHECK(after("/a/b~1c~0d=x", "{\"a\":{}}") == "{\"a\":{\"b/c~d\": \"x\"}}");
    CHECK(after("/-=2", "[1]") == "[1, 2]");
    CHECK(after("/a/-={\"b\":\"]\"}", "{\"a\": [ ]}") == "{\"a\": [ {\"b\":\"]\"}]}");
    CHECK(after("/-=2", "{\"a\":1}") == "{\"-\": 2, \"a\":1}");
}

TEST_CASE("An error about a value that is set says so; the others keep their places") {
    const std::vector<std::string> sets = {"/a=[1,{}]", "/c=77", "/a/1/x=5", "/a/0=[]", "/b/-=3"};
    const EditedJson json = edited("s.json", "{\"a\": null,\n\"b\": [2]}", sets);
    REQUIRE(json.text == "{\"c\": 77, \"a\": [[],{\"x\": 5}],\n\"b\": [2, 3]}");
    const JsonDocument document("s.json", json.text, json.edits);
    const auto message = [&](std::string_view pointer) {
        return std::string(document.error(follow(document, pointer).node, "bad").what());
    };
    for (const char* pointer : {"/a", "/a/0", "/a/1", "/a/1/x", "/c", "/b/1"})
        CHECK(message(pointer) == "s.json: " + std::string(pointer) + ", by --set: bad");
    const JsonDocument set("s.json", "{\"c\": 77}", {{{{1, 8}, 0}}, "{}"});
    CHECK(std::string(set.error(0, "unknown key", 1).what()) == "s.json: the scene, by --set: unknown key");
    CHECK(message("/b") == "s.json:2:6: /b: bad");
    CHECK(message("/b/0") == "s.json:2:7: /b/0: bad");
}

TEST_CASE("What stands behind an edit has its place in the file") {
    const std::string file = "{\"a\": [1,\n2], \"b\": null, \"c\": 0}";
    const auto place = [&](std::vector<std::string> sets, std::string_view pointer) {
        const EditedJson json = edited("s.json", file, sets);
        const JsonDocument document("s.json", json.text, json.edits);
        return std::string(document.error(follow(document, pointer).node, "bad").what());
    };
    const std::string c = "s.json:2:21: /c: bad", a = "s.json:1:7: /a: bad";
    CHECK(place({}, "/c") == c);
    CHECK(place({"/a=7"}, "/c") == c);
    CHECK(place({"/a/1=77", "/a/-=\"x\"", "/a/-=4"}, "/c") == c);
    CHECK(place({"/a/1=77", "/a/-=\"x\"", "/b=[1,{}]", "/b/1/x=5", "/b/0=[]", "/a=1234"}, "/c") == c);
    CHECK(place({"/b={}", "/b/x=5", "/b/x=[1,2]", "/b/x/-=3", "/b=1", "/b=null"}, "/c") == c);
    CHECK(place({"/d=1", "/e=2", "/d=33"}, "/c") == c);
    CHECK(place({"/d=1", "/e=2", "/d=33"}, "/a") == a);
    CHECK(place({"/b=1"}, "/a") == a);
}

TEST_CASE("What a text is, read as JSON, and why it is none") {
    const auto why = [](std::string_view json) { return readingOf(json).why; };
    CHECK(why("[1]").empty());
    CHECK(why("[1 2]") == "a comma is missing here");
    CHECK(why("[1,\n{2}]") == "a list stands in [ and ], not in { and }");
    CHECK(why("1,2") == "a list stands in [ and ]: write [1, 2]");
    CHECK(why("{\"a\":{\"b\":1,\"b\":2}}") == "/a: expected each key once, found \"b\" twice");
    CHECK(why("\xff\xfe[") == "expected UTF-8, found UTF-16: save it as UTF-8");
    CHECK(why("[1e999]") == "/0: expected a finite number, found 1e999");
    CHECK(readingOf("[1]").kind == JsonDocument::Kind::Array);
    CHECK(readingOf("\n[1e999]").kind == JsonDocument::Kind::Array);
    CHECK(readingOf("{\"a\": 1e999}").kind == JsonDocument::Kind::Object);
    CHECK(readingOf("-1e999").kind == JsonDocument::Kind::Number);
    CHECK(readingOf("1x").kind == JsonDocument::Kind::String);
}

TEST_CASE("A pointer to nothing is told, with the nearest") {
    const auto check = [](const std::string& assignment, const std::string& message) {
        CHECK_THROWS_WITH(after(assignment), message);
    };
    check("/camera/eyes/0=1",
          "s.json: --set /camera/eyes/0: there is no \"eyes\" in /camera; did you mean /camera/eye/0?");
    check("/camra/eye=1",
          "s.json: --set /camra/eye: there is no \"camra\" in the scene; did you mean /camera/eye?");
    check("/camera/a~1b~0d/0=1",
          "s.json: --set /camera/a~1b~0d/0: there is no \"a~1b~0d\" in /camera; did you mean "
          "/camera/a~1b~0c/0?");
    check("/zzzz/0=1", "s.json: --set /zzzz/0: there is no \"zzzz\" in the scene");
    check("/list/2=1",
          "s.json: --set /list/2: /list has 2 elements, from 0: there is no \"2\"; /list/- adds one");
    check("/list/01=1",
          "s.json: --set /list/01: /list has 2 elements, from 0: there is no \"01\"; /list/- adds one");
    check("/a/b=1", "s.json: --set /a/b: there is no \"a\" in the scene");
    check(
        "/camera/a~1b~c/0=1",
        "s.json: --set /camera/a~1b~c/0: there is no \"a~1b~c\" in /camera; did you mean /camera/a~1b~0c/0?");
    check("/list/-/0=1", "s.json: --set /list/-/0: - adds an element, and ends its pointer: write /list/-");
    CHECK_THROWS_WITH(after("/a/3=1", "{\"a\":[1]}"),
                      "s.json: --set /a/3: /a has 1 element, from 0: there is no \"3\"");
    check("/camera/on/x=1", "s.json: --set /camera/on/x: /camera/on is no object and no list");
    const auto checkForm = [&](const std::string& pointer, const std::string& place) {
        check(pointer + "=1", "s.json: --set " + pointer + ": a pointer begins with /" +
                                  (place.empty() ? "" : ": write " + place));
    };
    checkForm("camera", "/camera");
    for (const char* pointer :
         {"camera.eye", "camera:eye", "eye", "$.camera.eye", "\\camera\\eye", "-/camera/eye"})
        checkForm(pointer, "/camera/eye");
    for (const char* pointer : {"camera/eye[0]", "camera.eye.0", "eye/0", "eye[0]"})
        checkForm(pointer, "/camera/eye/0");
    checkForm("list[0][1].z", "/list/0/1/z");
    checkForm("camera.new", "/camera/new");
    for (const char* pointer : {"camera/a.b", "nothing", ".", "camera/5", "new", "list/2"})
        checkForm(pointer, "");
    const auto checkNamed = [](const std::string& pointer, const std::string& message) {
        CHECK_THROWS_WITH(after(pointer + "=1", R"({"a": [{"name": "b", "c": [1]}, {"c": 2}]})"),
                          "s.json: --set " + pointer + ": " + message);
    };
    checkNamed("/a/b/c/0", "\"b\" is a name: write /a/0/c/0");
    checkNamed("/a/b/new", "\"b\" is a name: write /a/0/new");
    checkNamed("a.b.c", "a pointer begins with /: write /a/0/c");
    checkNamed("c", "a pointer begins with /");  // there are two
    checkNamed("/a/0.5", "/a has 2 elements, from 0: there is no \"0.5\"; /a/- adds one");
    checkNamed("/a/0/c/x", "/a/0/c has 1 element, from 0: there is no \"x\"");
    check("/list[0][1].z=1", "s.json: --set /list[0][1].z: steps are parted by /: write /list/0/1/z");
    check("/list/0.1=1", "s.json: --set /list/0.1: steps are parted by /: write /list/0/1");
    check("/camera.new=1", "s.json: --set /camera.new: steps are parted by /: write /camera/new");
    CHECK(after("/a.b=2", "{\"a\":1}") == "{\"a.b\": 2, \"a\":1}");  // a name, not a step below a number
    CHECK(after("/a.b=2", "{\"a.b\":1, \"a\":{}}") == "{\"a.b\":2, \"a\":{}}");
    check("/camera/eye =1", "s.json: --set /camera/eye : a blank stands before =: delete it");
    CHECK(after("/a =2", "{\"a \":1}") == "{\"a \":2}");
    check("/camera/eye:[1]", "raytracer: --set /camera/eye: write = for the : behind it");
    check("/camera/eye=[1],/camera/on=2",
          "raytracer: --set has one value: write another --set before /camera/on");
    check("/camera/eye=(1,2), /camera/on=2",
          "raytracer: --set has one value: write another --set before /camera/on");
    CHECK(after("/a=x,/b", "{\"a\":1}") == "{\"a\":\"x,/b\"}");
    CHECK(after("/a=x,/b=c", "{\"a\":1}") == "{\"a\":\"x,/b=c\"}");
    check("=1", "raytracer: --set: expected /pointer=value, found \"=1\"");
    check("/camera", "raytracer: --set: expected /pointer=value, found \"/camera\"");
}
