#include "raytracer/util/temporary_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "../descriptor.h"
#include "../leftover.h"
#include "../posix/signals.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

namespace {

std::string parentFolder() {
    const char* const wanted = ::getenv("TMPDIR");
    return wanted && *wanted ? wanted : "/tmp";
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    const std::string parent = parentFolder();
    path_ = absolutePath(parent) + "/raytracer-XXXXXX";  // mkdtemp's placeholder
    const SignalsWait wait;
    if (!::mkdtemp(path_.data())) throw systemError(parent, "cannot make a temporary folder");
    leftover_ = std::make_unique<Leftover>(removeFolder, path_.c_str());
}

std::string TemporaryFolder::hiddenFolder() const {
    std::string path = file("XXXXXX");  // mkdtemp's placeholder
    constexpr mode_t enteredByAll = S_IRWXU | S_IXGRP | S_IXOTH;
    if (::chmod(path_.c_str(), enteredByAll) != 0 || !::mkdtemp(path.data()))
        throw systemError(path_, "cannot make a temporary folder");
    return path;
}

void TemporaryFolder::requireRoom(std::size_t bytes) const {
    const std::string probe = file("room");
    const Descriptor descriptor(::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    if (descriptor) errno = ::posix_fallocate(descriptor.get(), 0, static_cast<off_t>(bytes));
    const bool hasRoom = descriptor && errno == 0;
    if (!hasRoom) throw systemError(path_, "no room for a picture");
    ::unlink(probe.c_str());
}

// What is left for all users. Of disks without a limit, a total is 0.
DiskRoom temporaryRoom() {
    DiskRoom room;
    struct statvfs disk {};
    if (::statvfs(parentFolder().c_str(), &disk) != 0) return room;
    if (disk.f_blocks > 0) room.bytes = std::uint64_t{disk.f_bavail} * disk.f_frsize;
    if (disk.f_files > 0) room.files = disk.f_favail;
    return room;
}

}  // namespace raytracer
