// A new empty folder, in $TMPDIR or /tmp, that is deleted with its owner and where a signal ends the program.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace raytracer {

class Leftover;

class TemporaryFolder {
  public:
    TemporaryFolder();  // throws Error
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    // The file's absolute path.
    std::string file(const std::string& name) const { return path_ + '/' + name; }

    // Throws Error where its disk has no room for a file of so many bytes.
    void requireRoom(std::size_t bytes) const;

  private:
    std::string path_;
    std::unique_ptr<Leftover> leftover_;
};

}  // namespace raytracer
