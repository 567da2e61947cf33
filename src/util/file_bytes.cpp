#include "raytracer/util/file_bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace raytracer {
namespace {

[[noreturn]] void fail(const char* what, int error) {
    throw FileError(std::string(what) + ": " + std::generic_category().message(error));
}

class Descriptor {
  public:
    Descriptor(const std::string& path, int flags, const char* whatFailed)
        : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        if (fd_ < 0) fail(whatFailed, errno);
    }
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }

    // Some file systems (NFS, quotas) report a full disk only here.
    void close() {
        if (::close(std::exchange(fd_, -1)) != 0) fail("cannot write", errno);
    }

  private:
    int fd_;
};

std::string readToEnd(int fd) {
    std::string bytes;
    char block[1 << 16];  // a pipe's capacity on Linux
    for (;;) {
        const ssize_t count = ::read(fd, block, sizeof block);
        if (count == 0) return bytes;
        if (count > 0) bytes.append(block, static_cast<std::size_t>(count));
        else if (errno != EINTR) fail("cannot read", errno);
    }
}

void writeAll(int fd, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(fd, bytes.data(), bytes.size());
        if (count >= 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (errno != EINTR) fail("cannot write", errno);
    }
}

void writeParts(const std::string& path, int flags, std::span<const std::span<const char>> parts) {
    Descriptor file(path, O_WRONLY | flags, "cannot write");
    for (const std::span<const char> part : parts) writeAll(file.get(), part);
    file.close();
}

// In the target's folder, for a rename cannot cross file systems; short, whatever the length of the target's
// name.
std::filesystem::path temporaryBeside(const std::filesystem::path& target) {
    static std::atomic<unsigned> serial = 0;
    const std::string name =
        ".raytracer-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp";
    return target.parent_path() / name;
}

void replaceWhole(const std::string& target, std::span<const std::span<const char>> parts) {
    const std::string temporary = temporaryBeside(target);
    ::unlink(temporary.c_str());  // left by a killed process that had our number
    try {
        writeParts(temporary, O_CREAT | O_EXCL, parts);
        if (std::rename(temporary.c_str(), target.c_str()) != 0) fail("cannot write", errno);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
}

}  // namespace

FileBytes::FileBytes(const std::string& path) {
    const Descriptor file(path, O_RDONLY, "cannot read");
    struct stat status;
    if (::fstat(file.get(), &status) != 0) fail("cannot read", errno);
    size_ = static_cast<std::size_t>(status.st_size);
    // A file of /proc says that its size is 0, so that is read as a pipe is.
    if (S_ISREG(status.st_mode) && size_ > 0) {
        void* const map = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
        mapped_ = map != MAP_FAILED;
        if (mapped_) begin_ = static_cast<const char*>(map);
    }
    if (mapped_) return;
    copy_ = readToEnd(file.get());
    begin_ = copy_.data();
    size_ = copy_.size();
}

FileBytes::~FileBytes() {
    if (mapped_) ::munmap(const_cast<char*>(begin_), size_);
}

void writeFile(const std::string& path, std::span<const std::span<const char>> parts) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        writeParts(path, 0, parts);
    } else {
        const std::filesystem::path target = std::filesystem::canonical(path, error);
        replaceWhole(error ? path : target.string(), parts);
    }
}

}  // namespace raytracer
