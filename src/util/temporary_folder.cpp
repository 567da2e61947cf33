#include "raytracer/util/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "raytracer/util/error.h"

namespace raytracer {

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "raytracer-XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw Error({name}, std::string("cannot make the folder: ") + std::strerror(errno));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;  // what stays in the folder for temporary files does no harm
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace raytracer
