#include "../descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>

namespace raytracer {

Descriptor openToRead(const std::string& path, bool waits) {
    return Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (waits ? 0 : O_NONBLOCK)));
}

std::int64_t readAt(int descriptor, std::span<char> bytes, std::uint64_t offset) {
    return ::pread(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
}

const char* mapFile(int descriptor, std::size_t size) {
    void* const map = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    return map == MAP_FAILED ? nullptr : static_cast<const char*>(map);
}

void unmapFile(const char* begin, std::size_t size) { ::munmap(const_cast<char*>(begin), size); }

void waitForRoom(int descriptor) {
    pollfd room{descriptor, POLLOUT, 0};
    ::poll(&room, 1, -1);
}

}  // namespace raytracer
