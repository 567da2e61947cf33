#include <algorithm>

#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string csvLine(const std::string& scene, const char* question, const Trial& t) {
    const Setting& s = t.setting;
    return csvField(scene) +
           formatted(",%s,%s,%d,%g,%d,%g,%s,%.6f,%zu,", question, precisionName(t.precision), s.samples,
                     s.adaptive, s.max_recursion, s.cutoff, s.bilinear ? "bilinear" : "nearest", t.seconds(),
                     t.timings.size()) +
           formatted("%llu,%llu,%llu,%llu,%llu,%.6g,", static_cast<unsigned long long>(t.counts.primary),
                     static_cast<unsigned long long>(t.counts.shadow),
                     static_cast<unsigned long long>(t.counts.reflection),
                     static_cast<unsigned long long>(t.counts.refraction),
                     static_cast<unsigned long long>(t.counts.tests), t.counts.cutoffBound) +
           formatted("%.6g,%.4f,%.6g,%.6g,%d\n", t.error.rmse, t.error.psnr, t.error.maximum,
                     t.error.shareOff, t.onFront);
}

std::string tableLine(const Trial& t, double defaultSeconds) {
    return formatted("  %9.4f %7.2f  %9.2e %7.2f %9.2e %7.2f  %s\n", t.seconds(),
                     t.seconds() / defaultSeconds, t.error.rmse, t.error.psnr, t.error.maximum,
                     100 * t.error.shareOff, commandLine(t.setting, t.precision).c_str());
}

}  // namespace

double defaultSeconds(const SceneTradeoff& scene) {
    return std::ranges::find(scene.truncation, Setting{}, &Trial::setting)->seconds();
}

std::string tradeoffCsv(std::span<const SceneTradeoff> scenes) {
    std::string csv =
        "scene,question,precision,samples,adaptive,max_recursion,cutoff,texture_filter,seconds,timings,"
        "primary_rays,shadow_rays,reflection_rays,refraction_rays,intersection_tests,cutoff_bound,"
        "rmse,psnr,maximum,share_off,on_front\n";
    for (const SceneTradeoff& scene : scenes) {
        for (const Trial& trial : scene.truncation) csv += csvLine(scene.name, "truncation", trial);
        for (const Trial& trial : scene.arithmetic) csv += csvLine(scene.name, "arithmetic", trial);
    }
    return csv;
}

std::string describeReference(const SceneTradeoff& scene) {
    const Reference& reference = scene.reference;
    const std::string cutoff =
        reference.setting.cutoff > 0
            ? formatted("its cutoff changed no pixel by more than %.1g", reference.cutoffBound)
            : "no cutoff";
    const std::string rate =
        scene.sampleRate ? formatted(" The sampling error falls like samples^-%.2f.", *scene.sampleRate) : "";
    return formatted(
               "%d x %d pixels. Reference: %s, samples of its own; %s. %d others give an RMSE of "
               "%.1e against it: its own error is smaller.",
               scene.size.width, scene.size.height, commandLine(reference.setting).c_str(), cutoff.c_str(),
               reference.half.samples, reference.doublingError) +
           rate;
}

std::string tradeoffTable(const SceneTradeoff& scene) {
    const double base = defaultSeconds(scene);
    std::string text = printable(scene.name) + ": " + describeReference(scene) + "\n";
    text += "    seconds   times       RMSE    PSNR   maximum  % off  of the front, against the reference\n";
    for (const Trial& trial : scene.truncation)
        if (trial.onFront) text += tableLine(trial, base);
    text += "  arithmetic, against the same samples in extended precision\n";
    for (const Trial& trial : scene.arithmetic) text += tableLine(trial, base);
    return text;
}

}  // namespace raytracer
