#include "version.h"

#include "raytracer/numerics/instruction_set.h"

namespace raytracer {

namespace build {
extern const char* const version;  // made by cmake/version.cmake
extern const char* const commit;
extern const char* const sources;
}  // namespace build

std::string commands::versionText() {
    std::string sets;
    for (const InstructionSet set : supportedInstructionSets())
        sets += (sets.empty() ? "" : ", ") + std::string(nameOf(set));
    return std::string("raytracer ") + build::version + " (" + build::commit +
           ")\ninstruction sets: " + sets + "; used: " + std::string(nameOf(defaultInstructionSet())) +
           "\nprecisions: float, double, extended\n";
}

std::string commands::programVersion() {
    return std::string(build::version) + " (sources " + build::sources + ")";
}

}  // namespace raytracer
