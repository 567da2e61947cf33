#include "programs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_watch.h"
#include "raytracer/util/folder_walk.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

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

// Calls take(path, type, depth) for what a program has left in its folder, as far as that can be read. In the
// folder's place may be a link, which leads to other files.
template <class Take>
void walkThroughRemains(const std::string& folder, Take take) try {
    std::error_code error;
    if (files::symlink_status(folder, error).type() == files::file_type::directory) walkBeneath(folder, take);
} catch (const Error&) {
    return;
}

// What a folder's files take from the disk.
DiskRoom takenIn(const std::string& folder) {
    DiskRoom taken{0, 0};
    walkThroughRemains(folder, [&](const files::path& path, files::file_type type, int) {
        std::error_code isGone;
        const std::uintmax_t size = type == files::file_type::regular ? files::file_size(path, isGone) : 0;
        taken.bytes += isGone ? 0 : size;
        ++taken.files;
    });
    return taken;
}

// "output.png is there": a picture that the program has written, but not where it should. The one nearest to
// the top, and of these the first by its path. Empty if there is none.
std::string pictureElsewhere(const std::string& folder, const std::string& asked, const SceneCopy& scene) {
    std::pair<int, std::string> first{std::numeric_limits<int>::max(), ""};
    walkThroughRemains(folder, [&](const files::path& path, files::file_type type, int depth) {
        const bool isWritten =
            type == files::file_type::regular && path != asked && !scene.files.contains(path.string());
        if (isWritten && isPicture(path.string()))
            first = std::min(first, {depth, path.lexically_relative(folder).string()});
    });
    return first.second.empty() ? "" : first.second + " is there";
}

// The bytes of room that a program is promised: for its picture, for a copy of that, and for what it prints.
std::size_t promisedRoom(const ProgramRun& run) {
    constexpr std::size_t printed = std::size_t{1} << 20;
    const auto size = sizeInHeader(FileBytes(run.test->reference, FileKind::Regular)).value_or(ImageSize{});
    return printed + 6 * size.area();
}

// Whether others have taken most of the room that there was before a run, whose own files take `own`.
bool isTakenByOthers(const DiskRoom& before, const DiskRoom& own = {0, 0}) {
    const DiskRoom now = temporaryRoom();
    const auto isTaken = [](std::uint64_t was, std::uint64_t taken, std::uint64_t is) {
        return taken < was / 2 && is < was / 2 - taken;
    };
    return isTaken(before.bytes, own.bytes, now.bytes) || isTaken(before.files, own.files, now.files);
}

// A run in progress. The program's folder is inside one of this run's own: ".." has no files of other runs.
struct ActiveRun {
    explicit ActiveRun(const ProgramRun& run) : promised(promisedRoom(run)) {}

    // Whether the disk may keep the program from writing its picture.
    bool lacksRoomNow() const {
        const DiskRoom room = temporaryRoom();
        return room.bytes < promised || (roomBefore.files > 0 && room.files == 0);
    }

    // Looks at the disk: others may empty it again before the program ends.
    void look() {
        if (lacksRoom || !lacksRoomNow()) return;
        lacksRoom = true;
        isSqueezed = isTakenByOthers(roomBefore, takenIn(folder));
    }

    std::size_t promised;
    DiskRoom roomBefore = temporaryRoom();
    bool lacksRoom = false;    // for the picture, or for its copy
    bool isSqueezed = false;   // by others, when that was seen
    bool isDisturbed = false;  // another run has filled the disk meanwhile
    TemporaryFolder own;
    std::string folder = own.hiddenFolder(), picture = folder + "/out.png", printed = own.file("log");
    SceneCopy scene;  // in the folder
};

