#include "target_error.h"

#include <cstdio>
#include <string>

#include "raytracer/util/progress_bar.h"

namespace raytracer::commands {

namespace {

TargetChoice choose(const Renderer& renderer, const RenderOptions& options, double target, PixelSink& sink,
                    bool quiet) {
    if (quiet) return chooseSetting(renderer, options, target, sink);
    TerminalLine line;
    return chooseSetting(renderer, options, target, sink, [&](const TargetChoice& choice) {
        line.show("--target-error " + shortNumber(target) + ": so far " + commandLine(choice.setting) +
                  " with about " + shortNumber(choice.error) + " +- " + shortNumber(choice.standardError) +
                  "; looking at more pixels");
    });
}

}  // namespace

TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, PixelSink& sink,
                           bool quiet) {
    const TargetChoice choice = choose(renderer, options, target, sink, quiet);
    options = withSetting(options, choice.setting);
    std::string why = "the cheapest of those that reach " + shortNumber(target);
    if (!choice.reached) why = "the most accurate there is; nothing reaches " + shortNumber(target);
    if (choice.cheaper)
        why +=
            ": a cheaper one, " + commandLine(*choice.cheaper) + ", has " + shortNumber(choice.cheaperError);
    std::fprintf(stderr, "--target-error %s: %s, %s\n", shortNumber(target).c_str(),
                 commandLine(choice.setting).c_str(), why.c_str());
    std::fprintf(
        stderr,
        "--target-error %s: %s rays a pixel, found with %zu pixels and as many rays as %s a pixel%s\n",
        shortNumber(target).c_str(), shortNumber(choice.rays).c_str(), choice.pilotPixels,
        shortNumber(choice.pilotRays / options.crop.area()).c_str(),
        choice.rendered ? "; to find out, the picture was rendered" : "");
    return choice;
}

bool tellOutcome(const TargetChoice& choice, double target) {
    std::fprintf(stderr,
                 "--target-error %s: the error is about %s +- %s (%s between the samples, %s of rays not "
                 "followed)%s\n",
                 shortNumber(target).c_str(), shortNumber(choice.error).c_str(),
                 shortNumber(choice.standardError).c_str(), shortNumber(choice.sampleError).c_str(),
                 shortNumber(choice.depthError).c_str(), choice.reached ? "" : ": not reached");
    return choice.reached;
}

}  // namespace raytracer::commands
