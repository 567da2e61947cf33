#include "target_error.h"

#include <cstdio>
#include <string>

namespace raytracer::commands {

TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target) {
    const TargetChoice choice = chooseSetting(renderer, options, target);
    options = withSetting(options, choice.setting);
    std::fprintf(stderr, "--target-error %s: %s%s\n", shortNumber(target).c_str(),
                 commandLine(choice.setting).c_str(), choice.reached ? "" : "; the error is not reached");
    return choice;
}

}  // namespace raytracer::commands
