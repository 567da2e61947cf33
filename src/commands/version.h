// Which program this is.
#pragma once

#include <string>

namespace raytracer::commands {

// Lines: version and commit, the instruction sets that there is code for, the precisions.
std::string versionText();

}  // namespace raytracer::commands
