// The one type for what is wrong with the user's input: one line, with its place, complete for the terminal.
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
    std::string file;                  // empty where no file is to blame
    std::size_t line = 0, column = 0;  // from 1, the column in characters, as editors count; 0: not known
    std::optional<std::string> pointer = std::nullopt;  // RFC 6901, empty for the whole document
};

// what() is "FILE:LINE:COLUMN: /json/pointer: MESSAGE", or without the pointer, "FILE: /json/pointer:
// MESSAGE", "FILE: line LINE: MESSAGE", "FILE: MESSAGE" or, of no file, "MESSAGE". main catches it, prints it
// and ends the program with status 2.
class Error : public std::runtime_error {
  public:
    // `line`: the text of the place's line, where it is to be shown with a mark at the column.
    Error(Place place, const std::string& message, std::string_view line = {});
    explicit Error(const std::string& message) : Error(Place{}, message) {}

    const Place& place() const { return place_; }
    // what() without the file, for a message that names the file in another way.
    const std::string& inFile() const { return inFile_; }

    // The line and, below, a mark: at most so many columns wide, both without an end. Nothing where no line
    // is to be shown.
    std::vector<std::string> excerpt(std::size_t columns) const;

  private:
    Place place_;
    std::string inFile_;
    std::string line_;
};

// What errno says: "FILE: PURPOSE: No such file or directory", or without the purpose, and with more behind.
Error systemError(const std::string& file, const std::string& purpose = {}, const std::string& more = {});

}  // namespace raytracer
