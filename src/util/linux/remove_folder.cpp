// Uses only what POSIX allows in a signal handler; in place of
// opendir, which it does not allow, Linux's own system call.
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <iterator>

#include "../descriptor.h"
#include "../leftover.h"

namespace raytracer {
namespace {

// Whether a name is a mount point: what is mounted there is not ours to delete. Before Linux 5.8 this cannot
// be found out, and is false.
bool isMounted(int parent, const char* name) {
    struct statx status {};
    return ::statx(parent, name, AT_SYMLINK_NOFOLLOW, 0, &status) == 0 &&
           (status.stx_attributes & STATX_ATTR_MOUNT_ROOT);
}

// Opens a folder, if it is not a mount point. If that is forbidden, gives this user the right to first.
// `name` is no symbolic link then: a link gives another error than EACCES.
Descriptor openFolder(int parent, const char* name) {
    if (isMounted(parent, name)) return {};
    constexpr int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    Descriptor folder(::openat(parent, name, flags));
    if (folder || errno != EACCES || ::fchmodat(parent, name, S_IRWXU, 0) != 0) return folder;
    return Descriptor(::openat(parent, name, flags));
}

// Calls use(name) for each entry of a folder. The kernel writes the entries for getdents64.
template <typename Use>
void forEachEntry(int folder, const Use& use) {
    ::lseek(folder, 0, SEEK_SET);
    alignas(dirent64) char entries[1024];
    for (;;) {
        const auto size = ::syscall(SYS_getdents64, folder, entries, sizeof entries);
        if (size <= 0) return;
        for (long at = 0; at < size;) {
            const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
            at += entry->d_reclen;
            const char* const name = entry->d_name;
            const bool isOther = name[0] != '.' || (name[1] && (name[1] != '.' || name[2]));
            if (isOther) use(name);
        }
    }
}

bool removed(int folder, const char* name) {
    return ::unlinkat(folder, name, 0) == 0 || ::unlinkat(folder, name, AT_REMOVEDIR) == 0;
}

// Removes the contents of a folder with few descriptors, however deeply folders nest in it: the contents of
// its subfolders are moved up into the folder itself, under new names.
class Removal {
  public:
    explicit Removal(const Descriptor& top) : top_(top.get()) { ::fchmod(top_, S_IRWXU); }

    // Removes one level. False if nothing could be removed or moved.
    bool pass() {
        bool hasChanged = false;
        forEachEntry(top_, [&](const char* name) { hasChanged |= removed(top_, name) || isFlattened(name); });
        return hasChanged;
    }

  private:
    bool isFlattened(const char* name) {
        const Descriptor folder = openFolder(top_, name);
        if (!folder) return false;
        ::fchmod(folder.get(), S_IRWXU);
        bool hasChanged = false;
        forEachEntry(folder.get(), [&](const char* inner) {
            hasChanged |= removed(folder.get(), inner) || isMovedUp(folder.get(), inner);
        });
        return removed(top_, name) || hasChanged;
    }

    bool isMovedUp(int folder, const char* name) {
        const Descriptor moved = openFolder(folder, name);
        if (moved) ::fchmod(moved.get(), S_IRWXU);  // without write permission a folder cannot be moved
        for (;;) {
            char number[16] = {};
            std::to_chars(std::begin(number), std::end(number), next_++);
            if (::renameat(folder, name, top_, number) == 0) return true;
            const bool isTaken = errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR;
            if (!isTaken) return false;
        }
    }

    int top_;
    unsigned next_ = 0;
};

}  // namespace

void removeFolder(const void* path) {
    const auto* const name = static_cast<const char*>(path);
    const Descriptor top = openFolder(AT_FDCWD, name);  // fails if a link has taken its place
    Removal removal(top);
    while (!removed(AT_FDCWD, name) && errno != ENOENT && removal.pass()) {
    }
}

}  // namespace raytracer
