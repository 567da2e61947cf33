// A new empty folder, in $TMPDIR or /tmp, that is deleted with its owner and where a signal ends the program.
// What others have mounted in it is left, and so is what cannot be deleted: a line on standard error says so.
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

    // A new folder in it, which another user may be given: that user can enter this one, but list or change
    // nothing in it, and the name cannot be guessed. Throws Error.
    std::string hiddenFolder() const;

    // Throws Error where its disk has no room for a file of so many bytes.
    void requireRoom(std::size_t bytes) const;

  private:
    std::string path_;
    std::unique_ptr<Leftover> leftover_;
};

}  // namespace raytracer
