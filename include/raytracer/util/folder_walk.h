// Walks through folders that others have filled.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "raytracer/util/error.h"

namespace raytracer {

inline Error unreadable(const std::filesystem::path& path, std::error_code error) {
    return {{path.string()}, "cannot read: " + error.message()};
}

// Calls take(path, type, depth) for each file, folder and link beneath the folder. No link is followed.
// Throws Error if anything cannot be read, but for what lies deeper than anyone keeps files: that would end
// the walk.
template <class Take>
void walkBeneath(const std::string& folder, Take take) {
    // Folders. The walk holds each one open, and a process may usually hold 1024 files open.
    constexpr int deepest = 100;
    // Of a path, bytes. The system's limit is 4096, that of a name 255.
    constexpr std::size_t longest = 3840;
    std::filesystem::path path = folder;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator entry(path, error), end; !error && entry != end;) {
        path = entry->path();
        const std::filesystem::file_type type = entry->symlink_status(error).type();
        if (error) break;
        take(path, type, entry.depth());
        if (entry.depth() >= deepest || path.native().size() > longest) entry.disable_recursion_pending();
        entry.increment(error);  // opens the folder at `path`
    }
    if (error) throw unreadable(path, error);
}

}  // namespace raytracer
