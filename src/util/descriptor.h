// Open files of the operating system.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

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

// Of the platform, from here to writeAll. None, with errno, where the file cannot be opened. A pipe waits for
// its writer only where `waits`.
Descriptor openToRead(const std::string& path, bool waits);

// As read, from a place in the file: -1, with errno, where it fails.
std::int64_t readAt(int descriptor, std::span<char> bytes, std::uint64_t offset);

// Another program may have made our output one that does not wait.
void waitForRoom(int descriptor);

// False, with errno, where not all could be written. Without bytes: where nothing could be.
inline bool writeAll(int descriptor, std::span<const char> bytes) {
    constexpr std::size_t most = std::size_t{1} << 30;  // Windows counts in int
    do {
        const auto size = static_cast<unsigned>(std::min(bytes.size(), most));
        const auto count = ::write(descriptor, bytes.data(), size);
        if (count >= 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (errno == EAGAIN) waitForRoom(descriptor);
        else if (errno != EINTR) return false;
    } while (!bytes.empty());
    return true;
}

}  // namespace raytracer
