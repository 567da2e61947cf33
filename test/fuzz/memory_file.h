// A file in memory, for what reads files by their names.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

class MemoryFile {
  public:
    MemoryFile()
        : descriptor_(::memfd_create("fuzz", 0)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {}
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& path() const { return path_; }
    const std::string& write(const void* bytes, std::size_t count) const {
        require(::ftruncate(descriptor_, 0) == 0);
        require(::pwrite(descriptor_, bytes, count, 0) == static_cast<ssize_t>(count));
        return path_;
    }
    const std::string& write(const std::string& text) const { return write(text.data(), text.size()); }

    static void require(bool holds) {
        if (!holds) std::abort();
    }

  private:
    int descriptor_;
    std::string path_;
};

using Bytes = const std::uint8_t*;
