// Open files of the operating system.
#pragma once

#include <cerrno>
#include <span>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace raytracer {

class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}  // negative: none
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }

    explicit operator bool() const { return number_ >= 0; }
    int get() const { return number_; }

    // Some file systems (NFS, quotas) report a full disk only here: false, with errno.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_ = -1;
};

// Another program may have made our output one that does not wait.
inline void waitForRoom(int descriptor) {
    pollfd room{descriptor, POLLOUT, 0};
    ::poll(&room, 1, -1);
}

// False, with errno, where not all could be written.
inline bool writeAll(int descriptor, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count >= 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (errno == EAGAIN) waitForRoom(descriptor);
        else if (errno != EINTR) return false;
    }
    return true;
}

}  // namespace raytracer
