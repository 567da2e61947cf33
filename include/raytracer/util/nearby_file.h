// "there is ...": the file that a name which leads nowhere probably means.
#pragma once

#include <string>

namespace raytracer {

// A regular file like the one that `path` should be: with slashes for backslashes, in other letters (case,
// misspelled), with an ending that the path lacks or another one, in a folder below the path's or beside it.
// Empty where there is none, or where too many files are there to look at.
std::string nearbyFile(const std::string& path);

// `; there is "NEARBY"`, or nothing. Leaves errno as it is.
std::string hintAt(const std::string& path);

}  // namespace raytracer
