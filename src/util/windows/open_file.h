#pragma once

#include <string>

#include "../descriptor.h"

namespace raytracer {

// As POSIX's open, of bytes as they are; EISDIR for a folder.
Descriptor openFile(const std::string& path, int flags);

}  // namespace raytracer
