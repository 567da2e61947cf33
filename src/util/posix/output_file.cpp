#include "raytracer/util/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <utility>

#include "../access_list.h"
#include "../descriptor.h"
#include "../leftover.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/text.h"
#include "signals.h"

namespace raytracer {
namespace {

namespace fs = std::filesystem;
using Status = struct stat;

// The folder of a name that lies in /proc; else empty. A link in /proc leads to an open file: no rename can
// replace that file, and no file can be made beside the link.
std::string folderInProc(const fs::path& name) {
    std::error_code error;
    std::string folder = fs::canonical(name.has_parent_path() ? name.parent_path() : ".", error).string();
    return folder.starts_with("/proc/") ? folder : "";
}

// Follows symbolic links to a path that is none, and that need not exist. Stops at a link in /proc to an open
// file, which a rename cannot replace. Empty if there are too many links.
fs::path behindLinks(fs::path path) {
    constexpr int mostLinks = 40;  // Linux's limit
    for (int links = 0; links < mostLinks; ++links) {
        std::error_code isNoLink;
        const fs::path next = fs::read_symlink(path, isNoLink);
        if (isNoLink) return path;
        if (!folderInProc(path).empty()) return path;
        path = path.parent_path() / next;
    }
    return {};
}

// Whether the link in /proc is that of a closed standard stream of this process. prepareStandardStreams has
// opened /dev/null in its place, so what is written there would be lost.
bool isClosedStream(const fs::path& link) {
    const std::string folder = folderInProc(link), ours = "/proc/" + std::to_string(::getpid()) + "/";
    if (!folder.starts_with(ours) || !folder.ends_with("/fd")) return false;
    Status null{}, open{};
    return std::ranges::any_of(std::array{STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}, [&](int stream) {
        const int mode = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        return link.filename() == std::to_string(stream) && (::fcntl(stream, F_GETFL) & O_ACCMODE) == mode &&
               ::fstat(stream, &open) == 0 && ::stat("/dev/null", &null) == 0 && S_ISCHR(open.st_mode) &&
               open.st_rdev == null.st_rdev;
    });
}

// The temporary file's name. It is random, not the process's number, which a process in another container may
// have too. It does not contain the target's name, which may be as long as the system allows.
std::string randomName() {
    std::random_device random;
    return formatted(".raytracer-%08x%08x.tmp", random(), random());
}

// Gives the new file the owner, the access list and the mode of the old one. False if that is not permitted.
bool takeOver(int made, int oldFile, const Status& old) {
    Status status{};
    if (::fstat(made, &status) != 0) return false;
    const bool sameOwner = status.st_uid == old.st_uid && status.st_gid == old.st_gid;
    if (!sameOwner && ::fchown(made, old.st_uid, old.st_gid) != 0) return false;
    return copyAccessList(oldFile, made) && ::fchmod(made, old.st_mode & 07777) == 0;
}

}  // namespace

struct OutputFile::State {
    std::string name;
    const char* purpose = "cannot write";
    std::string target, temporary;  // paths of the result and the temporary file; empty if written in place
    Descriptor beside, inPlace;     // the temporary file; the old file, if any, as the fallback
    bool isCut = false;             // whether inPlace has to lose its old content first
    std::optional<Leftover> leftover{};  // the temporary file

    ~State() { discardBeside(); }

    void require(bool done) const {
        if (!done) throw systemError(name, purpose, missingFolder(target));
    }
    void open();
    void openBeside(mode_t mode);
    void discardBeside();
    bool replaceTarget();
    void append(std::span<const char> bytes);
    void finish();
};

void OutputFile::State::open() {
    const fs::path behind = behindLinks(name);
    const bool isClosed = isClosedStream(behind), isInProc = !folderInProc(behind).empty();
    if (isClosed) errno = EBADF;
    require(!isClosed);
    Status old{};
    const bool exists = ::stat(name.c_str(), &old) == 0;
    require(exists || (errno == ENOENT && !isInProc));
    if (exists) inPlace = Descriptor(::open(name.c_str(), O_WRONLY | O_CLOEXEC));
    require(!exists || inPlace);
    isCut = exists && S_ISREG(old.st_mode);
    if ((exists && !isCut) || behind.empty() || isInProc) return;
    target = behind.string();
    openBeside(exists ? S_IRUSR | S_IWUSR : 0666);
    require(beside || exists);
    if (beside && exists && !takeOver(beside.get(), inPlace.get(), old)) discardBeside();
}

void OutputFile::State::openBeside(mode_t mode) {
    const SignalsWait wait;
    temporary = (fs::path(target).parent_path() / randomName()).string();
    beside = Descriptor(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (beside) leftover.emplace(removeFile, temporary.c_str());
}

void OutputFile::State::discardBeside() {
    if (leftover) leftover->clear();
    leftover.reset();
    beside = {};
}

void OutputFile::State::append(std::span<const char> bytes) {
    if (!beside && std::exchange(isCut, false)) require(::ftruncate(inPlace.get(), 0) == 0);
    require(writeAll(beside ? beside.get() : inPlace.get(), bytes));
}

bool OutputFile::State::replaceTarget() {
    require(beside.close());
    const bool renamed = std::rename(temporary.c_str(), target.c_str()) == 0;
    require(renamed || inPlace);
    if (renamed) leftover.reset();
    return renamed;
}

void OutputFile::State::finish() {
    if (beside) {
        if (replaceTarget()) return;
        const FileBytes written(temporary);
        discardBeside();
        append(written.text());
    }
    require(inPlace.close());
}

OutputFile::OutputFile(std::unique_ptr<State> state) : state_(std::move(state)) {}

OutputFile::OutputFile(const std::string& path) : state_(std::make_unique<State>()) {
    state_->name = path;
    state_->open();
}

OutputFile OutputFile::standardOutput() {
    auto state = std::make_unique<State>();
    state->name = "standard output";
    state->purpose = "";
    state->inPlace = Descriptor(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0));
    const bool isClosed = (::fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) == O_RDONLY;
    if (isClosed) errno = EBADF;  // prepareStandardStreams
    state->require(!isClosed && state->inPlace);
    return OutputFile(std::move(state));
}

OutputFile::~OutputFile() = default;

const std::string& OutputFile::name() const { return state_->name; }

void OutputFile::append(std::span<const char> bytes) { state_->append(bytes); }
void OutputFile::finish() { state_->finish(); }

}  // namespace raytracer
