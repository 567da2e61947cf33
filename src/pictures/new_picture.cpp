#include <filesystem>

#include "raytracer/pictures/image.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"
#include "whole_picture.h"

namespace raytracer {
namespace {

namespace files = std::filesystem;

// When the file was last written. A missing file counts as newer than any picture.
files::file_time_type timeOf(const std::string& path) {
    std::error_code error;
    const files::file_time_type time = files::last_write_time(path, error);
    return error ? files::file_time_type::max() : time;
}

ImageSize sizeOfWhole(const std::string& path) {
    const FileBytes file(path, FileKind::Regular);
    return endsIn(path, ".pfm") ? sizeOfWholePfm(file) : sizeOfWholePng(file);
}

}  // namespace

bool isNewPicture(const std::string& path, const PixelRectangle& crop, std::span<const std::string> others) {
    std::error_code error;
    if (!files::is_regular_file(path, error)) return false;
    const files::file_time_type written = timeOf(path);
    for (const std::string& other : others)
        if (timeOf(other) >= written) return false;
    try {
        return sizeOfWhole(path) == crop.size();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace raytracer
