#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "raytracer/util/nearby_file.h"
#include "raytracer/util/temporary_folder.h"

using namespace raytracer;
namespace fs = std::filesystem;

TEST_CASE("a name to write is relative to the file in which it stands") {
    const TemporaryFolder folder;
    const std::string scenes = folder.file("scenes");
    fs::create_directories(scenes + "/textures");
    fs::create_directories(scenes + "/tex");
    for (const char* file : {"scenes/textures/wood.png", "scenes/tex/Wood.png", "stone.png"})
        std::ofstream(folder.file(file)) << "x";
    const auto name = [&](const char* written) { return nearbyName(scenes, written); };
    CHECK(name("scenes/textures/wood.png") == "textures/wood.png");
    CHECK(name("C:\\Users\\ada\\textures\\wood.png") == "textures/wood.png");
    CHECK(name("/home/ada/textures/wood.png") == "textures/wood.png");
    CHECK(name("..\\textures\\wood.png") == "textures/wood.png");
    CHECK(name("/home/ada/textures/wod.png") == "textures/wood.png");
    CHECK(name("/home/ada/pictures/Wood.png") == "tex/Wood.png");
    CHECK(name("stone.png") == "");
    CHECK(name("../ston.png") == "../stone.png");
    CHECK(name("marble.png").empty());
    std::ofstream(scenes + "/food.png") << "x";
    CHECK(name("wood.png") == "tex/Wood.png");  // in a folder, rather than misspelled
    CHECK(name("fod.png") == "food.png");
    CHECK(name("").empty());
    const std::string elsewhere = folder.file("ston.png");
    CHECK(nearbyName(scenes, elsewhere) == folder.file("stone.png"));
    const fs::path before = fs::current_path();
    fs::current_path(folder.file(""));
    CHECK(nearbyName("scenes", "stone.png") == "../stone.png");
    CHECK(nearbyName("", "scenes\\textures\\wod.png") == "scenes/textures/wood.png");
    fs::current_path(before);
}

TEST_CASE("a file is proposed where it is of the kind that the name is of") {
    const TemporaryFolder folder;
    for (const char* file :
         {"pict.png", "reference.png", "s.json", "touch", "raytracer", "b.json", "c.py", "o.png"})
        std::ofstream(folder.file(file)) << "x";
    const auto near = [&](const std::string& name) {
        return fs::path(nearbyFile(folder.file(name))).filename().string();
    };
    for (const char* name : {"pict.json", "reference.json", "s.png", "pict.obj", "s.part", "nosuch", "b.js",
                             "c.sh", "pict.txt", "c.pyy.png", "w.png"})
        CHECK(near(name) == "");
    CHECK(near("pict.jpg") == "pict.png");
    CHECK(near("pict.PFM") == "pict.png");
    CHECK(near("referense.jpeg") == "reference.png");
    CHECK(near("referense.png") == "reference.png");
    CHECK(near("s.jsom") == "s.json");
    CHECK(near("pict.pgn") == "pict.png");
    CHECK(near("o.pgn") == "o.png");
    CHECK(near("pict") == "pict.png");
    CHECK(near("tuch") == "touch");
    CHECK(near("raytracr") == "raytracer");
}

TEST_CASE("a file is found near a name that leads nowhere") {
    const TemporaryFolder folder;
    const std::string scenes = folder.file("scenes");
    fs::create_directories(scenes + "/textures/old");
    for (const char* file :
         {"ball.json", "Room.json", "textures/checker.png", "textures/old/wood.jpg", ".hidden.png"})
        std::ofstream(scenes + "/" + file) << "x";
    const auto near = [&](const std::string& path) {
        const std::string found = nearbyFile(scenes + path);
        return found.substr(std::min(found.size(), scenes.size()));
    };
    CHECK(near("/checker.png") == "/textures/checker.png");
    CHECK(near("/Checker.PNG") == "/textures/checker.png");
    CHECK(near("/wood.jpg") == "/textures/old/wood.jpg");
    CHECK(near("/room.json") == "/Room.json");
    CHECK(near("/bal.json") == "/ball.json");
    CHECK(near("/ball") == "/ball.json");
    CHECK(near("/ball.jsn") == "/ball.json");
    CHECK(near("/textures/checker.jpg") == "/textures/checker.png");
    CHECK(near("\\textures\\checker.png") == "/textures/checker.png");
    CHECK(near("/texture/checker.png") == "/textures/checker.png");
    CHECK(near("/texture/wood") == "/textures/old/wood.jpg");
    CHECK(nearbyFile(folder.file("checker")) == scenes + "/textures/checker.png");
    CHECK(nearbyFile(folder.file("bal.json")) == scenes + "/ball.json");
    CHECK(nearbyFile(folder.file("rooms.json")) == scenes + "/Room.json");
    CHECK(nearbyFile(folder.file("bal.png")).empty());
    std::ofstream(scenes + "/textures/old/checker.json") << "x";
    std::ofstream(folder.file("zoo.json")) << "x";
    std::ofstream(scenes + "/zoo.png") << "x";
    CHECK(nearbyFile(folder.file("checker")) == scenes + "/textures/checker.png");  // the nearest
    CHECK(nearbyFile(folder.file("scene/ball.json")) == scenes + "/ball.json");
    CHECK(near("/hidden.png").empty());
    CHECK(near("/tree.json").empty());
    CHECK(nearbyFile("/frobnicate.json").empty());
    CHECK(hintAt(scenes + "/ball") == "; there is \"" + scenes + "/ball.json\"");
    CHECK(hintAt(scenes + "/tree.json").empty());
    const auto missing = std::make_error_code(std::errc::no_such_file_or_directory);
    CHECK(std::string(folderError(folder.file("Scenes"), missing).what()) ==
          folder.file("Scenes") + ": cannot read the folder: No such file or directory; there is \"" +
              scenes + "\"");
    CHECK(std::string(folderError(folder.file("tests"), missing).what()) ==
          folder.file("tests") + ": cannot read the folder: No such file or directory");
    errno = ENOENT;
    CHECK(missingFolder(scenes + "/a.png").empty());
    CHECK(missingFolder(folder.file("no/a.png")) == "; there is no folder \"" + folder.file("no") + "\"");
}
