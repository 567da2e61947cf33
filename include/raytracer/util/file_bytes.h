// Whole files in and out. Each Error has the path and says why: "out.png: cannot write: No space left on
// device".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace raytracer {

// A file's bytes, read only. The file is mapped where that is possible, so that threads that parse it share
// the work of fetching it; else (a pipe) it is read into memory. It must not shrink while it is mapped.
class FileBytes {
  public:
    explicit FileBytes(const std::string& path);  // throws Error
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

// Writes the parts one after the other to a file beside `path` and renames that to `path`, so that the file
// is either whole or as before. A symbolic link stays one. What is no regular file (/dev/null, a pipe) is
// written in place. Throws Error.
void writeFile(const std::string& path, std::span<const std::span<const char>> parts);

}  // namespace raytracer
