// Whether files are the same as others.
#pragma once

#include <span>
#include <string>

namespace raytracer {

// A hash of what is in these files, in this order, 16 hexadecimal digits; against accidents, not against
// attacks. Throws Error.
std::string hashOfFiles(std::span<const std::string> paths);

}  // namespace raytracer
