#include "../descriptor.h"

#include <fcntl.h>
#include <poll.h>

namespace raytracer {

Descriptor openToRead(const std::string& path, bool waits) {
    return Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (waits ? 0 : O_NONBLOCK)));
}

std::int64_t readAt(int descriptor, std::span<char> bytes, std::uint64_t offset) {
    return ::pread(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
}

void waitForRoom(int descriptor) {
    pollfd room{descriptor, POLLOUT, 0};
    ::poll(&room, 1, -1);
}

}  // namespace raytracer
