#include "raytracer/util/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "descriptor.h"
#include "raytracer/util/error.h"
#include "raytracer/util/text.h"

namespace raytracer {

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
    writeAll(STDERR_FILENO, printable(text) + "\n");  // where this fails, nobody can be told
}

}  // namespace raytracer
