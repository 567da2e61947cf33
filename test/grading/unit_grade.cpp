#include <catch2/catch.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "../support/scene_files.h"
#include "raytracer/grading/grade_files.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/child_process.h"
#include "raytracer/util/temporary_folder.h"

using namespace raytracer;
using Catch::Matchers::Contains;
using raytracer::test::wholePicture;

namespace {

std::string textOf(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

void touch(const std::string& path) { std::ofstream file(path); }

ByteImage flat(int size, int value) {
    const auto count = static_cast<std::size_t>(3 * size * size);
    return {size, size, LargeVector<std::uint8_t>(count, static_cast<std::uint8_t>(value))};
}

// A case whose reference is black and 10 pixels large.
GradeCase blackCase(const TemporaryFolder& folder, const std::string& name = "black") {
    writePng(folder.file(name + ".png"), flat(10, 0));
    std::filesystem::copy_file(SOURCE_DIR "/test/good/least.json", folder.file(name + ".json"),
                               std::filesystem::copy_options::overwrite_existing);
    return {name, name, &completeStage(), folder.file(name + ".json"), folder.file(name + ".png")};
}

CaseRenderer flatRenderer(int size, int value) {
    return [=](const GradeCase&, int, const std::string& out) {
        writePng(out, flat(size, value));
        return Rendered{};
    };
}

struct Silence : ProgressListener {
    void progress(double) override {}
};

std::vector<std::string> namesOf(const GradePlan& plan) {
    std::vector<std::string> names;
    for (const GradeCase& test : plan.cases) names.push_back(test.name);
    return names;
}

}  // namespace

TEST_CASE("grade: the plan") {
    const TemporaryFolder folder;
    for (const char* name :
         {"cone_cube.json", "cone_cube.png", "cone_cube-normals.png", "cone_cube-raytracing.png",
          "cone_cube-sketch.png", "alone.json", "3d.json", "3d-ambient.PNG", "nobody.png", "notes.txt"})
        touch(folder.file(name));
    const GradePlan plan = planGrading(folder.file(""), folder.file(""));
    CHECK(namesOf(plan) ==
          std::vector<std::string>{"3d-ambient", "cone_cube", "cone_cube-normals", "cone_cube-raytracing"});
    CHECK(plan.scenesWithoutReference == std::vector<std::string>{"alone.json"});
    CHECK(plan.cases[0].group == "3d");
    CHECK(plan.cases[1].group == "cone_cube");
    CHECK(plan.cases[0].stage->only == "ambient");
    CHECK(plan.cases[1].stage == &completeStage());
    CHECK(plan.cases[2].stage->pass == "normals");
    CHECK(plan.cases[3].stage == &completeStage());
    CHECK(plan.cases[2].scene == folder.file("cone_cube.json"));
    CHECK(plan.cases[2].reference == folder.file("cone_cube-normals.png"));
    REQUIRE(plan.strays.size() == 1);
    CHECK(plan.strays[0].path == folder.file("cone_cube-sketch.png"));
    CHECK(plan.strays[0].why == "no stage \"sketch\"; --help lists them");
}

TEST_CASE("grade: references of another folder") {
    const TemporaryFolder scenes, references;
    touch(scenes.file("a.json"));
    touch(scenes.file("a.png"));
    touch(references.file("a-diffuse.png"));
    CHECK(namesOf(planGrading(scenes.file(""), references.file(""))) ==
          std::vector<std::string>{"a-diffuse"});
    CHECK_THROWS_WITH(planGrading(scenes.file("no"), references.file("")),
                      Contains("no: cannot read the folder: "));
    CHECK_THROWS_WITH(planGrading(scenes.file(""), references.file("no")),
                      Contains("no: cannot read the folder: "));
}

TEST_CASE("grade: a picture is rendered at the reference's size and compared") {
    const TemporaryFolder folder;
    const GradeCase test = blackCase(folder);
    SECTION("equal") {
        const GradeResult result = gradeCase(test, flatRenderer(10, 0));
        CHECK(result.score() == 100);
        CHECK(within(result, {}));
        CHECK(result.message.empty());
        CHECK(result.referencePng == textOf(test.reference));
        CHECK(result.ourPng.substr(1, 3) == "PNG");
        CHECK(result.differencePng.substr(1, 3) == "PNG");
    }
    SECTION("off by one") {
        const GradeResult result = gradeCase(test, flatRenderer(10, 1));
        CHECK(result.score() == 96);
        CHECK_FALSE(within(result, {}));
        CHECK(within(result, {.maxPixels = {}, .tolerance = {}, .minScore = 96}));
    }
    SECTION("the size that the program is told") {
        int asked = 0;
        const CaseRenderer render = [&](const GradeCase&, int longEdge, const std::string&) {
            asked = longEdge;
            return Rendered{};
        };
        gradeCase(test, render);
        CHECK(asked == 10);
    }
}

TEST_CASE("grade: what is wrong is a result") {
    const TemporaryFolder folder;
    GradeCase test = blackCase(folder);
    const auto messageOf = [&](const CaseRenderer& render) {
        const GradeResult result = gradeCase(test, render);
        CHECK(result.score() == 0);
        CHECK_FALSE(result.comparison);
        CHECK_FALSE(within(result, {.maxPixels = {}, .tolerance = {}, .minScore = 0}));
        return result.message;
    };
    const auto saying = [](Rendered rendered) {
        return [=](const GradeCase&, int, const std::string&) { return rendered; };
    };
    CHECK(messageOf(flatRenderer(9, 0)) == "expected 10 x 10 pixels, as the reference has, found 9 x 9");
    CHECK(messageOf(saying({})) == "wrote no picture");
    CHECK(messageOf(saying({false, "exit status 3", ""})) == "exit status 3, wrote no picture");
    CHECK(messageOf(saying({true, "crashed: Aborted", ""})) == "crashed: Aborted");
    CHECK_THAT(messageOf([](const GradeCase&, int, const std::string& out) {
                   std::ofstream(out) << "no picture";
                   return Rendered{};
               }),
               Contains("PNG"));
    CHECK(messageOf([&](const GradeCase&, int, const std::string& out) {
              std::filesystem::create_symlink("/dev/zero", out);
              return Rendered{};
          }) == "wrote no picture");
}

TEST_CASE("grade: what fails on the grader's side is no result") {
    const TemporaryFolder folder;
    GradeCase test = blackCase(folder);
    CHECK_THROWS_AS(
        gradeCase(test,
                  [](const GradeCase&, int, const std::string&) -> Rendered { throw std::bad_alloc(); }),
        std::bad_alloc);
    touch(test.reference);
    CHECK_THROWS_WITH(gradeCase(test, flatRenderer(10, 0)), test.reference + ": it is empty");
    std::filesystem::remove(test.reference);
    REQUIRE(::mkfifo(test.reference.c_str(), 0600) == 0);
    CHECK_THROWS_WITH(gradeCase(test, flatRenderer(10, 0)),
                      test.reference + ": cannot read: it is no regular file");
}

TEST_CASE("grade: a picture that was rendered before a crash does not count") {
    const TemporaryFolder folder;
    const GradeResult result =
        gradeCase(blackCase(folder), [](const GradeCase&, int, const std::string& out) {
            writePng(out, flat(10, 0));
            return Rendered{true, "crashed: Aborted", "at the end"};
        });
    CHECK(result.score() == 0);
    CHECK(result.message == "crashed: Aborted");
    CHECK(result.output == "at the end");
}

TEST_CASE("grade: a program is told scene, picture and size") {
    const TemporaryFolder folder;
    const GradeCase test = blackCase(folder, "it's \"black\" $HOME");
    std::ofstream(folder.file("program.sh"))
        << "echo \"$1\"; [ \"$3\" = 10 ] && cp '" + blackCase(folder).reference + "' \"$2\"";
    const GradeResult result = gradeCase(test, programRenderer("sh " + folder.file("program.sh"), {}));
    CHECK(result.score() == 100);
    CHECK(result.message.empty());
    CHECK_THAT(result.output, Catch::Matchers::EndsWith("/it's \"black\" $HOME.json\n"));
    CHECK(result.output != test.scene + "\n");
}

TEST_CASE("grade: of a program's command, what it starts first") {
    using Words = std::vector<std::string>;
    CHECK(filesStarted("") == Words{});
    CHECK(filesStarted("./run --fast  7") == Words{"./run"});
    CHECK(filesStarted("{}/run; true") == Words{"{}/run"});
    CHECK(filesStarted("{}/run\t-x|tee log") == Words{"{}/run"});
    CHECK(filesStarted("a{}b{}") == Words{"a{}b{}"});
    CHECK(filesStarted("'my run' x") == Words{"my run"});
    CHECK(filesStarted("python3 \"my file.py\" a.py") == Words{"python3", "my file.py"});
    CHECK(filesStarted("python3 -W ignore a.py b.py") == Words{"python3", "a.py"});
    CHECK(filesStarted("/usr/bin/python3.12 -u b.PY c.py") == Words{"/usr/bin/python3.12", "b.PY"});
    CHECK(filesStarted("java -cp a.jar:b.jar Main") == Words{"java"});
    CHECK(filesStarted("java -Xmx1g -jar {}/rt.jar x.jar") == Words{"java", "{}/rt.jar"});
    CHECK(filesStarted("sh -c a.sh") == Words{"sh"});
    CHECK(filesStarted("python3 -m a.py") == Words{"python3"});
    CHECK(filesStarted("touch x.py; ./run") == Words{"touch"});
    CHECK(filesStarted("timeout 8 python3 a.py") == Words{"timeout"});
    for (const char* unsure : {"A=1 ./run", "./r*n", "(cd x && ./run)", "run() { true; }; run",
                               "2>/dev/null run", "run || ./run", "~me/run", "$A/run", "# run"})
        CHECK(filesStarted(unsure) == Words{});
}

TEST_CASE("grade: a program that cannot be started is a fault of its command") {
    CHECK(programFault("true").empty());
    CHECK(programFault("exec sh").empty());
    CHECK(programFault("no-such-command-here") == "there is no command no-such-command-here");
    CHECK(programFault("/no/run; true") == "there is no file /no/run");
    CHECK(programFault("sh /no/run.sh") == "there is no file /no/run.sh");
    CHECK(programFault("sh {}/run.sh").empty());
    CHECK(programFault("\"/no/my run\"") == "there is no file /no/my run");
    for (const char* valid :
         {"java_() { :; }; java_", "2>/dev/null true", "echo -cp a.jar:b.jar", "touch x.py", "rm -f old.py",
          "test -e x.sh || true", "echo a.py", "env -C /tmp python3 inner.py", "no-such-command || true",
          "env docker run img python3 /app/main.py", "sh true.sh || :", "sh -c 'x.py'", "sh ls"})
        CHECK(programFault(valid).empty());
    for (const char* broken : {"{}/run \"", "'{}/run", "{}/run )", "if {}/run"})
        CHECK_THAT(programFault(broken), Contains("a shell cannot read it: sh: "));
    const TemporaryFolder folder;
    CHECK(programFault("echo >" + folder.file("made") + "\necho >" + folder.file("made")).empty());
    CHECK_FALSE(std::filesystem::exists(folder.file("made")));  // it is read, not run
    CHECK(programFault("/tmp") == "/tmp is a folder: name a program in it");
}

TEST_CASE("grade: of what a program prints, the end is kept") {
    const TemporaryFolder folder;
    const GradeResult result = gradeCase(blackCase(folder), programRenderer("seq 1 100000; echo", {}));
    CHECK(result.message == "wrote no picture");
    CHECK(result.output.size() == 2004);
    CHECK(result.output.find("... ") == 0);
    CHECK(result.output.find("\n99999\n100000\n") != std::string::npos);
}

TEST_CASE("grade: the shell's remark on a crash is left out of what the program printed") {
    const TemporaryFolder folder;
    const GradeResult result =
        gradeCase(blackCase(folder), programRenderer("sh -c 'echo falling; kill -SEGV $$'", {}));
    CHECK(result.message == "crashed: Segmentation fault");
    CHECK(result.output == "falling\n");
    CHECK(gradeCase(blackCase(folder), programRenderer("sh -c 'kill -SEGV $$'", {})).output.empty());
}

TEST_CASE("grade: the shelf of a page's pictures has equal ones once, and many in a folder") {
    const TemporaryFolder folder;
    PictureShelf shelf(folder.file("all.html"));
    const std::string key = shelf.add("one");
    CHECK(shelf.add("one") == key);
    CHECK(shelf.add("").empty());
    CHECK(shelf.addresses() == "{\n  \"" + key + "\": \"data:image/png;base64,b25l\"\n}");
    CHECK_FALSE(std::filesystem::exists(folder.file("all_pictures")));
    const std::string large = shelf.add(std::string(std::size_t{21} << 20, 'x'));
    CHECK(textOf(folder.file("all_pictures/" + key + ".png")) == "one");
    for (const std::string& one : {key, large})
        CHECK(shelf.addresses().find("\"" + one + "\": \"all_pictures/" + one + ".png\"") !=
              std::string::npos);
    CHECK(std::filesystem::file_size(folder.file("all_pictures/" + large + ".png")) == std::size_t{21} << 20);
}

TEST_CASE("grade: pictures of one hash have a place each on the shelf") {
    const TemporaryFolder folder;
    PictureShelf shelf(folder.file("all.html"));
    const std::string one = "one picture, one", other = "picabmrbO52W9J01";  // of one hash in libstdc++
    const std::string key = shelf.add(one);
    CHECK(shelf.add(other) != key);
    shelf.add(std::string(std::size_t{21} << 20, 'x'));  // from now on they are in files
    CHECK(shelf.add(one) == key);
    CHECK(textOf(folder.file("all_pictures/" + shelf.add(other) + ".png")) == other);
}

TEST_CASE("child process: how it ends") {
    const TemporaryFolder folder;
    const std::string log = folder.file("log");
    const auto run = [&](const std::string& command, double wall = 10) {
        return runProcess({command, {}, log, {.wallSeconds = wall}});
    };
    SECTION("well") {
        const ProcessEnd end = runProcess({"echo", {"a  b", "$HOME", "'"}, log});
        CHECK(end.well());
        CHECK(end.description().empty());
        CHECK(textOf(log) == "a  b $HOME '\n");
    }
    SECTION("both outputs are kept, in order") {
        CHECK(run("sh -c 'echo out; echo err >&2; echo out'").well());
        CHECK(textOf(log) == "out\nerr\nout\n");
    }
    SECTION("nothing to read") { CHECK(run("cat").well()); }
    SECTION("with a status") { CHECK(run("sh -c 'exit 3'").description() == "exit status 3"); }
    SECTION("by a signal") {
        CHECK(run("sh -c 'kill -SEGV $$'").signal == SIGSEGV);
        CHECK(run("sh -c 'kill -ABRT $$'").description() == "crashed: Aborted");
    }
    SECTION("there is no such program") {
        CHECK(run("./no-such-program").description() == "could not be started");
    }
    SECTION("with what it started in a session of its own") {
        const std::string pid = folder.file("pid");
        const std::string start = "setsid sh -c 'echo $$ > " + pid + "; exec sleep 60' &";
        CHECK(run("eval \"" + start + "\"; while [ ! -s " + pid + " ]; do :; done; true").well());
        CHECK(::kill(std::stoi(textOf(pid)), 0) == -1);
    }
    SECTION("too slow, in several processes together") {
        const ProcessEnd end = runProcess(
            {"sh -c 'while :; do :; done & while :; do :; done'", {}, log, {.processorSeconds = 0.3}});
        CHECK(end.stop == ProcessEnd::Stop::TooSlow);
        CHECK_THAT(end.description(),
                   Catch::Matchers::Matches("too slow: 0\\.[3-9]\\d? s of processor time"));
    }
    SECTION("with too many processes") {
        const ProcessEnd end = runProcess(
            {"sh -c 'for i in 1 2 3 4 5 6 7 8 9; do sleep 60 & done; wait'", {}, log, {.processes = 8}});
        CHECK(end.description() == "started too many processes");
    }
    SECTION("with too much output, too much memory") {
        ProcessLimits limits;
        limits.output = 1 << 20;
        CHECK(runProcess({"exec yes", {}, log, limits}).description() == "printed or wrote too much");
        CHECK(std::filesystem::file_size(log) == 1 << 20);
        limits.memory = 1 << 27;
        CHECK_FALSE(
            runProcess(
                {"sh -c 'head -c 500000000 /dev/zero | tail -c 499999999 > /dev/null'", {}, log, limits})
                .well());
    }
    SECTION("several at once, each with its own") {
        std::vector<std::string> ended;
        runProcesses(
            3, 3,
            [&](std::size_t i) {
                return ProcessStart{
                    i == 0 ? "sleep 60" : "true", {}, log + std::to_string(i), {.wallSeconds = 0.3}};
            },
            [&](std::size_t i, const ProcessEnd& end) {
                ended.push_back(std::to_string(i) + end.description());
            });
        std::sort(ended.begin(), ended.end());
        CHECK(ended == std::vector<std::string>{"0hung: stopped after 0.3 s", "1", "2"});
    }
    SECTION("where it is told to") {
        CHECK(runProcess({"pwd; echo $TMPDIR", {}, log, {}, folder.file("")}).well());
        CHECK_THAT(textOf(log), Contains(folder.file("")));
    }
    SECTION("when it kills what watches it, with all it started, and alone") {
        const std::string pid = folder.file("pid");
        std::vector<std::string> ended;
        runProcesses(
            2, 2,
            [&](std::size_t i) {
                const std::string command = "setsid sh -c 'echo $$ > " + pid +
                                            "; exec sleep 60' & while [ ! -s " + pid +
                                            " ]; do :; done; kill -KILL $PPID; sleep 60";
                return ProcessStart{i == 0 ? command : "sleep 0.3", {}, log + std::to_string(i)};
            },
            [&](std::size_t i, const ProcessEnd& end) {
                ended.push_back(std::to_string(i) + end.description());
            });
        CHECK(ended == std::vector<std::string>{"0crashed: Killed", "1"});
        CHECK(::kill(std::stoi(textOf(pid)), 0) == -1);
    }
    SECTION("late, when it halts what watches it") {
        const std::string pid = folder.file("pid");
        const ProcessEnd end = run("echo $$ > " + pid + "; kill -STOP $PPID; sleep 60", 0.2);
        CHECK(end.description() == "hung: stopped after 0.2 s");
        CHECK(::kill(std::stoi(textOf(pid)), 0) == -1);
    }
    SECTION("late, with all it started") {
        const ProcessEnd end =
            run("sh -c '(sleep 1; echo late > " + folder.file("late") + ") & sleep 60'", 0.2);
        CHECK(end.stop == ProcessEnd::Stop::Hung);
        CHECK_FALSE(end.well());
        CHECK(end.description() == "hung: stopped after 0.2 s");
        CHECK(run("sleep 1.2").well());
        CHECK_FALSE(std::filesystem::exists(folder.file("late")));
    }
}

TEST_CASE("grade: worst first") {
    GradeResult none, low, high, highOff;
    low.comparison.emplace().score = 3;
    high.comparison.emplace().score = 100;
    highOff.comparison.emplace().rmse = 0.5;
    CHECK(isWorse(none, low));
    CHECK(isWorse(low, high));
    CHECK(isWorse(highOff, high));
    CHECK_FALSE(isWorse(high, highOff));
    CHECK_FALSE(isWorse(high, high));
    GradeResult named = high;
    named.test.name = "b";
    CHECK(isWorse(high, named));
}

TEST_CASE("grade: what is wrong with a submission, beside the pictures that are missing") {
    const TemporaryFolder folder;
    GradedSubmission ada{"ada", {}};
    const auto addMissing = [&](const char* name) {
        GradeResult& result = ada.results.emplace_back();
        result.test.name = name;
        result.isMissing = true;
        result.message = std::string("no picture ") + name + ".png";
    };
    ada.results.push_back(gradeCase(blackCase(folder, "mesh"), flatRenderer(10, 9)));
    addMissing("cone");
    CHECK(ada.fault({}) == "no mistake looked for: the reference is not our picture; cone is missing");
    ada.results[0].mistakes = {"without shadows"};
    addMissing("cube");
    CHECK(ada.fault({}) == "without shadows; cone and cube are missing");
    addMissing("glass");
    CHECK(ada.remarks({}) == "without shadows; cone, cube and glass are missing");
    ada.results.push_back(gradeCase(blackCase(folder, "plane"), flatRenderer(10, 1)));
    addMissing("scene");
    addMissing("texture");
    CHECK(ada.fault({}) == "without shadows (1 of 2 wrong pictures); cone, cube and 3 more are missing");
    CHECK_THAT(classTable({&ada, 1}, {}), Catch::Matchers::EndsWith(" missing; worst: mesh (65)\n"));
    ada.results[0] = ada.results[4] = gradeCase(blackCase(folder, "plane"), flatRenderer(10, 0));
    CHECK(ada.fault({}) == "cone, cube and 3 more are missing");
    CHECK_THAT(classTable({&ada, 1}, {}), Catch::Matchers::EndsWith(" and 3 more are missing\n"));
}

TEST_CASE("grade: the mistake of most wrong pictures, counted by its whole name") {
    GradedSubmission ada{"ada", std::vector<GradeResult>(2)};
    for (GradeResult& result : ada.results) result.comparison.emplace().pixelsByDifference[2] = 1;
    const std::string first = "without light 0 (of 2)", second = "without light 1 (of 2)";
    ada.results.resize(1);
    ada.results[0].mistakes = {first, second};
    CHECK(ada.fault({}) == first);
    ada.results.push_back(ada.results[0]);
    ada.results[1].mistakes = {second};
    CHECK(ada.fault({}) == second);
    ada.results[0].mistakes = {"with max_recursion 1 instead of 5"};
    ada.results[1].mistakes = {"with max_recursion 2 instead of 5"};
    CHECK(ada.fault({}) == "with max_recursion 1 instead of 5 (1 of 2 wrong pictures)");
    for (GradeResult& result : ada.results) result.comparison.reset();
    ada.results[0] = ada.results[1] = {};
    ada.results[0].message = "too slow: 2.1 s of processor time";
    ada.results[1].message = "too slow: 2.2 s of processor time";
    CHECK(ada.fault({}) == "too slow: 2.1 s of processor time");
    ada.results[0].instead = "cone.png is there";
    ada.results[1].instead = "cube.png is there";
    for (GradeResult& result : ada.results) result.message = "wrote no picture" + result.butInstead();
    CHECK(ada.fault({}) == "wrote no picture, but cone.png is there");
}

TEST_CASE("grade: a right program's other roundings are told") {
    const TemporaryFolder folder;
    const GradeCase test = blackCase(folder);
    const auto namer = [&](const GradeCase&, const ImageSize& size) {
        const SceneDescription scene = loadScene(test.scene).description;
        return std::make_unique<MistakeNamer>(scene, wholePicture(scene, size.width));
    };
    const auto faultOf = [&](int pixels, int off) {
        const CaseRenderer render = [=](const GradeCase&, int, const std::string& out) {
            ByteImage image = flat(10, 0);
            for (int i = 0; i < pixels; ++i)
                image.pixels[static_cast<std::size_t>(7 * i)] = static_cast<std::uint8_t>(off);
            writePng(out, image);
            return Rendered{};
        };
        const GradedSubmission ada{"ada", {gradeCase(test, render, namer), gradeCase(test, render, namer)}};
        return ada.fault({});
    };
    CHECK(faultOf(2, 1) == "rounding (4 pixels by 1)");
    CHECK(faultOf(2, 2) == "too few wrong pixels to tell the mistake");
    CHECK(faultOf(9, 1) == "too few wrong pixels to tell the mistake");  // more than rounding changes
    CHECK(faultOf(30, 9) == "no known mistake");
}

TEST_CASE("grade: an archive beside the submissions is one to unpack, where no folder has its name") {
    const TemporaryFolder exam, handedIn;
    blackCase(exam);
    for (const char* name : {"ada", "bob.2"}) std::filesystem::create_directory(handedIn.file(name));
    for (const char* name : {"ada.zip", "bob.2.tar.gz", "notes.txt", "cyd.TAR.GZ", ".zip", "Eve.zip"})
        touch(handedIn.file(name));
    REQUIRE(::mkfifo(handedIn.file("pipe.zip").c_str(), 0600) == 0);
    const std::vector<Submission> submissions = submissionsIn(handedIn.file(""));
    std::vector<std::string> names;
    for (const Submission& submission : submissions) names.push_back(submission.name);
    CHECK(names == std::vector<std::string>{"Eve.zip", "ada", "bob.2", "cyd.TAR.GZ"});
    const GradePlan plan = planGrading(exam.file(""), exam.file(""));
    Silence progress;
    for (const char* program : {"", "cp {}/black.png"}) {
        const auto graded =
            gradeClass(plan, submissions, {.program = program, .run = {}}, {}, nullptr, progress);
        REQUIRE(graded.size() == 4);
        CHECK(graded[0].fault({}) == "an archive: unpack it into a folder");
        CHECK(graded[3].remarks({}) == "an archive: unpack it into a folder");
        CHECK(remark(graded[3].results.at(0)) == "an archive: unpack it into a folder");
        CHECK(graded[1].name == "ada");
    }
    CHECK_THAT(classTable(gradeClass(plan, submissions, {}, {}, nullptr, progress), {}),
               Contains("  0.0   0/1    Eve.zip     an archive: unpack it into a folder\n"));
}

TEST_CASE("grade: the mistakes of a class are traced on the threads that grade it") {
    const TemporaryFolder exam, handedIn;
    std::filesystem::create_directory(handedIn.file("ada"));
    for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
        blackCase(exam, name);
        writePng(handedIn.file("ada/" + std::string(name) + ".png"), flat(10, 255));
    }
    std::atomic<int> there = 0;  // traces on the thread itself
    const NamerMaker makeNamer = [&](const GradeCase&, const ImageSize&) {
        const auto here = std::this_thread::get_id();
        onTracingThreads(1, 1, RenderOptions().max_recursion,
                         [&](JobQueue&) { there += std::this_thread::get_id() == here; });
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // so that every thread takes a case
        return std::unique_ptr<MistakeNamer>();
    };
    Silence progress;
    gradeClass(planGrading(exam.file(""), exam.file("")), submissionsIn(handedIn.file("")), {}, makeNamer,
               nullptr, progress);
    CHECK(there == 6);
}

