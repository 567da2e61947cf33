#include "raytracer/util/file_reader.h"

#include <filesystem>

#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {

FileReader::FileReader(const std::string& path) : path_(path) {
    std::error_code missing;
    const std::filesystem::file_status status = std::filesystem::status(path, missing);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw Error({path}, "cannot read: it is no regular file");
    file_.open(path, std::ios::binary | std::ios::ate);
    if (!file_) throw systemError(path, "cannot read", whereLooked(path));
    size_ = static_cast<std::uint64_t>(file_.tellg());
}

void FileReader::read(std::uint64_t offset, std::span<char> bytes) {
    file_.seekg(static_cast<std::streamoff>(offset)).read(bytes.data(), std::ssize(bytes));
    if (file_.bad()) throw systemError(path_, "cannot read");
    if (!file_) throw Error({path_}, "cannot read: it has become shorter");
}

}  // namespace raytracer
