// "there is ...": finds the file that was probably meant by a name that leads nowhere.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "raytracer/util/error.h"

namespace raytracer {

// All entries of a folder that are neither folders nor hidden, and those of its subfolders down to `depth`.
// The entries include pipes and broken links. They are sorted, since a folder has no order. At most `most`
// entries are looked at. `error` is why the listing stopped early, if it did.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, std::error_code& error,
                                           int depth = 0,
                                           std::size_t most = std::numeric_limits<std::size_t>::max());

// Throws Error if the current folder is gone.
std::string absolutePath(const std::string& path);

// A regular file that `path` probably means. Its name may differ in slashes for backslashes, in case, by a
// misspelling, or in the ending (the path has none, or another one of the same kind). It may be in a folder
// with a similar name, below the path's folder, or beside it. Empty if there is none, or if there are too
// many files to look at.
std::string nearbyFile(const std::string& path);

// The right name for a file that is named in another file, which lies in `folder`; relative to `folder`. It
// corrects names that are relative to where the program runs, paths of another computer, and what
// nearbyFile() corrects. Empty if nothing is found.
std::string nearbyName(const std::string& folder, std::string_view written);

// `; there is "NEARBY"`, or empty.
std::string hintAt(const std::string& path);

// For an error of reading `path`, if errno says that there is no such file: hintAt(), or, for
// a relative path, `; looked in FOLDER` or missingFolder(). Else empty. Leaves errno as it is.
std::string whereLooked(const std::string& path);

// Why a folder cannot be read. If it is missing, the message names one with a similar name; if it is a file,
// it names the file's folder.
Error folderError(const std::string& folder, std::error_code error);

// `; there is no folder "FOLDER"` if errno says that a file cannot be made since its folder is missing; else
// empty. Leaves errno as it is.
std::string missingFolder(const std::string& path);

}  // namespace raytracer
