// With what POSIX allows in a signal's handler, and Linux' own call for opendir, which it does not allow.
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>

#include "../descriptor.h"
#include "../leftover.h"

namespace raytracer {
namespace {

// Its maker may have locked it. `name` is no link, for that gives another error.
Descriptor openFolder(int parent, const char* name) {
    constexpr int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    Descriptor folder(::openat(parent, name, flags));
    if (folder || errno != EACCES || ::fchmodat(parent, name, S_IRWXU, 0) != 0) return folder;
    return Descriptor(::openat(parent, name, flags));
}

// `entry` is what the kernel writes for getdents64.
void removeContents(int folder) {
    ::fchmod(folder, S_IRWXU);
    alignas(dirent64) char entries[1024];
    for (;;) {
        const auto size = ::syscall(SYS_getdents64, folder, entries, sizeof entries);
        if (size <= 0) return;
        for (long at = 0; at < size;) {
            const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
            at += entry->d_reclen;
            const char* const name = entry->d_name;
            const bool isOther = name[0] != '.' || (name[1] && (name[1] != '.' || name[2]));
            if (!isOther || ::unlinkat(folder, name, 0) == 0) continue;
            const Descriptor inner = openFolder(folder, name);
            if (inner) removeContents(inner.get());
            ::unlinkat(folder, name, AT_REMOVEDIR);
        }
    }
}

}  // namespace

void removeFolder(const void* path) {
    const auto* const name = static_cast<const char*>(path);
    // A process that is being killed may still make a file.
    for (int attempt = 0; attempt < 100 && ::rmdir(name) != 0 && errno != ENOENT; ++attempt) {
        const Descriptor folder = openFolder(AT_FDCWD, name);
        if (!folder) return;
        removeContents(folder.get());
    }
}

}  // namespace raytracer
