#include "arguments.h"

#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/memory.h"

namespace raytracer::commands {

void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm) {
    const PixelRectangle band = largestBand(crop, isPfm);
    const std::string pixels = pixelsInWords(band.width(), band.height());
    if (isPfm) return requireMemory(file, {{pixels, 3 * sizeof(float) * band.area()}});
    // The rows as they are filtered, and their compressed form.
    requireMemory(file, {{pixels, 3 * band.area()}, {"the PNG", 6 * band.area()}});
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
