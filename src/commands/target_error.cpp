#include "target_error.h"

#include <cstdio>
#include <string>

namespace raytracer::commands {

TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target) {
    const TargetChoice choice = chooseSetting(renderer, options, target);
    options = withSetting(options, choice.setting);
    std::fprintf(stderr, "--target-error %s: %s\n", shortNumber(target).c_str(),
                 commandLine(choice.setting).c_str());
    std::fprintf(stderr, "--target-error %s: the error is about %s between samples and %s of the depth%s\n",
                 shortNumber(target).c_str(), shortNumber(choice.sampleError).c_str(),
                 shortNumber(choice.depthError).c_str(), choice.reached ? "" : ": not reached");
    return choice;
}

TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command) {
    const TimeChoice choice = chooseForTime(renderer, options, seconds);
    options = withSetting(options, choice.setting);
    Setting told = choice.setting;
    told.bilinear = false;  // the command says it already
    std::fprintf(stderr,
                 "--target-time: about %s s more; the error is about %s between samples and %s of the depth\n"
                 "--target-time: the same picture again: %s %s\n",
                 shortNumber(choice.seconds).c_str(), shortNumber(choice.sampleError).c_str(),
                 shortNumber(choice.depthError).c_str(), command.c_str(), commandLine(told).c_str());
    return choice;
}

}  // namespace raytracer::commands
