#include "programs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_watch.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/temporary_folder.h"

namespace raytracer {

namespace {

namespace files = std::filesystem;

// The end of a program's output, where errors usually are.
std::string endOfFile(const std::string& path) {
    constexpr std::streamoff most = 2000;  // bytes: some 20 lines
    std::error_code error;
    if (files::symlink_status(path, error).type() != files::file_type::regular) return {};
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : 0;
    const std::streamoff start = std::max<std::streamoff>(0, size - most);
    std::string text(static_cast<std::size_t>(size - start), '\0');
    file.seekg(start);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    return start > 0 ? "... " + text : text;
}

// Removes the shell's report of the signal that killed the program: the message has that already.
void removeShellsReport(std::string& output, const ProcessEnd& end) {
    const std::size_t last = output.find_last_of('\n', output.empty() ? 0 : output.size() - 2);
    const std::size_t start = last == std::string::npos ? 0 : last + 1;
    if (end.signal && output.find(signalName(end.signal), start) != std::string::npos) output.erase(start);
}

// How many folders a relative path leads upwards: 1 for "../a", 2 for "a/../../../b".
int stepsUp(const files::path& relative) {
    int up = 0;
    for (const files::path& part : relative.lexically_normal()) up += part == "..";
    return up;
}

// Copies the scene and the files that it names, so that its relative paths lead to the copies. A file that it
// names by an absolute path is found where it is. Returns the copy of the scene.
std::string copyScene(const std::string& scene, const std::string& folder) {
    const std::vector<std::string> named = loadScene(scene).files;
    const files::path from = files::path(scene).parent_path();
    int up = 0;
    for (const std::string& file : named)
        up = std::max(up, stepsUp(files::path(file).lexically_relative(from)));
    files::path to = folder;
    for (int i = 0; i < up; ++i) to /= "scene";
    for (const std::string& file : named) {
        const files::path copy = (to / files::path(file).lexically_relative(from)).lexically_normal();
        std::error_code error;
        files::create_directories(copy.parent_path(), error);
        files::copy_file(file, copy, files::copy_options::overwrite_existing, error);
        if (error) throw Error({file}, "cannot be copied for a program: " + error.message());
    }
    return (to / files::path(scene).filename()).string();
}

// A run in progress. The program's folder is inside one of this run's own: ".." has no files of other runs.
struct ActiveRun {
    TemporaryFolder own;
    std::string folder = own.hiddenFolder(), picture = folder + "/out.png", printed = own.file("log");
};

ProcessStart startOf(const ProgramRun& run, const ActiveRun& active, const ProgramOptions& options) {
    const std::string scene = copyScene(absolutePath(run.test->scene), active.folder);
    giveFolderTo(options.user, active.folder);
    return {commandFromHere(run.command),
            {scene, active.picture, std::to_string(run.longEdge)},
            active.printed,
            options.limits,
            active.folder,
            options.user};
}

// Throws Error if a program has changed a kept picture. One that runs as our user can reach these pictures,
// and must not get a score that way.
void requireKept(const FileWatch& kept, const ProgramRun& run) {
    const std::string folder = files::path(run.picture).parent_path().string();
    std::error_code error;
    if (files::exists(folder, error) && !kept.hasChanged()) return;
    throw Error({folder}, "a program has changed what is kept there: " + run.command +
                              ", or one beside it; as root, --user NAME prevents that");
}

// Copies a program's picture. False if it is not a regular file, or if the program has made it unreadable.
bool keepPicture(const std::string& picture, const std::string& place) {
    std::error_code error;
    if (files::symlink_status(picture, error).type() != files::file_type::regular) return false;
    files::copy_file(picture, place, error);
    if (error && error != std::errc::permission_denied)
        throw Error({place}, "cannot keep the picture of a program: " + error.message());
    return !error;
}

Rendered renderedBy(const ProgramRun& run, const ActiveRun& active, const ProcessEnd& end) {
    // An exit status other than 0 is no failure if there is a picture: the course grades the picture.
    Rendered rendered{end.stop != ProcessEnd::Stop::None || end.signal != 0, end.description(),
                      endOfFile(active.printed)};
    rendered.seconds = end.seconds;
    rendered.processorSeconds = end.processorSeconds;
    removeShellsReport(rendered.output, end);
    if (rendered.failed) return rendered;
    if (keepPicture(active.picture, run.picture)) return rendered;
    std::error_code error;
    const bool isGone = files::symlink_status(active.folder, error).type() == files::file_type::not_found;
    rendered.message += std::string(rendered.message.empty() ? "" : ", ") +
                        (isGone ? "its folder was deleted, " : "") + "wrote no picture";
    rendered.failed = true;
    return rendered;
}

}  // namespace

void runPrograms(const std::vector<ProgramRun>& runs, const ProgramOptions& options, int atOnce,
                 const std::function<void(std::size_t, const Rendered&)>& ended) {
    std::map<std::size_t, std::unique_ptr<ActiveRun>> active;
    FileWatch kept;
    runProcesses(
        runs.size(), atOnce,
        [&](std::size_t i) {
            active[i] = std::make_unique<ActiveRun>();
            return startOf(runs[i], *active[i], options);
        },
        [&](std::size_t i, const ProcessEnd& end) {
            requireKept(kept, runs[i]);
            const Rendered rendered = renderedBy(runs[i], *active[i], end);
            if (!rendered.failed) kept.add(runs[i].picture);
            ended(i, rendered);
            active.erase(i);
        });
}

}  // namespace raytracer
