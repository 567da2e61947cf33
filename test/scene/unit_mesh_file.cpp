#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>
#include <string>

#include "../../src/scene/obj_chunk.h"
#include "../support/test_folder.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/error.h"

using raytracer::Error;
using raytracer::MeshData;

namespace {

constexpr auto none = MeshData::noTexCoord;
using Indices = decltype(MeshData::positionIndex);

MeshData parse(const std::string& text) { return raytracer::parseObj(text); }

std::string errorOf(const std::string& text) try {
    parse(text);
    return "none";
} catch (const Error& error) {
    return error.what();
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // 4 lines, 4 vertices

bool same(const MeshData& a, const MeshData& b) {
    return a.positions == b.positions && a.texCoords == b.texCoords && a.positionIndex == b.positionIndex &&
           a.texCoordIndex == b.texCoordIndex;
}

}  // namespace

TEST_CASE("An OBJ's faces become triangles in file order") {
    SECTION("a triangle") {
        const MeshData mesh = parse(square + "f 1 2 3\nf 1 3 4\n");
        CHECK(mesh.positions ==
              raytracer::LargeVector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
        CHECK(mesh.low == glm::dvec3(0, 0, 0));
        CHECK(mesh.high == glm::dvec3(1, 1, 0));
        CHECK(mesh.positionIndex == Indices{0, 1, 2, 0, 2, 3});
        CHECK(mesh.texCoordIndex.empty());
        CHECK(mesh.triangleCount() == 2);
    }
    SECTION("a vertex that no face uses does not count in the bounds") {
        const MeshData mesh = parse("v 1e9 1e9 1e9\n" + square + "v -1e-300 5 5\nf 2 3 4\n");
        CHECK(mesh.low == glm::dvec3(0, 0, 0));
        CHECK(mesh.high == glm::dvec3(1, 1, 0));
        CHECK(mesh.positions[5] == mesh.positions[1]);
    }
    SECTION("a polygon is a fan about its first corner") {
        CHECK(parse(square + "v 0 0.5 0\nf 1 2 3 4 5").positionIndex == Indices{0, 1, 2, 0, 2, 3, 0, 3, 4});
    }
    SECTION("a negative index counts back from its line") {
        CHECK(parse(square + "f -4 -3 -2\nv 0 0 1\nf -5 -2 -1\n").positionIndex == Indices{0, 1, 2, 0, 3, 4});
    }
    SECTION("a positive one may point ahead") {
        CHECK(parse("f 1 2 3\n" + square).positionIndex == Indices{0, 1, 2});
    }
    SECTION("a triangle without area keeps its place") {
        CHECK(parse(square + "f 1 1 1\nf 1 2 3\n").triangleCount() == 2);
    }
}

TEST_CASE("A polygon that is not convex is cut, whichever its first corner") {
    const std::string dart =
        "v 0 1 0\nv -1 -1 0\nv 0 -0.5 0\nv 1 -1 0\nvt 0 1\nvt 0 0\nvt 0.5 0.25\nvt 1 0\n";
    for (const char* face : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 1 2 3"})
        CHECK(parse(dart + face).positionIndex == Indices{0, 1, 2, 0, 2, 3});
    SECTION("also where a corner is there twice, which may have two numbers") {
        const auto areaOf = [&](const std::string& face) {
            const MeshData mesh = parse("v -1 0 0\nv 1 -1 0\nv 0.25 0 0\nv 1 1 0\nv 0.25 1e-17 0\n" + face);
            double area = 0;
            for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
                const auto corner = [&](std::size_t k) { return mesh.positions[mesh.positionIndex[i + k]]; };
                area += glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
            }
            return area;
        };
        for (const char* face :
             {"f 1 2 3 3 4", "f 2 3 3 4 1", "f 3 4 1 2 3", "f 1 2 3 5 4", "f 2 5 3 4 1", "f 5 4 1 2 3"})
            CHECK(areaOf(face) == Approx(1.25));
    }
    SECTION("with its texture coordinates, between faces that are as they were") {
        const MeshData mesh = parse(dart + "f 1 2 3\nf 2/2 3/3 4/4 1/1\nf 1 2 3 4\nf 4/4 3/3 2/2\n");
        CHECK(mesh.positionIndex == Indices{0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3, 3, 2, 1});
        CHECK(mesh.texCoordIndex ==
              Indices{none, none, none, 0, 1, 2, 0, 2, 3, none, none, none, none, none, none, 3, 2, 1});
    }
    SECTION("also where its corners come later") {
        CHECK(parse("f 2 3 4 1\n" + dart).positionIndex == Indices{0, 1, 2, 0, 2, 3});
    }
}

TEST_CASE("An OBJ's corners come in four forms") {
    const std::string corners = square + "vt 0 0\nvt 1 0.25\nvt 0.5\nvt 0.5 0.75 1\nvn 0 0 1\n";
    SECTION("v/vt") {
        const MeshData mesh = parse(corners + "f 1/1 2/2 3/4\n");
        CHECK(mesh.positionIndex == Indices{0, 1, 2});
        CHECK(mesh.texCoordIndex == Indices{0, 1, 3});
        CHECK(mesh.texCoords == raytracer::LargeVector<glm::dvec2>{{0, 0}, {1, 0.25}, {0.5, 0}, {0.5, 0.75}});
    }
    SECTION("v//vn: coordinates that no face uses are dropped") {
        const MeshData mesh = parse(corners + "f 1//1 2//-1 3//1\n");
        CHECK(mesh.positionIndex == Indices{0, 1, 2});
        CHECK(mesh.texCoordIndex.empty());
        CHECK(mesh.texCoords.empty());
    }
    SECTION("v/vt/vn") { CHECK(parse(corners + "f 1/1/1 2/-3/-1 3/4/1").texCoordIndex == Indices{0, 1, 3}); }
    SECTION("what follows a slash may be missing") {
        CHECK(same(parse(corners + "f 1/ 2/ 3/\n"), parse(corners + "f 1 2 3\n")));
        CHECK(same(parse(corners + "f 1// 2// 3//\n"), parse(corners + "f 1 2 3\n")));
        CHECK(same(parse(corners + "f 1/1/ 2/2/ 3/3/\n"), parse(corners + "f 1/1 2/2 3/3\n")));
    }
    SECTION("normals are not used, so any will do") {
        CHECK(same(parse(square + "f 1//1 2//-9 3//0\n"), parse(square + "f 1 2 3\n")));
        CHECK(same(parse(corners + "f 1/1/99999999999999999999 2/2 3/3/1\n"),
                   parse(corners + "f 1/1 2/2 3/3\n")));
    }
    SECTION("faces without vt before and after one with") {
        const MeshData mesh = parse(corners + "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 4//1\n");
        CHECK(mesh.texCoordIndex == Indices{none, none, none, 0, 1, 2, none, none, none});
    }
}

TEST_CASE("OBJ text as programs write it") {
    const MeshData plain = parse(square + "f 1 2 3\n");
    const auto reads = [&](const std::string& text) { return same(parse(text), plain); };
    CHECK(reads("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3\r\n"));
    CHECK(reads("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3"));
    CHECK(reads("\n# a comment\n  v 0\t0   0  \nv 1 0 0 # another\nv +1 1. .0\n\tv 0 1e0 -0\t\nf 1 2 3 \t"));
    CHECK(reads("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 1 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3"));
    CHECK(reads("v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 \\\r\n2\\\n 3\n"));
    CHECK(reads("v 0 \\ \n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 \\\t\r\n2\\ \t\n 3\n"));
    CHECK(reads("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 \\\r2 3\r"));
    CHECK(reads("# made on an old Mac\nv 0 0 0\rv 1 0 0\r\nv 1 1 0\rv 0 1 0\n# f 1\rf 1 2 3"));
    CHECK(reads("v 0 0 0# first\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3# triangle"));
    CHECK(reads("# C:\\models\\\nv 0 0 0 # so \\\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n"));
    CHECK(reads("mtllib a.mtl\no a\ng b c\nusemtl d\ns off\nvn a b\nvp 1\nl 1 2\np 1\nunheard-of 1 x\n" +
                square + "f 1 2 3\n"));
    CHECK(reads(square + "f 1 2 003\n"));
    CHECK(parse(square + "v 0. 0. 0.#comment\nf 1 2 5\n").positions.size() == 5);
}

TEST_CASE("OBJ numbers are correctly rounded") {
    const MeshData mesh =
        parse("v 0.30000000000000004 9007199254740993 1e-400\nv 4.9e-324 -1e23 0.1\nv 0 0 0\nf 1 2 3");
    CHECK(mesh.positions[0] == glm::dvec3(0.30000000000000004, 9007199254740992.0, 0));
    CHECK(mesh.positions[1] == glm::dvec3(4.9e-324, -1e23, 0.1));
}

TEST_CASE("A broken OBJ is told with the line") {
    const auto check = [](const std::string& text, const std::string& message) {
        CHECK(errorOf(text) == message);
    };
    const std::string corner = "expected a corner as v, v/vt, v//vn or v/vt/vn, found ";
    SECTION("numbers") {
        check("v 0 0 0\nv 1 x 0\n f 1 1 1", "line 2: expected a number, found \"x\"");
        check("v 0 0 0\nv 1 1.5mm 0\nf 1 1 1", "line 2: expected a number, found \"1.5mm\"");
        check("v 0 0 +-1\nf 1 1 1", "line 1: expected a number, found \"+-1\"");
        check("v 0 0 +\nf 1 1 1", "line 1: expected a number, found \"+\"");
        check("v 0 0x1p3 0\nf 1 1 1", "line 1: expected a number, found \"0x1p3\"");
        check("v 1 2\nf 1 1 1", "line 1: expected a number, found the end of the line");
        check("v\nf 1 1 1", "line 1: expected a number, found the end of the line");
        check("v 0 0 nan\nf 1 1 1", "line 1: expected a finite number, found \"nan\"");
        check("v 0 -inf 0\nf 1 1 1", "line 1: expected a finite number, found \"-inf\"");
        check("v 0 -1e400 0\nf 1 1 1", "line 1: expected a finite number, found \"-1e400\"");
        // As Windows writes them: no comment begins behind the point.
        check("v 0 1.#IND00 0\nf 1 1 1", "line 1: expected a number, found \"1.#IND00\"");
        check("v 0 0 -1.#QNAN0\nf 1 1 1", "line 1: expected a number, found \"-1.#QNAN0\"");
        check(square + "vt 0 1.#INF\nf 1 2 3", "line 5: expected a number, found \"1.#INF\"");
        check("v 1 2 3 4 5\nf 1 1 1", "line 1: a vertex has 3, 4, 6 or 7 numbers, found 5");
        check("v 1 2 3 4 5 6 7 8\nf 1 1 1", "line 1: a vertex has 3, 4, 6 or 7 numbers, found 8");
        check(square + "vt\nf 1 2 3", "line 5: expected a number, found the end of the line");
        check(square + "vt 1 2 3 4\nf 1 2 3", "line 5: a texture coordinate has at most 3 numbers");
    }
    SECTION("indices") {
        check(square + "f 1 2 5\n", "line 5: there is no vertex 5: the file has 4");
        check(square + "f 1 2 -5\nv 0 0 0\n", "line 5: there is no vertex -5: above this line stand 4");
        check(square + "f 1/1 2/1 3/1\nvt 0 0\nf 1/1 2/2 3/1",
              "line 7: there is no texture coordinate 2: the file has 1");
        check(square + "f 1/-1 2/-1 3/-1\nvt 0 0\n",
              "line 5: there is no texture coordinate -1: above this line stand 0");
        check(square + "f 1 0 3", "line 5: indices begin at 1 or -1, found \"0\"");
        check(square + "f 1/0 2/0 3/0", "line 5: indices begin at 1 or -1, found \"1/0\"");
        check(square + "f 1 2 4294967297", "line 5: there is no vertex 4294967297: the file has 4");
        for (const std::string index :
             {"99999999999999999999", "-99999999999999999999", "1/99999999999999999999"})
            check(square + "f 1 2 " + index, "line 5: no mesh has such an index: \"" + index + "\"");
        check(square + "f 1 2 00000000000000000000",
              "line 5: indices begin at 1 or -1, found \"00000000000000000000\"");
    }
    SECTION("a NUL") {
        const std::string nul(1, '\0'), message = "a NUL byte, which no OBJ mesh has";
        check(square + nul + "f 1 2 3 4\n", "line 5: " + message);
        check(square + "f 1 2 3\n# a" + nul, "line 6: " + message);
        check(nul + square + "f 1 2 3\n", "line 1: " + message);
        check("# old Mac\r" + nul + square + "f 1 2 3\n", "line 2: " + message);
    }
    SECTION("faces") {
        check(square + "f 1 2\n", "line 5: a face has at least 3 corners, found 2");
        check(square + "f\n", "line 5: a face has at least 3 corners, found 0");
        check(square + "f 1 b 3\n", "line 5: " + corner + "\"b\"");
        check(square + "f 1 2.5 3\n", "line 5: " + corner + "\"2.5\"");
        check(square + "f 1/ 2/ /3\n", "line 5: " + corner + "\"/3\"");
        check(square + "f 1/// 2 3\n", "line 5: " + corner + "\"1///\"");
        check(square + "f 1//x 2 3\n", "line 5: " + corner + "\"1//x\"");
        check(square + "f 1//1.5 2 3\n", "line 5: " + corner + "\"1//1.5\"");
        check(square + "f 1 2 \\ 3\n", "line 5: " + corner + "\"\\\"");
        check(square + "vt 0 0\nvn 0 0 1\nf 1/1 2//1 3/1\n",
              "line 7: either all corners of a face have a texture coordinate or none");
        check(square + "vt 0 0\nf 1 2 3 4/1\n",
              "line 6: either all corners of a face have a texture coordinate or none");
    }
    SECTION("what is no mesh") {
        check("", "it is empty");
        check("{\"camera\": {}}\n", "no vertices and no faces, so not an OBJ mesh");
        const std::string stl = "an STL mesh: save it as OBJ", ply = "a PLY mesh: save it as OBJ";
        check("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", stl);
        check(" solid a\r\n facet normal 0 0 1\r\n", stl);
        check(std::string(80, '\0') + std::string("\1\0\0\0", 4) + std::string(50, '\0'), stl);
        check("ply\nformat ascii 1.0\n", ply);
        check("ply\r\nformat binary_little_endian 1.0\r\n" + std::string(9, '\0'), ply);
        check("solid\nv 0 0 0\n", "vertices, but no faces: save it with faces (lines like f 1 2 3)");
    }
    SECTION("a mesh of vertices alone") {
        check(square, "vertices, but no faces: save it with faces (lines like f 1 2 3)");
        check("v 0 0 \x1b[31m" + std::string(100, 'x') + "\nf 1 1 1",
              "line 1: expected a number, found \"?[31m" + std::string(35, 'x') + "\"...");
    }
    SECTION("UTF-16, with a byte order mark or without") {
        const auto utf16 = [](const std::string& mark, std::size_t high) {
            std::string wide = mark;
            for (const char c : square + "f 1 2 3")
                wide += high == 0 ? std::string{'\0', c} : std::string{c, '\0'};
            return wide;
        };
        for (const std::string& text :
             {utf16("\xff\xfe", 1), utf16("\xfe\xff", 0), utf16("", 1), utf16("", 0)})
            check(text, "expected UTF-8, found UTF-16");
    }
    SECTION("UTF-32, with a byte order mark or without") {
        const std::string zeros(3, '\0');
        std::string little, big;
        for (const char c : square + "f 1 2 3") {
            little += c + zeros;
            big += zeros + c;
        }
        const std::string mark("\xff\xfe\0\0", 4), bigMark("\0\0\xfe\xff", 4);
        for (const std::string& text : {mark + little, bigMark + big, little, big})
            check(text, "expected UTF-8, found UTF-32");
    }
    SECTION("a line among carriage returns") {
        check("v 0 0 0\rv x\rf 1 1 1", "line 2: expected a number, found \"x\"");
    }
    SECTION("a continued line has the number of its beginning, and counts as all of its own") {
        check(square + "f 1 \\\n2\n", "line 5: a face has at least 3 corners, found 2");
        check("v 0 0 \\\n0\nf 1 1 2\n", "line 3: there is no vertex 2: the file has 1");
    }
    SECTION("a keyword that a backslash follows goes on") {
        check(square + "f\\\n 1 2 5\n", "line 5: there is no vertex 5: the file has 4");
    }
    SECTION("a name that ends in a backslash does not go on") {
        check("g C:\\parts\\\nv 0 0\nf 1 1 1\n", "line 2: expected a number, found the end of the line");
    }
    SECTION("the first of several") {
        check("f 1 2 3\nv x\n", "line 1: there is no vertex 2: the file has 1");
    }
}

namespace {

// Every construct, at random, so that cuts come to lie everywhere.
std::string randomObj(unsigned seed, bool withError) {
    std::mt19937 random(seed);
    const std::string lines[] = {
        "v 0.5 -1.25e-3 7\n", "v 1 2 \\\n 3\r\n",         "vt 0.25 0.5\n",
        "vn 0 0 1\n",         "# a comment \\\n",         "\n",
        "f -1 -2 -3 -1\n",    "v -0.25 3 0.5# \n",        "f -3 -1 2 1 -2 3\n",
        "f 1/1 2/-1 3/1\r\n", "f 1//1 \\\n-2//-1 3//1\n", "usemtl very_long_name\\\n of_a_material\n"};
    std::string text = square + "vt 0 0\nvn 0 0 1\n";
    for (int i = 0; i < 200; ++i) text += lines[random() % std::size(lines)];
    return withError ? text + "f 1 2 x\n" + text + "f 0\n" : text;
}

}  // namespace

TEST_CASE("A mesh has at most 200,000,000 triangles") {
    raytracer::requireTriangles(200'000'000, "mesh.obj");
    CHECK_THROWS_WITH(raytracer::requireTriangles(200'000'001, "mesh.obj"),
                      "mesh.obj: more than 200,000,000 triangles: use several meshes");
}

TEST_CASE("The number of chunks changes nothing in an OBJ") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::string text = randomObj(seed, false), broken = randomObj(seed, true);
        const MeshData one = raytracer::parseObjInChunks(text, 1);
        const std::string error = errorOf(broken);
        CHECK(error.ends_with("found \"x\""));
        for (const std::size_t chunks : {2, 3, 7, 64, 5000}) {
            CHECK(same(raytracer::parseObjInChunks(text, chunks), one));
            CHECK_THROWS_WITH(raytracer::parseObjInChunks(broken, chunks), error);
        }
    }
}

