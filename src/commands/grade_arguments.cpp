#include "grade_arguments.h"

#include <algorithm>

#include "raytracer/grading/submissions.h"
#include "raytracer/util/shell_words.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr const char* gradeFooter =
    R"(Renders and compares every X.json in DIR that has a picture X.png or
X-STAGE.png. The stages:
  raycasting, normals, ambient, diffuse, specular, ambient_diffuse_specular,
  ambient_diffuse_specular_shadows, diffuse_reflections_recursions_3,
  raytracing (as X.png: everything)
A program is graded for the last of them, unless --stage says otherwise. It runs
in a fresh folder with a copy of the scene and of what that names, and nothing
else; a path of yours in PROGRAM is found all the same. If it crashes, hangs, is
too slow or writes no picture, it gets 0 for that scene.
Of each wrong picture the mistake is named, where a known one explains it.

With --submissions, each folder in that folder is one: its pictures are X.png or
X-STAGE.png anywhere beneath it, the nearest to its top; or --program makes
them, in which {} is the submission's folder.

Exit status: 0 all the same; 1 not the same; 2 there is nothing to grade, or the
grader itself cannot work: a scene or a reference is broken, a submission cannot
be read, a disk is full. Of submissions 0 once all are graded, whatever they
score; 1 where a picture is below --min-score; 2 as above.
"The same" as for `raytracer compare`: no pixel differs, or what --max-pixels,
--tolerance and --min-score say, for each picture.

Examples:
  raytracer grade scenes --references test/expected
  # a page that shows every pixel that differs
  raytracer grade reference --report report.html
  raytracer grade exam --program ~/ada/raytracer --report ada.html
  raytracer grade exam --program "python3 bob.py" --timeout 120
  raytracer grade homework2 --program ./raycasting --stage raycasting
  # a class: a page, and a table for a spreadsheet
  raytracer grade exam --submissions pictures --report all.html --csv all.csv
  raytracer grade exam --submissions code --program "{}/build/raytracing")";

std::vector<std::string> stageNames() {
    std::vector<std::string> names;
    for (const Stage& known : stages()) names.emplace_back(known.name);
    return names;
}

// The message for more than one argument: `grade` takes one folder.
std::string otherCommandMeant(std::span<const std::string> words) {
    if (words.size() != 2) return {};
    std::string first = words[0], second = words[1];
    if (endsIn(second, ".json")) std::swap(first, second);
    const std::string takesFolder = "it takes a folder; write raytracer ";
    if (endsIn(first, ".json") && isPictureName(second))
        return takesFolder + "explain " + first + " --picture " + second;
    if (isPictureName(first) && isPictureName(second)) return takesFolder + "compare " + first + " " + second;
    return "one folder is graded; write --references " + second;
}

// Throws UsageError unless the command has a "{}", the submission's folder, outside of quotes: the grader
// quotes the folder itself.
void requireFolderIn(const std::string& program) {
    if (program.find("{}") == program.npos)
        throw UsageError("--program: expected {} for the submission's folder, found " + inQuotes(program));
    if (std::ranges::any_of(shellWords(program), &ShellWord::quotesBraces))
        throw UsageError("--program: write {} without quotes: it is quoted already");
}

}  // namespace

void GradeArguments::addTo(CommandLine& line) {
    line.text("DIR", scenes, "The folder of the scenes", ArgumentKind::Folder);
    line.text("--references", references, "The folder of the reference pictures, where it is not DIR",
              ArgumentKind::Folder);
    line.choice("--stage", stage, stageNames(), "Grade only the pictures of this stage");
    line.text("--submissions", submissions, "Grade each folder in this folder", ArgumentKind::Folder);
    addProgramTo(line);
    addFilesTo(line);
    addThresholds(line, thresholds);
    addSilence(line, quiet);
    line.lacks({"--size"}, "a picture has its reference's size, which a program is told");
    line.answers(otherCommandMeant);
    line.footer(gradeFooter);
}

void GradeArguments::addProgramTo(CommandLine& line) {
    line.text("--program", program, "Grade another program: runs PROGRAM scene.json out.png SIZE");
    line.shown("--program", "PROGRAM", "a command");
    line.number("--timeout", options.limits.processorSeconds, above(0),
                "Seconds of processor time after which it is stopped");
    line.number("--wall", options.limits.wallSeconds, above(0),
                "Seconds on the clock after which it is stopped");
    line.number("--memory", memory, {1, 500000}, "MiB of memory for each of its processes");
    line.text("--user", options.user, "As root: run it as this user");
    line.shown("--user", "NAME", "a name");
    line.number("--jobs", jobs, {1, 1024}, "Programs to run side by side");
    for (const char* option : {"--timeout", "--wall", "--memory", "--user", "--jobs"})
        line.needs(option, "--program");
    line.needs("--jobs", "--submissions");
}

void GradeArguments::addFilesTo(CommandLine& line) {
    line.output("--report", report,
                "Write a page with all pictures: .html; those of a class that are more than 20 MB lie in "
                "a folder beside it");
    line.output("--csv", csv, "Write the scores as CSV, a row for each submission");
    line.output("--json", json, "Write all results as JSON");
    line.output("--junit", junit, "Write all results as JUnit's XML, for CI systems");
    line.output("--gradescope", gradescope, "Write Gradescope's results.json, of one submission");
    line.number("--points", points, above(0), "Gradescope's points for each picture");
    line.needs("--points", "--gradescope");
}

void GradeArguments::show(const std::string& text) const {
    if (!quiet) print(text);
}

ProgramOptions GradeArguments::programOptions() const {
    ProgramOptions all = options;
    all.limits.memory = static_cast<std::uint64_t>(memory) << 20;
    return all;
}

void GradeArguments::check() const {
    if (submissions.empty() && program.starts_with("{}"))
        throw UsageError("--program: {} is a submission's folder: it needs --submissions");
    if (!submissions.empty() && !program.empty()) requireFolderIn(program);
    if (!program.empty()) requirePrograms();
    if (const std::string fault = programFault(program); !fault.empty())
        throw UsageError("--program: " + fault);
    if (!report.empty() && !endsIn(report, ".html") && !endsIn(report, ".htm"))
        throw Error({report}, "expected a name that ends in .html or .htm");
    for (const char* const workbook : {".xlsx", ".xls", ".ods"})
        if (endsIn(csv, workbook))
            throw Error({csv}, "what is written is CSV, not a workbook: name it " +
                                   csv.substr(0, csv.rfind('.')) + ".csv");
    try {
        requireUser(options.user);
    } catch (const Error& error) {
        throw UsageError("--user: " + std::string(error.what()));
    }
}

}  // namespace raytracer::commands
