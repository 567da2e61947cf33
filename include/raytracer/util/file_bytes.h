// Whole files in and out, with errors that say why.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

namespace raytracer {

// what() is one line without the file's name: "cannot read: No such file or directory".
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A file's bytes, read only: mapped where the file allows it, so that threads that parse it also share the
// work of fetching it, else (a pipe) read into memory. The file must not shrink while it is mapped.
class FileBytes {
  public:
    explicit FileBytes(const std::string& path);  // throws FileError
    ~FileBytes();
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const char* begin() const { return begin_; }
    const char* end() const { return begin_ + size_; }
    std::size_t size() const { return size_; }

  private:
    const char* begin_ = "";
    std::size_t size_ = 0;
    bool mapped_ = false;
    std::string copy_;
};

// Writes the parts, one after the other, beside `path` and renames the whole onto it, so that the file is
// whole or as it was; a symbolic link stays one. What is no regular file (/dev/null, a pipe) is written in
// place. Throws FileError.
void writeFile(const std::string& path, std::span<const std::span<const char>> parts);

}  // namespace raytracer
