// Reads a regular file piece by piece, so that it need not fit into memory.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace raytracer {

class Descriptor;

class FileReader {
  public:
    // Throws Error: "a.part: cannot read: No such file or directory".
    explicit FileReader(const std::string& path);
    ~FileReader();
    FileReader(const FileReader&) = delete;
    FileReader& operator=(const FileReader&) = delete;

    std::uint64_t size() const { return size_; }
    void read(std::uint64_t offset, std::span<char> bytes) const;  // fills all of `bytes`; throws Error

  private:
    std::string path_;
    std::unique_ptr<Descriptor> file_;
    std::uint64_t size_ = 0;
};

}  // namespace raytracer
