#include "raytracer/util/standard_streams.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {
constexpr std::size_t mostColumns = 100;  // of a line that is read with ease
}

void prepareStandardStreams() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // Open for the wrong direction, so that using it still fails.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void print(std::string_view text) {
    if (!writeAll(STDOUT_FILENO, printable(text, "\n"))) throw systemError("standard output");
}

void tell(std::string_view text) {
    constexpr std::size_t indent = 4;
    std::string line = printable(text);
    if (const std::size_t columns = terminalColumns())
        line = wrapped(line, std::min(columns, mostColumns), indent);
    writeAll(STDERR_FILENO, line + "\n");  // where this fails, nobody can be told
}

void tell(const Error& error) {
    tell(std::string_view(error.what()));
    const std::size_t columns = terminalColumns();
    for (const std::string& line : error.excerpt(columns > 0 ? std::min(columns, mostColumns) : mostColumns))
        writeAll(STDERR_FILENO, line + "\n");
}

std::size_t terminalColumns() {
    constexpr std::size_t usual = 80;  // where the terminal does not know
    winsize size{};
    if (!::isatty(STDERR_FILENO)) return 0;
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

bool canOverwrite() {
    const char* const kind = std::getenv("TERM");
    return terminalColumns() > 0 && kind && std::string_view(kind) != "dumb";
}

bool printsOnTerminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace raytracer
