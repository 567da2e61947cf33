// The only way to standard output and to standard error, but for the progress bar. What is shown is valid
// UTF-8 without control characters (printable, text.h), whatever names and graded programs say.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raytracer {

class Error;

constexpr std::size_t messageColumns = 100;  // of a line that is read with ease

// Before all else: closes the ways in which a write would end the process or go astray. A full disk or a
// closed pipe becomes an Error, not a signal; a descriptor from 0 to 2 that is closed is taken, so that no
// file gets its number and the messages.
void prepareStandardStreams();

// Writes the text, lines each with its end, to standard output at once. Throws Error: "standard output: No
// space left on device". An empty text, before what takes long, finds a stream that is closed.
void print(std::string_view text);

// Writes one line, of which `text` has no end, to standard error. On a terminal it is wrapped to the
// terminal's width and to at most messageColumns.
void tell(std::string_view text);

// The same, not wrapped: what is to be copied.
void tellUnbroken(std::string_view text);

// The error's line, and the excerpt of its file.
void tell(const Error& error);

// What standard error is: the columns of a terminal, or 0 where it is none.
std::size_t terminalColumns();

// Whether that terminal can overwrite its last line (TERM is not dumb).
bool canOverwrite();

// Whether standard output is a terminal.
bool printsOnTerminal();

}  // namespace raytracer
