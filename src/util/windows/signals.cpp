#include <windows.h>

#include "../leftover.h"

namespace raytracer {

// Windows calls the handler in a thread of its own, for Ctrl+C and when the console window is closed. FALSE
// lets the default handler end the program.
void handleEndingSignals() {
    const auto clear = [](DWORD) WINAPI -> BOOL {
        Leftover::clearAll();
        return FALSE;
    };
    SetConsoleCtrlHandler(clear, TRUE);
}

void withoutEndingSignals(const std::function<void()>& work) { work(); }

}  // namespace raytracer
