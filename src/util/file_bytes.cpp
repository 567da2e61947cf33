#include "raytracer/util/file_bytes.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

namespace {

constexpr std::size_t pipeSize = 1 << 16;   // of a pipe's buffer on Linux, bytes
constexpr std::size_t mostRead = 1U << 30;  // bytes in one call
// A pipe may have no end. Scenes and pictures of usual size stay far below this limit, and what has no end
// reaches it within seconds.
constexpr std::size_t mostWithoutSize = 1U << 30;

}  // namespace

FileBytes::FileBytes(const std::string& path, FileKind kind) : path_(path) {
    const auto require = [&](bool done) {
        if (!done)
            throw systemError(path, "cannot read",
                              errno == EISDIR ? "; name a file in it" : whereLooked(path));
    };
    const Descriptor file = openToRead(path, kind != FileKind::Regular);
    require(static_cast<bool>(file));
    struct stat status {};
    require(::fstat(file.get(), &status) == 0);
    const bool isRegular = S_ISREG(status.st_mode);
    if (kind == FileKind::Regular && !isRegular && !S_ISDIR(status.st_mode))
        fail("cannot read: it is no regular file");
    if (S_ISCHR(status.st_mode) && ::isatty(file.get()) == 0)
        fail("cannot read: it is a device");  // some devices have no end
    // One byte more than the size: a read that returns nothing is then the end. Files in /proc have size 0.
    resize(isRegular && status.st_size > 0 ? static_cast<std::size_t>(status.st_size) + 1 : pipeSize);
    for (;;) {
        if (size_ == bytes_.size() && kind == FileKind::Regular && status.st_size == 0)
            fail("cannot read: it has no size, as files in /proc, and may have no end");
        if (size_ >= mostWithoutSize && (!isRegular || status.st_size == 0))
            fail("cannot read: it has no size, as a pipe, and no end within 1 GiB: save it as a file");
        if (size_ == bytes_.size()) resize(2 * size_);
        const auto count =
            ::read(file.get(), bytes_.data() + size_, std::min(bytes_.size() - size_, mostRead));
        if (count == 0) return;
        if (count > 0) size_ += static_cast<std::size_t>(count);
        else require(errno == EINTR);
    }
}

// Checks the memory each time, since the file may have no end.
void FileBytes::resize(std::size_t size) {
    requireMemory(path_, "what is in it", static_cast<double>(size));
    bytes_.resize(size);
}

void FileBytes::fail(const std::string& message) const { throw Error({path_}, message); }

}  // namespace raytracer
