// Reads a regular file piece by piece, so that it need not fit into memory.
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>

namespace raytracer {

class FileReader {
  public:
    // Throws Error: "a.part: cannot read: No such file or directory".
    explicit FileReader(const std::string& path);

    std::uint64_t size() const { return size_; }
    void read(std::uint64_t offset, std::span<char> bytes);  // fills all of `bytes`; throws Error

  private:
    std::string path_;
    std::ifstream file_;
    std::uint64_t size_ = 0;
};

}  // namespace raytracer
