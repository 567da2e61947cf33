#include "../access_list.h"

#include <sys/xattr.h>

#include <cerrno>
#include <string>

namespace raytracer {
namespace {

constexpr const char* listName = "system.posix_acl_access";

bool meansNone(int error) { return error == ENODATA || error == EOPNOTSUPP; }

// A new file may have a list, from its folder.
bool removeAccessList(int file) { return ::fremovexattr(file, listName) == 0 || meansNone(errno); }

}  // namespace

bool copyAccessList(int from, int to) {
    const auto size = ::fgetxattr(from, listName, nullptr, 0);
    if (size < 0) return meansNone(errno) && removeAccessList(to);
    std::string list(static_cast<std::size_t>(size), '\0');
    return ::fgetxattr(from, listName, list.data(), list.size()) == size &&
           ::fsetxattr(to, listName, list.data(), list.size(), 0) == 0;
}

}  // namespace raytracer
