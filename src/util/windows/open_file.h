#pragma once

#include <string>

#include "../descriptor.h"

namespace raytracer {

// Like POSIX's open, without translation of line ends. errno is EISDIR for a folder.
Descriptor openFile(const std::string& path, int flags);

}  // namespace raytracer
