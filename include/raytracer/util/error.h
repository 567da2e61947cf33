// The one type of error in the user's input: a one-line message with its place, ready for the terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// A place in a file, as far as it is known.
struct Place {
    std::string file;                  // empty if the error is not in a file
    std::size_t line = 0, column = 0;  // from 1; the column in characters, as editors count; 0: unknown
    std::optional<std::string> pointer = std::nullopt;  // RFC 6901, empty for the whole document
};

// what() is "FILE:LINE:COLUMN: /json/pointer: MESSAGE", with the parts that are known: also "FILE:
// /json/pointer: MESSAGE", "FILE: line LINE: MESSAGE", "FILE: MESSAGE" or "MESSAGE". main catches it, prints
// it and ends the program with status 2.
class Error : public std::runtime_error {
  public:
    // `line` is the text of the place's line, if the line is to be shown with a mark below the column.
    Error(Place place, const std::string& message, std::string_view line = {});
    explicit Error(const std::string& message) : Error(Place{}, message) {}

    const Place& place() const { return place_; }
    // what() without the file, for a message that names the file in another way.
    const std::string& inFile() const { return inFile_; }

    // The line, and a second line with the mark. Both are at most this many columns wide, and have no line
    // end. Empty if no line is to be shown.
    std::vector<std::string> excerpt(std::size_t columns) const;

  private:
    Place place_;
    std::string inFile_;
    std::string line_;
};

// An Error from errno: "FILE: PURPOSE: No such file or directory", without the purpose if that is empty, and
// with `more` appended.
Error systemError(const std::string& file, const std::string& purpose = {}, const std::string& more = {});

}  // namespace raytracer
