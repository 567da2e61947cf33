#include "../descriptor.h"

#include <fcntl.h>
#include <io.h>

#include <filesystem>

#include "open_file.h"

namespace raytracer {

Descriptor openFile(const std::string& path, int flags) {
    Descriptor file(::_open(path.c_str(), flags | _O_BINARY | _O_NOINHERIT));
    std::error_code ignored;
    if (!file && errno == EACCES && std::filesystem::is_directory(path, ignored)) errno = EISDIR;
    return file;
}

Descriptor openToRead(const std::string& path, bool) { return openFile(path, _O_RDONLY); }

void waitForRoom(int) {}

}  // namespace raytracer
