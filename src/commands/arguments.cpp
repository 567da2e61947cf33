#include "arguments.h"

#include <cstdio>
#include <stdexcept>

#include "raytracer/pictures/image.h"
#include "raytracer/scene/scene_loader.h"

namespace raytracer::commands {

std::optional<int> parseArguments(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& end) {
        if (end.get_exit_code() == 0) return app.exit(end);
        std::fprintf(stderr, "%s: %s (%s --help tells more)\n", app.get_name().c_str(), end.what(),
                     app.get_name().c_str());
        return 2;
    }
    return std::nullopt;
}

int reportErrors(const std::function<int()>& command) {
    try {
        return command();
    } catch (const SceneError& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const ImageError& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "raytracer: %s\n", error.what());
    }
    return 2;
}

void addThresholds(CLI::App& app, Thresholds& thresholds) {
    app.add_option("--max-pixels", thresholds.maxPixels,
                   "Exit status 1 where more pixels than this differ (0)");
    app.add_option("--tolerance", thresholds.tolerance,
                   "A pixel differs for --max-pixels where a channel does by more than this, of 255 (0)")
        ->check(CLI::Range(0, 255));
    app.add_option("--min-score", thresholds.minScore,
                   "Exit status 1 where the score is lower; alone, it decides without regard to the pixels")
        ->check(CLI::Range(0, 100));
}

}  // namespace raytracer::commands
