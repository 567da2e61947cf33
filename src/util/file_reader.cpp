#include "raytracer/util/file_reader.h"

#include <sys/stat.h>

#include <cerrno>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

FileReader::FileReader(const std::string& path)
    : path_(path), file_(std::make_unique<Descriptor>(openToRead(path, false))) {
    struct stat status {};
    if (!*file_ || ::fstat(file_->get(), &status) != 0)
        throw systemError(path, "cannot read", whereLooked(path));
    if (!S_ISREG(status.st_mode)) throw Error({path}, "cannot read: it is no regular file");
    size_ = static_cast<std::uint64_t>(status.st_size);
}

FileReader::~FileReader() = default;

void FileReader::read(std::uint64_t offset, std::span<char> bytes) const {
    while (!bytes.empty()) {
        const std::int64_t count = readAt(file_->get(), bytes, offset);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw systemError(path_, "cannot read");
        if (count == 0) throw Error({path_}, "cannot read: it has become shorter");
        offset += static_cast<std::uint64_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

}  // namespace raytracer
