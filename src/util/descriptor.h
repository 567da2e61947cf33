// Owns an open file of the operating system.
#pragma once

#include <algorithm>
#include <cerrno>
#include <span>
#include <string>
#include <utility>

#include <unistd.h>

namespace raytracer {

class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}  // negative: no file
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

    // False, with errno, if it fails: some file systems (NFS, quotas) report a full disk only here.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_ = -1;
};

// Each platform has its own version of the next two functions.
//
// Opens a file. Returns no file, and sets errno, if that
// fails. Opening a pipe waits for a writer only if `waits`.
Descriptor openToRead(const std::string& path, bool waits);

// Waits until the file can be written to: another program may have made our output non-blocking.
void waitForRoom(int descriptor);

// Returns false, with errno, if not all bytes could be written. Writing no bytes tests whether writing works.
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
