// The only way in which the program writes files.
#pragma once

#include <memory>
#include <span>
#include <string>

namespace raytracer {

// A file to be written. It is opened before the work whose
// result it takes, so that an error is reported at once.
//
// The bytes go to a temporary file with a random name in the same folder, which is renamed to the path at the
// end. The file is therefore complete or as before, and nothing else is left, whatever ends the program
// (except SIGKILL). Symbolic links are followed. The new file has the mode and the owner of the one that it
// replaces; the old one's other hard links keep the old content.
//
// Where a rename cannot do that, the file is written in place: in a folder without write permission, over a
// file whose owner cannot be kept, on a mounted file, through /proc/self/fd, and if it is not a regular file.
//
// Each Error has the path as it was given and the reason: "out.png: cannot write: No space left on device".
class OutputFile {
  public:
    OutputFile(const std::string& path);  // NOLINT(google-explicit-constructor): a path stands for its file
    OutputFile(const char* path) : OutputFile(std::string(path)) {}
    static OutputFile standardOutput();
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::string& name() const;  // for errors

    // append() writes the file's next bytes. finish() puts the file in its place; it is the last call.
    // write() does both. All throw Error.
    void append(std::span<const char> bytes);
    void finish();
    void write(std::span<const char> whole) {
        append(whole);
        finish();
    }

  private:
    struct State;
    explicit OutputFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace raytracer
