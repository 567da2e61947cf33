// "there is ...": the file that a name which leads nowhere probably means.
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

// All that is in a folder, and with `depth` in the folders of it, but folders and what is hidden; so pipes
// and links that lead nowhere, too. In alphabetical order, since a folder has none. No more than `most` of
// what is there are looked at. `error`: why no more can be.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, std::error_code& error,
                                           int depth = 0,
                                           std::size_t most = std::numeric_limits<std::size_t>::max());

// Throws Error where the current folder is gone.
std::string absolutePath(const std::string& path);

// A regular file like the one that `path` should be: with slashes for backslashes, in other letters (case,
// misspelled), with an ending that the path lacks or another one of the same kind, in a folder with a name
// like the path's, below the path's, or beside it. Empty where there is none, or where too many files are
// there to look at.
std::string nearbyFile(const std::string& path);

// What should be written in a file in `folder` that names another one, relative to that folder: for a name
// from where the program runs, from another computer's folders, or one that nearbyFile() puts right. Empty
// where there is none.
std::string nearbyName(const std::string& folder, std::string_view written);

// `; there is "NEARBY"`, or nothing.
std::string hintAt(const std::string& path);

// Where errno says that there is no file: the hint, or of a relative path `; looked in FOLDER`, or that there
// is no such folder. Leaves errno as it is.
std::string whereLooked(const std::string& path);

// Why a folder cannot be read, and where it is missing, which one has a name like its; where it is a file,
// the file's folder.
Error folderError(const std::string& folder, std::error_code error);

// `; there is no folder "FOLDER"` where errno says that a file cannot be made, for want of its folder; else
// nothing. Leaves errno as it is.
std::string missingFolder(const std::string& path);

}  // namespace raytracer
