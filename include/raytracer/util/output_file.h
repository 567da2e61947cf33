// The one way to write a file.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace raytracer {

// A place for a file: made before the work whose result it takes, so that a place that cannot be written is
// told at once.
//
// The file is written beside the place, under a random name, and renamed onto it: the file is whole or as
// before, and nothing else is left, whatever ends the program (but SIGKILL). Symbolic links are followed. A
// file that is replaced leaves its mode and its owner to the new one; its other hard links keep the old one.
// Where a rename cannot do that, the file is written in place: in a folder that cannot be written, over
// another's file, on a mounted file, through /proc/self/fd, and into what is no regular file.
//
// Each Error has the path as it was given and says why: "out.png: cannot write: No space left on device".
class OutputFile {
  public:
    OutputFile(const std::string& path);  // NOLINT(google-explicit-constructor): a path is such a place
    OutputFile(const char* path) : OutputFile(std::string(path)) {}
    static OutputFile standardOutput();
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::string& name() const;  // for errors

    // The file's next bytes. It is there once it is finished; nothing comes after that.
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
