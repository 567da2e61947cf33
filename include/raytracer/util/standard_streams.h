// All output to standard output and standard error, except the progress bar's, goes through these functions.
// It is valid UTF-8 without control characters (printable, text.h), whatever is in names of files and in the
// output of graded programs.
#pragma once

#include <cstddef>
#include <string_view>

namespace raytracer {

class Error;

constexpr std::size_t messageColumns = 100;  // longer lines are hard to read

// Call this before anything else. It makes a write to a closed pipe or beyond the limit of a file's size fail
// with an Error, not with a signal. It also opens the descriptors from 0 to 2 that are closed: otherwise a
// file could get such a number, and the messages.
void prepareStandardStreams();

// Writes the text, one or more whole lines, to standard output at once. Throws Error: "standard output: No
// space left on device". Printing an empty text before long work finds out whether the stream is closed.
void print(std::string_view text);

// Writes one line, given without its line end, to standard error. On a terminal it is wrapped to the
// terminal's width, at most messageColumns.
void tell(std::string_view text);

// The same, but not wrapped, for text that the user may copy.
void tellUnbroken(std::string_view text);

// The error's line, and the excerpt of its file (Error::excerpt).
void tell(const Error& error);

// The number of columns of the terminal that is standard error; 0 if it is no terminal.
std::size_t terminalColumns();

// Whether that terminal can overwrite its last line (TERM is not dumb).
bool canOverwrite();

// Whether standard output is a terminal.
bool printsOnTerminal();

}  // namespace raytracer
