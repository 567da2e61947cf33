#include "../descriptor.h"

#include <fcntl.h>
#include <poll.h>

namespace raytracer {

Descriptor openToRead(const std::string& path, bool waits) {
    return Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (waits ? 0 : O_NONBLOCK)));
}

void waitForRoom(int descriptor) {
    pollfd room{descriptor, POLLOUT, 0};
    ::poll(&room, 1, -1);
}

}  // namespace raytracer
