// A regular file that is read piece by piece, since it need not fit into memory.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace raytracer {

class FileReader {
  public:
    explicit FileReader(
        const std::string& path);  // throws Error: "a.part: cannot read: No such file or directory"
    ~FileReader();
    FileReader(const FileReader&) = delete;
    FileReader& operator=(const FileReader&) = delete;

    std::uint64_t size() const;
    void read(std::uint64_t offset, std::span<char> bytes) const;  // all of these; throws Error

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace raytracer
