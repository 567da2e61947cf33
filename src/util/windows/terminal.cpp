#include <fcntl.h>
#include <io.h>
#include <unistd.h>
#include <windows.h>

#include <cstdlib>

#include "raytracer/util/standard_streams.h"

namespace raytracer {
namespace {

UINT codePageBefore = 0;
bool hasEscapes = false;  // on standard error

}  // namespace

void prepareStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) _setmode(stream, _O_BINARY);
    codePageBefore = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);  // a property of the window, restored at exit
    std::atexit([] { SetConsoleOutputCP(codePageBefore); });
    HANDLE const console = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    hasEscapes =
        GetConsoleMode(console, &mode) && SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

std::size_t terminalColumns() {
    CONSOLE_SCREEN_BUFFER_INFO info{};
    const bool isConsole = GetConsoleScreenBufferInfo(GetStdHandle(STD_ERROR_HANDLE), &info) != 0;
    return isConsole ? static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1) : 0;
}

bool canOverwrite() { return hasEscapes; }

bool printsOnTerminal() {
    DWORD mode = 0;
    return GetConsoleMode(GetStdHandle(STD_OUTPUT_HANDLE), &mode) != 0;
}

}  // namespace raytracer
