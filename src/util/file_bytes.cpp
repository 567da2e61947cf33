#include "raytracer/util/file_bytes.h"

#include <sys/stat.h>
#include <unistd.h>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {
namespace {

// False, with errno, where it cannot be read. The file may have no end: throws Error before memory has.
bool readToEnd(int descriptor, std::string& bytes, const std::string& path) {
    char block[1 << 16];  // a pipe's capacity on Linux
    for (;;) {
        const auto count = ::read(descriptor, block, sizeof block);
        if (count == 0) return true;
        if (bytes.size() + sizeof block > bytes.capacity())
            requireMemory(path, {{"what is in it", 2 * static_cast<double>(bytes.capacity())}});
        if (count > 0) bytes.append(block, static_cast<std::size_t>(count));
        else if (errno != EINTR) return false;
    }
}

}  // namespace

FileBytes::FileBytes(const std::string& path, FileKind kind) : path_(path) {
    const auto require = [&](bool done) {
        if (!done) throw systemError(path, "cannot read", errno == ENOENT ? hintAt(path) : "");
    };
    const Descriptor file = openToRead(path, kind != FileKind::Regular);
    require(static_cast<bool>(file));
    struct stat status {};
    require(::fstat(file.get(), &status) == 0);
    const bool isRegular = S_ISREG(status.st_mode);
    if (kind == FileKind::Regular && !isRegular && !S_ISDIR(status.st_mode))
        fail("cannot read: it is no regular file");
    size_ = static_cast<std::size_t>(status.st_size);
    // Files of /proc say that their size is 0. They are read as a pipe is.
    if (isRegular && size_ > 0) {
        begin_ = mapFile(file.get(), size_);
        mapped_ = begin_ != nullptr;
    }
    if (mapped_) return;
    require(readToEnd(file.get(), copy_, path));
    begin_ = copy_.data();
    size_ = copy_.size();
}

FileBytes::~FileBytes() {
    if (mapped_) unmapFile(begin_, size_);
}

void FileBytes::fail(const std::string& message) const { throw Error({path_}, message); }

}  // namespace raytracer
