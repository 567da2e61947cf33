// Reads whole files. Each Error has the path and the reason: "a.png: cannot read: No such file or directory".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/util/large_vector.h"

namespace raytracer {

// Which files are accepted. Any includes pipes and terminals.
// A Regular file cannot make its reader wait, and has an end.
enum class FileKind { Any, Regular };

// A copy of a file's bytes, which does not change when other programs change the file afterwards.
class FileBytes {
  public:
    // Throws Error. NOLINTNEXTLINE(google-explicit-constructor): a path stands for its file
    FileBytes(const std::string& path, FileKind kind = FileKind::Any);
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const std::string& path() const { return path_; }
    std::string_view text() const { return {bytes_.data(), size_}; }
    [[noreturn]] void fail(const std::string& message) const;  // throws an Error about the file's content

  private:
    void resize(std::size_t size);

    std::string path_;
    LargeVector<char> bytes_;
    std::size_t size_ = 0;  // of the file; bytes_ may be longer
};

}  // namespace raytracer
