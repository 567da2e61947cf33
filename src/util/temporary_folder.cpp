#include "raytracer/util/temporary_folder.h"

#include <filesystem>
#include <system_error>

#include "leftover.h"
#include "raytracer/util/standard_streams.h"

namespace raytracer {

TemporaryFolder::~TemporaryFolder() {
    leftover_->clear();
    std::error_code error;
    if (std::filesystem::exists(std::filesystem::symlink_status(path_, error)))
        tell(path_ + ": cannot be deleted: something in it is mounted or immutable; delete it by hand");
}

}  // namespace raytracer
