// The one type for what is wrong with the user's input: one line, with its place, complete for the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace raytracer {

// A place in a file, as far as it is known.
struct Place {
    std::string file;                  // empty where no file is to blame
    std::size_t line = 0, column = 0;  // from 1, the column in characters, as editors count; 0: not known
    std::optional<std::string> pointer = std::nullopt;  // RFC 6901, empty for the whole document
};

// what() is "FILE: /json/pointer: MESSAGE", "FILE:LINE:COLUMN: MESSAGE", "FILE: line LINE: MESSAGE",
// "FILE: MESSAGE" or, of no file, "MESSAGE". main catches it, prints it and ends the program with status 2.
class Error : public std::runtime_error {
  public:
    Error(Place place, const std::string& message);
    explicit Error(const std::string& message) : Error(Place{}, message) {}

    const Place& place() const { return place_; }
    // what() without the file, for a message that names the file in another way.
    const std::string& inFile() const { return inFile_; }

  private:
    Place place_;
    std::string inFile_;
};

// What errno says: "FILE: PURPOSE: No such file or directory", or without the purpose.
Error systemError(const std::string& file, const std::string& purpose = {});

}  // namespace raytracer
