#include "raytracer/util/standard_streams.h"

#include <algorithm>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

void writeLines(const std::string& text) {
    writeAll(STDERR_FILENO, text + "\n");  // if this fails, there is no way to report it
}

}  // namespace

void print(std::string_view text) {
    if (!writeAll(STDOUT_FILENO, printable(text, "\n"))) throw systemError("standard output");
}

void tell(std::string_view text) {
    constexpr std::size_t indent = 4;
    const std::string line = printable(text);
    const std::size_t columns = terminalColumns();
    writeLines(columns > 0 ? wrapped(line, std::min(columns, messageColumns), indent) : line);
}

void tellUnbroken(std::string_view text) { writeLines(printable(text)); }

void tell(const Error& error) {
    tell(std::string_view(error.what()));
    const std::size_t columns = terminalColumns();
    for (const std::string& line :
         error.excerpt(columns > 0 ? std::min(columns, messageColumns) : messageColumns))
        writeLines(line);
}

}  // namespace raytracer
