#include "raytracer/util/child_process.h"
#include "raytracer/util/text.h"

namespace raytracer {

std::string ProcessEnd::description() const {
    switch (stop) {
        case Stop::Hung: return formatted("hung: stopped after %.3g s", seconds);
        case Stop::TooSlow: return formatted("too slow: %.2g s of processor time", processorSeconds);
        case Stop::TooManyProcesses: return "started too many processes";
        case Stop::TooMuchOutput: return "printed or wrote too much";
        case Stop::None: break;
    }
    if (signal) return "crashed: " + signalName(signal);
    if (exitStatus == 127) return "could not be started";
    return exitStatus ? "exit status " + std::to_string(exitStatus) : "";
}

ProcessEnd runProcess(const ProcessStart& start) {
    ProcessEnd result;
    runProcesses(
        1, 1, [&](std::size_t) { return start; }, [&](std::size_t, const ProcessEnd& end) { result = end; });
    return result;
}

}  // namespace raytracer
