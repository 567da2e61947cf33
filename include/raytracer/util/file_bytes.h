// Whole files, read. Each Error has the path and says why: "a.png: cannot read: No such file or directory".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raytracer {

// What a file may be: a pipe or a device, too, or nothing that can make its reader wait or that has no end.
enum class FileKind { Any, Regular };

// A file's bytes, read only. The file is mapped where that is possible, so that threads that parse it share
// the work of fetching it; else (a pipe) it is read into memory. It must not shrink while it is mapped.
class FileBytes {
  public:
    explicit FileBytes(const std::string& path, FileKind kind = FileKind::Any);  // throws Error
    ~FileBytes();
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const std::string& path() const { return path_; }
    std::string_view text() const { return {begin_, size_}; }
    [[noreturn]] void fail(const std::string& message) const;  // an Error about what is in the file

  private:
    std::string path_;
    const char* begin_ = "";
    std::size_t size_ = 0;
    bool mapped_ = false;
    std::string copy_;
};

}  // namespace raytracer
