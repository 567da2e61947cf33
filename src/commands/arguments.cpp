#include "arguments.h"

namespace raytracer::commands {

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
