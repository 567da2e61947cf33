#include "render_report.h"

#include <cmath>

#include "raytracer/accuracy/setting.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "render_cost.h"

namespace raytracer::commands {

namespace {

void printTimes(JsonWriter& json, const Timings& timings, const char* name, double Seconds::*kind) {
    json.key(name).beginObject();
    json.key("load").value(timings.load.*kind);
    json.key("build").value(timings.build.*kind);
    json.key("choose").value(timings.choose.*kind);
    json.key("render").value(timings.render.*kind);
    json.key("write").value(timings.write.*kind);
    json.endObject();
}

// Estimates, without bias: that of the samples may be zero or below where there is an error.
std::string errorInWords(double ofSamples, double ofDepth) {
    if (ofSamples == 0)
        return "pilot samples show no error for want of samples; for want of depth it is about " +
               shortNumber(ofDepth);
    return "the error is about " + shortNumber(ofSamples) + " for want of samples and " +
           shortNumber(ofDepth) + " for want of depth";
}

std::string whyNotReached(const TargetChoice& choice, double target) {
    if (choice.isLimited) return "perhaps not reached: deeper rays are too many to follow";
    if (std::hypot(choice.sampleError, choice.depthError) <= target)
        return "perhaps not reached: the pilot samples are too few to tell";
    return formatted("not reached: %d samples are too few", choice.setting.samples);
}

}  // namespace

void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options) {
    JsonWriter json;
    json.beginObject();
    json.key("width").value(options.crop.width());
    json.key("height").value(options.crop.height());
    json.key("rays").beginObject();
    json.key("primary").value(counts.primary);
    json.key("shadow").value(counts.shadow);
    json.key("reflection").value(counts.reflection);
    json.key("refraction").value(counts.refraction);
    json.endObject();
    json.key("intersection_tests").value(counts.tests);
    json.key("limited_pixels").value(counts.limited);
    json.key("cutoff_bound").value(counts.cutoffBound);
    printTimes(json, timings, "seconds", &Seconds::wall);
    printTimes(json, timings, "cpu_seconds", &Seconds::cpu);
    json.key("peak_memory_bytes").value(peakMemoryBytes());
    json.endObject();
    print(json.text() + "\n");
}

void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels) {
    const auto limited = static_cast<double>(counts.limited);
    if (limited <= 0.001 * pixels) return;
    tell(formatted("--samples %d stopped %.3g %% of the pixels before their error was --adaptive %s",
                   options.samples, 100 * limited / pixels, shortNumber(options.adaptive).c_str()));
}

void tellDone(const std::string& out, const PixelRectangle& crop, double seconds, bool quiet) {
    if (quiet || terminalColumns() == 0) return;
    tell(formatted("%s: %d × %d, %s", out.c_str(), crop.width(), crop.height(),
                   durationInWords(seconds).c_str()));
}

TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, bool quiet) {
    const std::string head = "--target-error " + shortNumber(target) + ": ";
    std::optional<TerminalLine> line;
    if (!quiet) line.emplace();
    TargetChoice choice = chooseSetting(renderer, options, target, [&](std::uint64_t samples) {
        if (line)
            line->show(head + formatted("searching, %.3g million samples so far",
                                        static_cast<double>(samples) / 1e6));
    });
    line.reset();
    options = withSetting(options, choice.setting);
    if (quiet) return choice;
    tell(head + commandLine(choice.setting));
    tell(head + errorInWords(choice.sampleError, choice.depthError));
    if (!choice.reached) tell(head + whyNotReached(choice, target));
    return choice;
}

TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command) {
    const TimeChoice choice = chooseForTime(renderer, options, seconds);
    options = withSetting(options, choice.setting);
    if (command.empty()) return choice;
    Setting told = choice.setting;
    told.bilinear = false;  // the command says it already
    tell("--target-time: the expected time is " + durationInWords(choice.seconds) +
         (choice.seconds > seconds ? "; no setting takes less" : ""));
    tell("--target-time: " + errorInWords(choice.sampleError, choice.depthError));
    tell("--target-time: the same picture again:");
    tellUnbroken(command + " " + commandLine(told));
    return choice;
}

}  // namespace raytracer::commands
