// A new empty folder in $TMPDIR or /tmp. It is deleted with this object, and if a signal ends the program.
// What others have mounted in it is left, and so is what cannot be deleted: a line on standard error says so.
#pragma once

#include <cstddef>
#include <cstdint>
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

    // Makes a subfolder that may be given to another user. That user can enter the temporary folder, but can
    // neither list nor change what is in it, and cannot guess the name of another subfolder. Throws Error.
    std::string hiddenFolder() const;

    // Throws Error if its disk has no room for a file of this many bytes.
    void requireRoom(std::size_t bytes) const;

  private:
    std::string path_;
    std::unique_ptr<Leftover> leftover_;
};

// What the disk of the temporary folders can still take.
struct DiskRoom {
    std::uint64_t bytes = UINT64_MAX, files = UINT64_MAX;  // as they are here: unlimited, or unknown
};
DiskRoom temporaryRoom();

}  // namespace raytracer
