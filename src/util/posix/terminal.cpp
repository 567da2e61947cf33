#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

#include "raytracer/util/standard_streams.h"

namespace raytracer {

void prepareStandardStreams() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // Opens closed streams for the wrong direction, so that using them still fails.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

std::size_t terminalColumns() {
    constexpr std::size_t usual = 80;  // if the terminal does not tell
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