TEST_CASE("An OBJ from a file") {
    const TestFolder folder;
    SECTION("is read") {
        CHECK(raytracer::loadObj(folder.write("a.obj", square + "f 1 2 3")).triangleCount() == 1);
    }
    SECTION("that is empty") {
        const std::string path = folder.write("a.obj", "");
        CHECK_THROWS_WITH(raytracer::loadObj(path), path + ": it is empty");
    }
    SECTION("that is missing") {
        const std::string path = folder.file("b.obj");
        CHECK_THROWS_AS(raytracer::loadObj(path), Error);
        CHECK_THROWS_WITH(raytracer::loadObj(path), path + ": cannot read: No such file or directory");
    }
    SECTION("that is a folder") {
        CHECK_THROWS_WITH(raytracer::loadObj(folder.file("")),
                          folder.file("") + ": cannot read: Is a directory; name a file in it");
    }
    SECTION("of many chunks") {
        std::string text = square;
        while (text.size() < (3 << 20)) text += "f 1 2 3 4\n";
        CHECK(raytracer::loadObj(folder.write("a.obj", text)).triangleCount() ==
              (text.size() - square.size()) / 5);
        CHECK_THROWS_WITH(raytracer::loadObj(folder.write("a.obj", text + "f 1 2 9")),
                          folder.file("a.obj") + ": line " +
                              std::to_string(5 + (text.size() - square.size()) / 10) +
                              ": there is no vertex 9: the file has 4");
    }
}
