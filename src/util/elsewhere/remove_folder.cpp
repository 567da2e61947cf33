#include <filesystem>
#include <system_error>

#include "../leftover.h"

namespace raytracer {

void removeFolder(const void* path) {
    std::error_code ignored;
    std::filesystem::remove_all(static_cast<const char*>(path), ignored);
}

}  // namespace raytracer
