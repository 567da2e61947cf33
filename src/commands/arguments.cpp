#include "arguments.h"

#include "raytracer/util/memory.h"

namespace raytracer::commands {

void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm) {
    const std::string pixels = pixelsInWords(crop.width(), crop.height());
    if (isPfm) return requireMemory(file, {{pixels, 3 * sizeof(float) * crop.area()}});
    if (!fitsPng(crop.width(), crop.height()))
        throw Error({file}, pixels + " are too many for a PNG: take a part with --crop, or write a .pfm");
    // The rows as they are filtered, and their compressed form.
    requireMemory(file, {{pixels, 3 * crop.area()}, {"the PNG", 6 * crop.area()}});
}

void addThreads(CommandLine& line, int& threads) {
    line.number("--threads", threads, {0, 4096}, "Number of threads; 0: one for each processor");
}

void addThresholds(CommandLine& line, Thresholds& thresholds) {
    line.number("--max-pixels", thresholds.maxPixels, atLeast(0),
                "Exit status 1 where more pixels than this differ; without it: 0");
    line.number("--tolerance", thresholds.tolerance, {0, 255},
                "For --max-pixels, a pixel differs where a channel is off by more than this; without it: 0");
    line.number("--min-score", thresholds.minScore, {0, 100},
                "Exit status 1 where the score is lower; alone, only the score decides");
}

}  // namespace raytracer::commands
