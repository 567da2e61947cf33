#include "render_report.h"

#include <algorithm>
#include <cmath>

#include "raytracer/accuracy/ray_growth.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

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

// An estimate below `least` is not shown: it may only show that the pilot samples miss what makes the error.
std::string errorInWords(double estimate, double least) {
    return "estimated error " + (estimate < least ? "below " + shortNumber(least) : shortNumber(estimate));
}

std::string resultInWords(const TargetChoice& choice, double target) {
    const double estimate = std::hypot(choice.sampleError, choice.depthError);
    // The search stops near the target: a far smaller estimate is in doubt.
    std::string error = "reached: " + errorInWords(estimate, target / 10);
    if (choice.reached) return error;
    if (estimate > target)
        return "not " + error + formatted(" at --samples %d", choice.setting.samples) +
               (choice.setting.samples < mostSamples ? "; more is too slow" : ", the most");
    return "perhaps not " + error +
           (choice.isLimited ? "; deeper rays are too many" : " from too few pixels");
}

// "1,234,567".
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t digits = 3; digits < text.size(); digits += 4) text.insert(text.size() - digits, ",");
    return text;
}

constexpr double longTime = 60;  // seconds

class NoPicture final : public PixelSink {
    void write(int, int, std::span<const glm::dvec3>) override {}
};

// Estimates the seconds that the picture takes on one thread. It renders a number of tiles from all over the
// picture with fewer samples: one per pixel if all pixels have equally many. With --adaptive, a pixel's
// samples after the first are about inversely proportional to `adaptive` (PixelEstimate::error), up to its
// limit.
double timeOnOneThread(const Renderer& renderer, const RenderOptions& wanted) {
    constexpr int tiles = 64, samples = 64;  // 65,536 pixels: some milliseconds a sample
    constexpr double coarsest = 0.01;        // above it, many pixels would not take a second sample
    RenderOptions options = wanted;
    const double pixels = static_cast<double>(options.crop.area());
    options.part = {1, std::clamp(static_cast<int>(pixels / (tileEdge * tileEdge * tiles)), 1, mostParts)};
    options.threads = 1;
    const auto samplesTaken = [&](int most) {
        NoPicture sink;
        options.samples = most;
        return static_cast<double>(renderer.render(options, sink).primary);
    };
    const double first = samplesTaken(1);  // also fetches the scene into the caches
    const bool isAdaptive = wanted.adaptive > 0;
    const int limit = isAdaptive ? std::min(wanted.samples, samples) : 1;
    double fewer = static_cast<double>(wanted.samples) / limit;
    if (isAdaptive) fewer = std::clamp(coarsest / wanted.adaptive, 1.0, fewer);
    options.adaptive *= fewer;
    Stopwatch watch;
    const double taken = samplesTaken(limit), seconds = watch.lap().cpu;  // does not depend on other programs
    const double times = isAdaptive ? (first + (taken - first) * fewer) / taken : fewer;
    return seconds * times * options.part.count / wanted.part.count;
}

double brightest(const glm::dvec3& color) { return std::max({color.r, color.g, color.b}); }

// Whether a cutoff ends the doubling of rays: in every glass that reflects, one of the two new rays must
// contribute less than the one before.
bool canCutOff(const SceneDescription& scene) {
    return std::ranges::none_of(scene.materials, [](const auto& m) {
        return m.reflective && m.refractive &&
               std::min(brightest(m.color_reflect), brightest(m.color_refract)) >= 1;
    });
}

}  // namespace

void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options) {
    JsonWriter json;
    json.beginObject();
    json.key("width").value(options.crop.width());
    json.key("height").value(options.crop.height());
    json.key("setting").beginObject();  // the chosen one, where the program chooses
    json.key("samples").value(options.samples);
    json.key("adaptive").value(options.adaptive);
    json.key("max_recursion").value(options.max_recursion);
    json.key("cutoff").value(options.cutoff);
    json.key("texture_filter").value(options.bilinear ? "bilinear" : "nearest");
    json.endObject();
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

void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels, bool quiet) {
    const auto limited = static_cast<double>(counts.limited);
    if (quiet || limited <= 0.001 * pixels) return;
    tell(formatted("%.3g %% of the pixels would take more samples for --adaptive ", 100 * limited / pixels) +
         shortNumber(options.adaptive) + formatted(": --samples %d is too few", options.samples));
}