// Throws Error if there is too little room for the program's
// files, so that the program is not blamed for that.
ProcessStart startOf(const ProgramRun& run, ActiveRun& active, const ProgramOptions& options) {
    active.scene = copyScene(absolutePath(run.test->scene), active.folder);
    active.own.requireRoom(active.promised);
    giveFolderTo(options.user, active.folder);
    return {commandFromHere(run.command),
            {active.scene.path, active.picture, std::to_string(run.longEdge)},
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

// Throws Error if one of the files that grading reads has changed: the later scores would be of that.
void requireInputs(const FileWatch& inputs, const ProgramRun& run, bool wasAlone) {
    const std::string changed = inputs.changedFile();
    if (changed.empty()) return;
    throw Error({changed}, "it has changed while " + run.command + (wasAlone ? "" : ", or one beside it,") +
                               " ran; as root, --user NAME prevents that");
}

// Copies a program's picture. False if it is not a regular file, if
// the program has made it unreadable, or if there is no room for it.
bool keepPicture(ActiveRun& active, const std::string& place) {
    std::error_code error;
    if (files::symlink_status(active.picture, error).type() != files::file_type::regular) return false;
    files::copy_file(active.picture, place, error);
    active.lacksRoom = active.lacksRoom || error == std::errc::no_space_on_device;
    if (error && error != std::errc::permission_denied && error != std::errc::no_space_on_device)
        throw Error({place}, "cannot keep the picture of a program: " + error.message());
    return !error;
}

Rendered renderedBy(const ProgramRun& run, ActiveRun& active, const ProcessEnd& end) {
    // An exit status other than 0 is no failure if there is a picture: the course grades the picture.
    Rendered rendered{end.stop != ProcessEnd::Stop::None || end.signal != 0, end.description(),
                      endOfFile(active.printed)};
    rendered.seconds = end.seconds;
    rendered.processorSeconds = end.processorSeconds;
    removeShellsReport(rendered.output, end);
    if (rendered.failed) return rendered;
    if (keepPicture(active, run.picture)) return rendered;
    std::error_code error;
    const bool isGone = files::symlink_status(active.folder, error).type() == files::file_type::not_found;
    const bool isLink = files::symlink_status(active.picture, error).type() == files::file_type::symlink;
    rendered.message += std::string(rendered.message.empty() ? "" : ", ") +
                        (isGone ? "its folder was deleted, " : "") +
                        (isLink ? "out.png is a symbolic link, not a file" : "wrote no picture");
    if (!isLink) rendered.instead = pictureElsewhere(active.folder, active.picture, active.scene);
    rendered.message += rendered.butInstead();
    rendered.failed = true;
    return rendered;
}

bool isReadable(const ProgramRun& run) {
    GradeResult result;
    gradePicture(result, ReferencePicture(run.test->reference), run.picture, nullptr);
    return !result.isUnreadable;
}

// Whether the disk may be why there is no picture that can be read.
bool hasDiskFailed(const ProgramRun& run, const ActiveRun& active, const Rendered& rendered) {
    const bool isSuspect = active.lacksRoom || active.isDisturbed || active.lacksRoomNow();
    return isSuspect && (rendered.failed || !isReadable(run));
}

// Runs programs. One for which others leave no room on the disk runs again later, alone.
class ProgramRuns {
  public:
    using Ended = std::function<void(std::size_t, const Rendered&)>;

    ProgramRuns(const std::vector<ProgramRun>& runs, const ProgramOptions& options, const Ended& ended)
        : runs_(runs), options_(options), ended_(ended) {}

    void run(std::vector<std::size_t> which, int atOnce) {
        isAlone_ = atOnce == 1;
        runProcesses(
            which.size(), atOnce, [&](std::size_t i) { return start(which[i]); },
            [&](std::size_t i, const ProcessEnd& end) { take(which[i], end); },
            [&] {
                for (const auto& [number, active] : active_) active->look();
            });
        if (!again_.empty()) run(std::exchange(again_, {}), 1);
    }

  private:
    ProcessStart start(std::size_t i) try {
        active_[i] = std::make_unique<ActiveRun>(runs_[i]);
        return startOf(runs_[i], *active_[i], options_);
    } catch (const Error&) {
        active_.erase(i);
        if (active_.empty()) throw;
        again_.push_back(i);
        return {":", {}, "/dev/null"};
    }

    void take(std::size_t i, const ProcessEnd& end) {
        const auto found = active_.find(i);
        if (found == active_.end()) return;  // it was not started
        std::unique_ptr<ActiveRun> run = std::move(found->second);
        active_.erase(found);
        requireKept(kept_, runs_[i]);
        requireInputs(options_.inputs, runs_[i], active_.empty());
        Rendered rendered = renderedBy(runs_[i], *run, end);
        if (hasDiskFailed(runs_[i], *run, rendered)) {
            const DiskRoom before = run->roomBefore;
            const bool isDisturbed = run->isDisturbed || (run->isSqueezed && !run->lacksRoomNow());
            const std::string folder = files::path(run->printed).parent_path().string();
            std::error_code error;
            files::remove(runs_[i].picture, error);
            run.reset();
            if (isDisturbed || isTakenByOthers(before)) return runAgain(i, folder);
            for (const auto& [number, other] : active_) other->isDisturbed = true;
            rendered.failed = true;
            rendered.message = joined({end.description(), "filled the disk"}, ", ");
        }
        if (!rendered.failed) kept_.add(runs_[i].picture);
        ended_(i, rendered);
    }

    void runAgain(std::size_t i, const std::string& folder) {
        if (isAlone_)
            throw Error({folder},
                        "no room for a picture: the disk has been filled meanwhile, by others or by " +
                            runs_[i].command);
        again_.push_back(i);
    }

    const std::vector<ProgramRun>& runs_;
    const ProgramOptions& options_;
    const Ended& ended_;
    std::map<std::size_t, std::unique_ptr<ActiveRun>> active_;
    std::vector<std::size_t> again_;
    FileWatch kept_;
    bool isAlone_ = false;
};

}  // namespace

void runPrograms(const std::vector<ProgramRun>& runs, const ProgramOptions& options, int atOnce,
                 const std::function<void(std::size_t, const Rendered&)>& ended) {
    std::vector<std::size_t> all(runs.size());
    std::iota(all.begin(), all.end(), 0);
    ProgramRuns(runs, options, ended).run(std::move(all), atOnce);
}

CaseRenderer programRenderer(const std::string& command, const ProgramOptions& options) {
    return [=](const GradeCase& test, int longEdge, const std::string& out) {
        Rendered result;
        runPrograms({{command, &test, longEdge, out}}, options, 1,
                    [&](std::size_t, const Rendered& rendered) { result = rendered; });
        return result;
    };
}

}  // namespace raytracer
