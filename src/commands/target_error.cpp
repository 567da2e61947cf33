#include "target_error.h"

#include <string>

#include "raytracer/util/standard_streams.h"

namespace raytracer::commands {

TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, bool quiet) {
    TargetChoice choice = chooseSetting(renderer, options, target);
    options = withSetting(options, choice.setting);
    if (quiet) return choice;
    const std::string head = "--target-error " + shortNumber(target) + ": ";
    tell(head + commandLine(choice.setting));
    tell(head + "the error is about " + shortNumber(choice.sampleError) + " between samples and " +
         shortNumber(choice.depthError) + " of the depth" + (choice.reached ? "" : ": not reached"));
    return choice;
}

TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command) {
    const TimeChoice choice = chooseForTime(renderer, options, seconds);
    options = withSetting(options, choice.setting);
    if (command.empty()) return choice;
    Setting told = choice.setting;
    told.bilinear = false;  // the command says it already
    tell("--target-time: about " + shortNumber(choice.seconds) + " s more; the error is about " +
         shortNumber(choice.sampleError) + " between samples and " + shortNumber(choice.depthError) +
         " of the depth");
    tell("--target-time: the same picture again: " + command + " " + commandLine(told));
    return choice;
}

}  // namespace raytracer::commands
