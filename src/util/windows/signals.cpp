#include <windows.h>

#include "../leftover.h"

namespace raytracer {

// For Ctrl+C, and a window that is closed: in a thread of its own. The default then ends the program.
void handleEndingSignals() {
    const auto clear = [](DWORD) WINAPI -> BOOL {
        Leftover::clearAll();
        return FALSE;
    };
    SetConsoleCtrlHandler(clear, TRUE);
}

void withoutEndingSignals(const std::function<void()>& work) { work(); }

}  // namespace raytracer
