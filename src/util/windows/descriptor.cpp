#include "../descriptor.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

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

std::int64_t readAt(int descriptor, std::span<char> bytes, std::uint64_t offset) {
    constexpr std::size_t most = std::size_t{1} << 30;
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(offset);
    place.OffsetHigh = static_cast<DWORD>(offset >> 32);
    DWORD count = 0;
    auto* const file = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
    const auto size = static_cast<DWORD>(std::min(bytes.size(), most));
    if (ReadFile(file, bytes.data(), size, &count, &place) || GetLastError() == ERROR_HANDLE_EOF)
        return count;
    errno = EIO;
    return -1;
}

void waitForRoom(int) {}

}  // namespace raytracer
