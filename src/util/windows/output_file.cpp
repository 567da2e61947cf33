// Like src/util/posix/output_file.cpp, but without owners, modes and links: on Windows a new file gets its
// rights from its folder.
#include "raytracer/util/output_file.h"

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <filesystem>
#include <optional>
#include <random>

#include "../leftover.h"
#include "open_file.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace fs = std::filesystem;

struct OutputFile::State {
    std::string name;
    const char* purpose = "cannot write";
    std::string temporary;  // the file beside it; empty if a device is written in place
    Descriptor file;
    std::optional<Leftover> leftover{};

    ~State() {
        if (leftover) leftover->clear();
    }
    void require(bool done) const {
        if (!done) throw systemError(name, purpose, missingFolder(name));
    }
    void open();
    void openBeside();
    void finish();
};

void OutputFile::State::open() {
    Descriptor old = openFile(name, _O_WRONLY);
    require(old || errno == ENOENT);
    struct stat status {};
    if (!old || ::fstat(old.get(), &status) != 0 || S_ISREG(status.st_mode)) openBeside();
    else file = std::move(old);
}

// Opens the file such that it can be deleted and renamed while it is open.
void OutputFile::State::openBeside() {
    std::random_device random;
    const std::string beside = formatted(".raytracer-%08x%08x.tmp", random(), random());
    temporary = (fs::path(name).parent_path() / beside).string();
    HANDLE const handle = CreateFileA(temporary.c_str(), GENERIC_WRITE | DELETE,
                                      FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr, CREATE_NEW, 0, nullptr);
    if (handle == INVALID_HANDLE_VALUE) errno = GetLastError() == ERROR_PATH_NOT_FOUND ? ENOENT : EACCES;
    require(handle != INVALID_HANDLE_VALUE);
    file = Descriptor(_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY));
    leftover.emplace(removeFile, temporary.c_str());
}

void OutputFile::State::finish() {
    require(file.close());
    if (temporary.empty()) return;
    std::error_code error;
    fs::rename(temporary, name, error);
    if (error) throw Error({name}, std::string(purpose) + ": " + error.message());
    leftover.reset();
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
    state->file = Descriptor(::dup(STDOUT_FILENO));
    state->require(static_cast<bool>(state->file));
    return OutputFile(std::move(state));
}

OutputFile::~OutputFile() = default;

const std::string& OutputFile::name() const { return state_->name; }

void OutputFile::append(std::span<const char> bytes) { state_->require(writeAll(state_->file.get(), bytes)); }
void OutputFile::finish() { state_->finish(); }

}  // namespace raytracer
