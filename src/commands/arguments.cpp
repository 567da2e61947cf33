#include "arguments.h"

#include <algorithm>
#include <filesystem>

#include "raytracer/numerics/instruction_set.h"
#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace build {
extern const char* const version;  // made by cmake/version.cmake
extern const char* const commit;
extern const char* const sources;
}  // namespace build

}  // namespace raytracer

namespace raytracer::commands {

namespace {

namespace files = std::filesystem;

// Whether a path leads to the file or folder `place`, or into that folder; links and ".." are followed. False
// for devices, which may be shared.
bool leadsInto(const std::string& path, const std::string& place) {
    std::error_code error;
    if (files::exists(path, error) && !files::is_regular_file(path, error) &&
        !files::is_directory(path, error))
        return false;
    if (files::equivalent(path, place, error)) return true;
    const auto whole = [&](const std::string& name) {
        return files::weakly_canonical(files::absolute(name, error), error);
    };
    const files::path wholePath = whole(path), wholePlace = whole(place);
    return !wholePlace.empty() && std::ranges::mismatch(wholePlace, wholePath).in1 == wholePlace.end();
}

Error alsoRead(const std::string& out) {
    return Error(printable(out) + " is read, too: give another name for what is written");
}

}  // namespace

void refuseInput(const std::string& out, std::span<const std::string> inputs) {
    if (out.empty()) return;
    for (const std::string& input : inputs)
        if (!input.empty() && leadsInto(input, out)) throw alsoRead(out);
}

void refuseInside(const std::string& out, std::span<const std::string> folders) {
    if (out.empty()) return;
    for (const std::string& folder : folders)
        if (leadsInto(out, folder)) throw alsoRead(out);
}

void refuseSameOutput(std::span<const std::string> outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (const std::string& other : outputs.subspan(i + 1))
            if (!outputs[i].empty() && !other.empty() && leadsInto(outputs[i], other))
                throw Error(printable(other) + " is written twice: give each file its own name");
}

void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm) {
    const PixelRectangle band = largestBand(crop, isPfm);
    const std::string pixels = pixelsInWords(band.width(), band.height());
    if (isPfm) return requireMemory(file, pixels, 3 * sizeof(float) * static_cast<double>(band.area()));
    // The pixels' bytes, the filtered bytes and the compressed ones: three bytes each per pixel.
    requireMemory(file, pixels, 9 * static_cast<double>(band.area()));
}

bool isPictureName(const std::string& name) { return endsIn(name, ".png") || endsIn(name, ".pfm"); }

std::string comparisonMeant(std::span<const std::string> arguments) {
    if (arguments.size() != 2 || !std::ranges::all_of(arguments, isPictureName)) return {};
    return arguments[0] + " is a picture; write raytracer compare " + arguments[0] + " " + arguments[1];
}

void addSilence(CommandLine& line, bool& quiet) {
    line.flag("--quiet", quiet, "Print nothing but errors: the exit status and the files tell");
}

void addThreads(CommandLine& line, int& threads) {
    line.number("--threads", threads, {0, 4096}, "Number of threads; 0: one for each processor");
}

void addThresholds(CommandLine& line, Thresholds& thresholds) {
    line.number("--max-pixels", thresholds.maxPixels, atLeast(0),
                "Exit status 1 where more pixels than this differ; without it: 0");
    line.number("--tolerance", thresholds.tolerance, {0, 255},
                "A pixel differs where a channel is off by more than this; without it: 0");
    line.number("--min-score", thresholds.minScore, {0, 100},
                "Exit status 1 where the score is lower; alone, only the score decides");
}

std::string versionText() {
    std::vector<std::string> sets;
    for (const InstructionSet set : supportedInstructionSets()) sets.emplace_back(nameOf(set));
    return std::string("raytracer ") + build::version + " (" + build::commit +
           ")\ninstruction sets: " + joined(sets, ", ") +
           "; used: " + std::string(nameOf(defaultInstructionSet())) +
           "\nprecisions: float, double, extended\n";
}

std::string programVersion() { return std::string(build::version) + " (sources " + build::sources + ")"; }

}  // namespace raytracer::commands