TEST_CASE("grade: what a program printed is in the JSON") {
    GradedSubmission ada{"ada", std::vector<GradeResult>(1)};
    ada.results[0].message = "exit status 3, wrote no picture";
    ada.results[0].output = "line 1\nline 2\x1b[2J\n";
    CHECK_THAT(gradesAsJson({&ada, 1}, {}), Contains("\"output\": \"line 1\\nline 2\\\\x1b[2J\\n\""));
}

TEST_CASE("grade: the report") {
    const TemporaryFolder folder;
    std::vector<GradeResult> results{gradeCase(blackCase(folder, "cone_a"), flatRenderer(10, 0)),
                                     gradeCase(blackCase(folder, "cone_b"), flatRenderer(10, 9)),
                                     gradeCase(blackCase(folder, "sphere"), flatRenderer(10, 1))};
    results[0].test.group = results[1].test.group = "cone";
    results[2].message = "<exit> & \"status\"";
    results[2].output = "</pre><script>";
    results[0].referencePng = "Man";
    results[1].referencePng = "Ma";
    results[2].referencePng = "M";
    const std::string html = gradeReport({"", results}, {}, "a<b");
    const auto has = [&](const char* part) {
        return html.find(part) != std::string::npos;
    };  // brief, should it fail
    CHECK(has("<title>a&lt;b</title>"));
    CHECK(has("&lt;exit&gt; &amp; &quot;status&quot;"));
    CHECK(has("&lt;/pre&gt;&lt;script&gt;"));
    CHECK(has("base64,TWFu\""));  // RFC 4648
    CHECK(has("base64,TWE=\""));
    CHECK(has("base64,TQ==\""));
    CHECK(has("<b>1</b> of <b>3</b> pictures as the reference, mean score <b>87.0</b>"));
    CHECK_FALSE(has("http"));  // nothing is fetched
    CHECK(html.find(">cone_b<") < html.find(">cone_a<"));
    CHECK(html.find(">cone_a<") < html.find(">sphere<"));  // its group has the worst one
}
