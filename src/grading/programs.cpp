#include "programs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <span>

#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_watch.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/shell_words.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

namespace files = std::filesystem;

// The end of what a program printed, where errors are.
std::string endOfFile(const std::string& path) {
    constexpr std::streamoff most = 2000;  // characters: some 20 lines
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

// The shell, too, reports a signal that killed the program. The message has that already.
void removeShellsReport(std::string& output, const ProcessEnd& end) {
    const std::size_t last = output.find_last_of('\n', output.empty() ? 0 : output.size() - 2);
    const std::size_t start = last == std::string::npos ? 0 : last + 1;
    if (end.signal && output.find(signalName(end.signal), start) != std::string::npos) output.erase(start);
}

// How many folders above its own a path leads: 1 for "../a", 2 for "a/../../../b".
int stepsUp(const files::path& relative) {
    int up = 0;
    for (const files::path& part : relative.lexically_normal()) up += part == "..";
    return up;
}

// The scene with the files that it names, copied so that the relative paths lead to them. A file that is
// named absolutely is found where it is.
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

// Follows a command, in which a path of ours is found, though it runs in another folder. A word that means
// a file which the command itself makes is left as it is.
class PathsFromHere {
  public:
    bool isOurs(const ShellWord& word) {
        if (word.role == ShellRole::Operator) endCommand(word.text == "(");
        if (word.role == ShellRole::Target) makes_ = makes_ || !word.text.starts_with("/dev/");
        if (word.role == ShellRole::Command) {
            makes_ = makes_ || std::ranges::find(harmless, word.text) == harmless.end();
            moves_ = word.text == "cd" || word.text == "pushd";
        }
        const bool hasSlash = word.text.find('/') != word.text.npos;
        const bool isStarted = word.role == ShellRole::Command || word.role == ShellRole::Wrapped;
        startsFile_ = startsFile_ || (isStarted && hasSlash) || word.role == ShellRole::Script;
        std::error_code error;
        return isHere_ && word.isPlain && !word.text.starts_with('/') && mayBeOurs(word) &&
               files::exists(word.text, error);
    }

  private:
    // Commands, and words of the shell, that make no file.
    static constexpr std::array<std::string_view, 17> harmless{
        "export", "ulimit", "umask", "set",    "unset", "trap", ":",  "true", "false",
        "test",   "[",      "echo",  "printf", "for",   "done", "fi", "}"};

    // The name of a function, before (), is not run.
    void endCommand(bool isName) {
        isFresh_ = isFresh_ && (isName || !makes_);
        isHere_ = isHere_ && !moves_;
        makes_ = moves_ = startsFile_ = false;
    }

    bool mayBeOurs(const ShellWord& word) const {
        const bool hasFolder = word.text.find('/') != word.text.npos, isDot = word.text.starts_with("./");
        if (word.role == ShellRole::Script && !hasFolder) return isFresh_;
        if (!hasFolder || word.text.find_first_not_of("./") == word.text.npos) return false;
        const bool isRun = word.role != ShellRole::Target && startsFile_;
        return !isDot || (isFresh_ && isRun);
    }

    bool isHere_ = true, isFresh_ = true;  // no command before has left our folder, or may have made files
    bool makes_ = false, moves_ = false, startsFile_ = false;  // this command
};

std::string commandFromHere(const std::string& command) {
    PathsFromHere paths;
    std::string text;
    std::size_t done = 0;
    for (const ShellWord& word : shellWords(command)) {
        if (!paths.isOurs(word)) continue;
        text += command.substr(done, word.begin - done) + inShellQuotes(absolutePath(word.text));
        done = word.end;
    }
    return text + command.substr(done);
}

// A run in progress. The program's folder is in one of this run's own, so that .. holds nothing of others.
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

// A program of our user can reach the pictures that are kept, and no score may come of that.
void requireKept(const FileWatch& kept, const ProgramRun& run) {
    const std::string folder = files::path(run.picture).parent_path().string();
    std::error_code error;
    if (files::exists(folder, error) && !kept.hasChanged()) return;
    throw Error({folder}, "a program has changed what is kept there: " + run.command +
                              ", or one beside it; as root, --user NAME prevents that");
}

// False where there is no regular file, or one that the program has locked.
bool keepPicture(const std::string& picture, const std::string& place) {
    std::error_code error;
    if (files::symlink_status(picture, error).type() != files::file_type::regular) return false;
    files::copy_file(picture, place, error);
    if (error && error != std::errc::permission_denied)
        throw Error({place}, "cannot keep the picture of a program: " + error.message());
    return !error;
}

Rendered renderedBy(const ProgramRun& run, const ActiveRun& active, const ProcessEnd& end) {
    // With a picture, an exit status other than 0 is no failure: the course grades the picture.
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

// Whether "{}" stands in the word for a submission's folder.
bool hasFolder(const std::string& word) { return word.find("{}") != word.npos; }

std::string noFile(const std::string& name) { return "there is no file " + printable(name) + hintAt(name); }

// The shell that will run it is asked: it knows its own commands, and where it looks for others.
bool isCommand(const std::string& name) { return runProcess({"command -v", {name}, "/dev/null"}).well(); }

// Whether a word that an interpreter is given is its script for certain.
bool isScript(const std::string& word) {
    constexpr std::string_view endings[] = {".py", ".sh", ".js", ".rb", ".pl", ".lua", ".jar", ".java"};
    return word.find('/') != word.npos ||
           std::ranges::any_of(endings, [&](std::string_view ending) { return endsIn(word, ending); });
}

std::string faultOfProgram(const std::string& word) {
    std::error_code error;
    const files::file_status status = files::status(word, error);
    constexpr files::perms any =
        files::perms::owner_exec | files::perms::group_exec | files::perms::others_exec;
    const bool isThere = files::is_regular_file(status);
    if (hasFolder(word)) return {};
    if (word.find('/') == word.npos) {
        const std::string hint = isThere ? "; write ./" + printable(word) : hintAt(word);
        return isCommand(word) ? "" : "there is no command " + printable(word) + hint;
    }
    if (status.type() == files::file_type::not_found) return noFile(word);
    if (files::is_directory(status)) return printable(word) + " is a folder: name a program in it";
    const bool isProgram = (status.permissions() & any) != files::perms::none;
    return isProgram ? "" : printable(word) + " is not executable: chmod +x makes it so";
}

}  // namespace

std::vector<std::string> filesStarted(const std::string& command) {
    const std::vector<ShellWord> words = shellWords(command);
    const auto end = std::ranges::find(words, ShellRole::Operator, &ShellWord::role);
    const bool isFunction = end != words.end() && end->text == "(";
    const bool hasOther = end != words.end() && end->text == "||";
    if (words.empty() || isFunction || hasOther) return {};
    const ShellWord& first = words[0];
    if (first.role != ShellRole::Command || !first.isPlain || first.isQuoted) return {};
    std::vector<std::string> started{first.text};
    for (const ShellWord& word : std::span(words.begin(), end)) {
        if (word.role == ShellRole::Wrapped) break;
        if (word.role != ShellRole::Script || !word.isPlain || !isScript(word.text)) continue;
        started.push_back(word.text);
        break;
    }
    return started;
}

std::string programFault(const std::string& command) {
    const std::vector<std::string> started = filesStarted(command);
    if (started.empty()) return {};
    if (std::string fault = faultOfProgram(started[0]); !fault.empty() || started.size() < 2) return fault;
    const std::string& script = started[1];
    std::error_code error;
    if (hasFolder(script) || files::exists(script, error)) return {};
    const bool isName = script.find('/') == script.npos;
    return isName && isCommand(script) ? "" : noFile(script);
}

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
