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

#include "raytracer/util/error.h"

namespace raytracer {
namespace {

// An open file that errors call `name`. `purpose` is how their text begins: "cannot read" or "cannot write".
class Descriptor {
  public:
    Descriptor(const std::string& path, int flags, const std::string& name, const char* purpose)
        : name_(name), purpose_(purpose), fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        require(fd_ >= 0);
    }
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }

    void require(bool done) const {
        if (!done)
            throw Error({name_}, std::string(purpose_) + ": " + std::generic_category().message(errno));
    }

    // Some file systems (NFS, quotas) report a full disk only here.
    void close() { require(::close(std::exchange(fd_, -1)) == 0); }

  private:
    const std::string& name_;
    const char* purpose_;
    int fd_;
};

std::string readToEnd(const Descriptor& file) {
    std::string bytes;
    char block[1 << 16];  // a pipe's capacity on Linux
    for (;;) {
        const ssize_t count = ::read(file.get(), block, sizeof block);
        if (count == 0) return bytes;
        if (count > 0) bytes.append(block, static_cast<std::size_t>(count));
        else file.require(errno == EINTR);
    }
}

void writeAll(const Descriptor& file, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file.get(), bytes.data(), bytes.size());
        if (count >= 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
        else file.require(errno == EINTR);
    }
}

using Parts = std::span<const std::span<const char>>;

void writeParts(Descriptor& file, const Parts& parts) {
    for (const std::span<const char> part : parts) writeAll(file, part);
    file.close();
}

// In the target's folder, since a rename cannot cross file systems. The name is short, however long the
// target's is.
std::filesystem::path temporaryBeside(const std::filesystem::path& target) {
    static std::atomic<unsigned> serial = 0;
    const std::string name =
        ".raytracer-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp";
    return target.parent_path() / name;
}

// Deletes the file at the end, unless it has been renamed, and one at the start that a killed process with
// the same number has left.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::string path) : path_(std::move(path)) { ::unlink(path_.c_str()); }
    ~TemporaryFile() { ::unlink(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

void replaceWhole(const std::string& target, const std::string& name, const Parts& parts) {
    const TemporaryFile temporary(temporaryBeside(target));
    Descriptor file(temporary.path(), O_WRONLY | O_CREAT | O_EXCL, name, "cannot write");
    writeParts(file, parts);
    file.require(std::rename(temporary.path().c_str(), target.c_str()) == 0);
}

}  // namespace

FileBytes::FileBytes(const std::string& path) : path_(path) {
    const Descriptor file(path, O_RDONLY, path, "cannot read");
    struct stat status;
    file.require(::fstat(file.get(), &status) == 0);
    size_ = static_cast<std::size_t>(status.st_size);
    // Files of /proc say that their size is 0. They are read as a pipe is.
    if (S_ISREG(status.st_mode) && size_ > 0) {
        void* const map = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
        mapped_ = map != MAP_FAILED;
        if (mapped_) begin_ = static_cast<const char*>(map);
    }
    if (mapped_) return;
    copy_ = readToEnd(file);
    begin_ = copy_.data();
    size_ = copy_.size();
}

FileBytes::~FileBytes() {
    if (mapped_) ::munmap(const_cast<char*>(begin_), size_);
}

void FileBytes::fail(const std::string& message) const { throw Error({path_}, message); }

void writeFile(const std::string& path, std::span<const std::span<const char>> parts) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        Descriptor file(path, O_WRONLY, path, "cannot write");
        writeParts(file, parts);
    } else {
        const std::filesystem::path target = std::filesystem::canonical(path, error);
        replaceWhole(error ? path : target.string(), path, parts);
    }
}

}  // namespace raytracer