void tellDone(const std::string& out, const PixelRectangle& crop, double seconds, bool quiet) {
    if (quiet || terminalColumns() == 0) return;
    tell(formatted("%s: %d × %d, %s", out.c_str(), crop.width(), crop.height(),
                   durationInWords(seconds).c_str()));
}

void tellWaiting(bool quiet) {
    if (!quiet && terminalColumns() > 0) tell("waiting for a change; Ctrl+C ends");
}

TargetChoice chooseAndTell(const RenderArguments& arguments, const Renderer& renderer, RenderOptions& options,
                           double target) {
    const std::string head = "--target-error " + shortNumber(target) + ": ";
    std::optional<TerminalLine> line;
    if (!arguments.quiet) line.emplace();
    TargetChoice choice = chooseSetting(renderer, options, target, [&](std::uint64_t samples) {
        if (line) line->show(head + "searching, " + grouped(samples) + " samples so far");
    });
    line.reset();
    choice.setting = arguments.accepted(choice.setting);
    options = withSetting(options, choice.setting);
    if (arguments.quiet) return choice;
    tell(head + commandLine(choice.setting));
    tell(head + resultInWords(choice, target));
    return choice;
}

TimeChoice chooseForTimeAndTell(const RenderArguments& arguments, const Renderer& renderer,
                                RenderOptions& options, double seconds, const std::string& command) {
    TimeChoice choice = chooseForTime(renderer, options, seconds);
    choice.setting = arguments.accepted(choice.setting);
    options = withSetting(options, choice.setting);
    if (arguments.quiet) return choice;
    Setting told = choice.setting;
    told.bilinear = false;  // `command` has that option already
    // One wrong pixel, which is probably not among the pilots, makes this error.
    const double least = 1 / std::sqrt(static_cast<double>(options.crop.area()));
    tell("--target-time: " + errorInWords(std::hypot(choice.sampleError, choice.depthError), least) +
         ", expected time " + durationInWords(choice.seconds) +
         (choice.seconds > seconds ? "; no setting takes less" : ""));
    tell("--target-time: the same picture again:");
    tellUnbroken(told == Setting{} ? command : command + " " + commandLine(told));
    return choice;
}

std::string durationInWords(double seconds) {
    if (seconds < 0.01) return "under 0.01 s";
    if (seconds < 60) return formatted("%.2f s", seconds);
    if (seconds < 3600) return formatted("%.0f min", seconds / 60);
    if (seconds < 48 * 3600) return formatted("%.1f h", seconds / 3600);
    return formatted("%.1f days", seconds / 86400);
}

void remarkOnRays(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options) {
    if (arguments.quiet) return;
    const auto rays = excessiveRays(scene, renderer, options);
    if (!rays) return;
    const bool hasRemedy = options.cutoff <= 0 && canCutOff(scene);
    arguments.remark(formatted("--max-recursion %d takes about %.1g rays a sample; lower it%s",
                               options.max_recursion, *rays, hasRemedy ? ", or add a --cutoff" : ""));
}

void remarkOnFrames(const RenderArguments& arguments, int more, double secondsOfFirst) {
    const double seconds = more * secondsOfFirst;
    if (seconds >= longTime)
        arguments.remark(
            formatted(more == 1 ? "%d more frame takes about " : "%d more frames take about ", more) +
            durationInWords(seconds) + "; a smaller size takes less");
}

void remarkOnTime(const RenderArguments& arguments, const Renderer& renderer, const RenderOptions& options) {
    constexpr double few = 3e7;         // samples: in any of our scenes they take less than a minute
    constexpr int adaptiveSamples = 4;  // the least mean number of samples per pixel to reckon with
    if (arguments.quiet) return;
    const bool isAdaptive = options.adaptive > 0;
    const double samples = static_cast<double>(options.crop.area()) / options.part.count *
                           (isAdaptive ? std::min(options.samples, adaptiveSamples) : options.samples);
    if (samples < few) return;
    const double seconds = timeOnOneThread(renderer, options) / threadCount(options.threads);
    if (seconds < longTime) return;
    const bool isSampled = options.samples > 1 && !isAdaptive;
    arguments.remark(formatted("%d × %d pixels", options.crop.width(), options.crop.height()) +
                     (isSampled    ? formatted(" of %d samples", options.samples)
                      : isAdaptive ? formatted(" with --adaptive %g", options.adaptive)
                                   : "") +
                     " take about " + durationInWords(seconds) + "; " +
                     (isSampled ? "--adaptive 0.02 takes less" : "a smaller size takes less"));
}

}  // namespace raytracer::commands
