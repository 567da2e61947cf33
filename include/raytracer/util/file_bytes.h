// Whole files, read. Each Error has the path and says why: "a.png: cannot read: No such file or directory".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/util/large_vector.h"

namespace raytracer {

// What a file may be: a pipe or a device, too, or nothing that can make its reader wait or that has no end.
enum class FileKind { Any, Regular };

// A copy of a file's bytes: what other programs do to the file afterwards changes nothing.
class FileBytes {
  public:
    // Throws Error. NOLINTNEXTLINE(google-explicit-constructor): a path stands for its file
    FileBytes(const std::string& path, FileKind kind = FileKind::Any);
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const std::string& path() const { return path_; }
    std::string_view text() const { return {bytes_.data(), size_}; }
    [[noreturn]] void fail(const std::string& message) const;  // an Error about what is in the file

  private:
    void resize(std::size_t size);

    std::string path_;
    LargeVector<char> bytes_;
    std::size_t size_ = 0;  // of the file; bytes_ may be longer
};

}  // namespace raytracer
