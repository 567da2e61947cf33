#include "raytracer/util/file_reader.h"

#include <sys/stat.h>

#include <cerrno>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

struct FileReader::State {
    std::string path;
    Descriptor file;
    std::uint64_t size = 0;
};

FileReader::FileReader(const std::string& path) : state_(std::make_unique<State>()) {
    state_->path = path;
    state_->file = openToRead(path, false);
    struct stat status {};
    if (!state_->file || ::fstat(state_->file.get(), &status) != 0)
        throw systemError(path, "cannot read", whereLooked(path));
    if (!S_ISREG(status.st_mode)) throw Error({path}, "cannot read: it is no regular file");
    state_->size = static_cast<std::uint64_t>(status.st_size);
}

FileReader::~FileReader() = default;

std::uint64_t FileReader::size() const { return state_->size; }

void FileReader::read(std::uint64_t offset, std::span<char> bytes) const {
    while (!bytes.empty()) {
        const std::int64_t count = readAt(state_->file.get(), bytes, offset);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw systemError(state_->path, "cannot read");
        if (count == 0) throw Error({state_->path}, "cannot read: it has become shorter");
        offset += static_cast<std::uint64_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

}  // namespace raytracer
