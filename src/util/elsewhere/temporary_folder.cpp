#include "raytracer/util/temporary_folder.h"

#include <filesystem>
#include <random>
#include <system_error>

#include "../leftover.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::random_device random;
    const fs::path parent = fs::temp_directory_path(error);  // only its owner can enter it
    path_ = (parent / formatted("raytracer-%08x%08x", random(), random())).string();
    if (error || !fs::create_directory(path_, error))
        throw Error({parent.string()}, "cannot make a temporary folder: " + error.message());
    leftover_ = std::make_unique<Leftover>(removeFolder, path_.c_str());
}

// No programs are run here (child_process.cpp), so no other user needs to enter it.
std::string TemporaryFolder::hiddenFolder() const {
    std::error_code error;
    if (!fs::create_directory(file("hidden"), error))
        throw Error({path_}, "cannot make a temporary folder: " + error.message());
    return file("hidden");
}

void TemporaryFolder::requireRoom(std::size_t bytes) const {
    std::error_code error;
    if (fs::space(path_, error).available < bytes) throw Error({path_}, "no room for a picture");
}

DiskRoom temporaryRoom() {
    std::error_code error;
    return {fs::space(fs::temp_directory_path(error), error).available};
}

}  // namespace raytracer
