#include "raytracer/grading/grade_files.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "page.h"
#include "raytracer/util/html.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string number(double value, const char* format = "%.4g") {
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    return formatted(format, value);
}

std::string fixedScore(double value) { return formatted("%.1f", value); }

std::string percent(double part, int whole) { return number(100 * part / whole, "%.3f") + "%"; }

// A ring that marks the worst pixel, which is hard to see in a small picture.
std::string ring(const GradeResult& result) {
    const auto& c = result.comparison;
    if (!c || c->maximum == 0) return {};
    const std::string left = percent(c->worstX + 0.5, c->width), top = percent(c->worstY + 0.5, c->height);
    return "<i style=\"left:" + left + ";top:" + top + "\"></i>";
}

// A picture, as a button that opens it. `key` is that of a picture on a shelf, whose address the script
// knows. `overlay` is shown over the picture, or in its place if there is none.
std::string picture(const char* kind, const std::string& png, const std::string& key,
                    const std::string& overlay = {}) {
    if (png.empty() && key.empty())
        return "<div class=\"picture\"><span class=\"none\">" + overlay + "</span>" + kind + "</div>\n";
    return std::string("<button class=\"picture\" data-kind=\"") + kind + "\"><span><img alt=\"" + kind +
           "\" decoding=\"async\"" +
           (key.empty() ? attribute("src", pngUri(png)) : attribute("data-picture", key)) + ">" + overlay +
           "</span>" + kind + "</button>\n";
}

std::string numberRow(const char* name, const std::string& value) {
    return std::string("<dt>") + name + "</dt><dd>" + value + "</dd>";
}

std::string numbers(const GradeResult& result) {
    std::string html = "<dl>";
    if (const auto& c = result.comparison) {
        html += numberRow("size", std::to_string(c->width) + " × " + std::to_string(c->height));
        html += numberRow("pixels off", std::to_string(c->pixelsOver(0)));
        html += numberRow("by over 1", std::to_string(c->pixelsOver(1)));
        html += numberRow("by over 8", std::to_string(c->pixelsOver(8)));
        html += numberRow("speckle", std::to_string(c->speckle));
        html += numberRow("mean", number(c->mean));
        html += numberRow("RMSE", number(c->rmse));
        html += numberRow("PSNR", number(c->psnr) + " dB");
        const std::string place =
            " at (" + std::to_string(c->worstX) + ", " + std::to_string(c->worstY) + ")";
        html += numberRow("maximum", number(c->maximum) + (c->maximum > 0 ? place : ""));
    }
    if (result.seconds > 0) html += numberRow("time", number(result.seconds, "%.2f") + " s");
    return html + "</dl>\n";
}

// The options with which `explain` shows the stage's light.
std::string optionsOf(const Stage& stage) {
    return stage.only.empty() ? "" : " --only " + std::string(stage.only);
}

std::string message(const GradeResult& result) {
    std::string html;
    for (const std::string& text : {result.message, result.note})
        if (!text.empty()) html += "<p class=\"message\">" + escaped(text) + "</p>\n";
    if (!result.message.empty() && !result.output.empty())
        html += "<pre>" + escaped(result.output) + "</pre>\n";
    return html;
}

// The mistake, and the command that explains the worst pixel.
std::string mistake(const GradeResult& result) {
    std::string html;
    if (!result.sentence.empty()) html += "<p class=\"mistake\">" + escaped(result.sentence) + "</p>\n";
    const auto& c = result.comparison;
    if (!c || c->maximum == 0) return html;
    const std::string command =
        result.path.empty() ? formatted(" %d %d %d", c->worstX, c->worstY, std::max(c->width, c->height))
                            : escaped(" --picture " + inShellQuotes(result.path));
    return html + "<p class=\"why\">worst pixel: graded " + rgbInWords(result.ourWorst.data()) +
           ", reference " + rgbInWords(result.referenceWorst.data()) + "; why: <code>raytracer explain " +
           escaped(inShellQuotes(result.test.scene)) + command + escaped(optionsOf(*result.test.stage)) +
           "</code></p>\n";
}

// Attributes for the script: what it sorts by, and the pixel that it shows first.
std::string attributes(const GradeResult& result) {
    std::string html =
        attribute("data-name", result.test.name) + attribute("data-group", result.test.group) +
        attribute("data-score", std::to_string(result.score())) +
        attribute("data-error", number(result.comparison ? result.comparison->rmse : 256, "%.9g"));
    if (const auto& c = result.comparison)
        html += attribute("data-worst", std::to_string(c->worstX) + "," + std::to_string(c->worstY));
    return html;
}

// The card's class: "same", "off", or "near" for a different picture with a score of 100.
std::string verdict(const GradeResult& result, const Thresholds& thresholds) {
    if (within(result, thresholds)) return "same";
    return result.score() == 100 ? "near" : "off";
}

// The text in place of a graded picture that is missing.
std::string absence(const GradeResult& result) {
    if (result.comparison) return {};
    return result.isUnreadable ? "not comparable" : "no picture";
}

std::string card(const GradeResult& result, const Thresholds& thresholds) {
    return "<article class=\"" + verdict(result, thresholds) + "\"" + attributes(result) + ">\n<header><h3>" +
           escaped(result.test.name) + "</h3><output title=\"the autograder's score, of 100\">" +
           std::to_string(result.score()) + "</output></header>\n<div class=\"pictures\">" +
           picture("reference", result.referencePng, result.keys.reference) +
           picture("graded", result.ourPng, result.keys.ours, absence(result)) +
           picture("difference", result.differencePng, result.keys.difference,
                   result.comparison ? ring(result) : "none") +
           "</div>\n" + numbers(result) + mistake(result) + message(result) + "</article>\n";
}

using Group = std::vector<const GradeResult*>;

// The results in groups, the worst first. Groups are sorted by their worst members.
std::vector<Group> groupsOf(std::span<const GradeResult> results) {
    Group sorted;
    for (const GradeResult& result : results) sorted.push_back(&result);
    std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return isWorse(*a, *b); });
    std::vector<Group> groups;
    std::map<std::string, std::size_t> place;
    for (const GradeResult* result : sorted) {
        const auto [known, isNew] = place.emplace(result->test.group, groups.size());
        if (isNew) groups.emplace_back();
        groups[known->second].push_back(result);
    }
    return groups;
}

// The cards of some results, in groups.
std::string sections(std::span<const GradeResult> results, const Thresholds& thresholds) {
    std::string html;
    for (const Group& group : groupsOf(results)) {
        html += "<section>";
        if (group.size() > 1) html += "<h2>" + escaped(group.front()->test.group) + "</h2>";
        html += "\n";
        for (const GradeResult* result : group) html += card(*result, thresholds);
        html += "</section>\n";
    }
    return html;
}

std::string summary(const GradedSubmission& graded, const Thresholds& thresholds) {
    return "<p class=\"summary\"><b>" + std::to_string(graded.rightCount(thresholds)) + "</b> of <b>" +
           std::to_string(graded.results.size()) + "</b> pictures as the reference, mean score <b>" +
           fixedScore(graded.mean()) + "</b></p>\n";
}

}  // namespace

std::string gradeReport(const GradedSubmission& graded, const Thresholds& thresholds,
                        const std::string& title) {
    std::string html = pageHead(title, grading_page::style) + "<header class=\"page\"><h1>" + escaped(title) +
                       "</h1>\n" + summary(graded, thresholds) + grading_page::controls +
                       "</header>\n<main>\n";
    return html + sections(graded.results, thresholds) + "</main>\n" + grading_page::viewer + "<script>\n" +
           grading_page::script + "</script>\n</body>\n</html>\n";
}

namespace {

std::string overviewRow(const GradedSubmission& submission, const Thresholds& thresholds,
                        std::size_t number) {
    const std::size_t right = submission.rightCount(thresholds), all = submission.results.size();
    const GradeResult& worst = submission.worst();
    const std::string worstName =
        right == all ? "" : worst.test.name + " (" + std::to_string(worst.score()) + ")";
    return "<tr class=\"" + std::string(right == all ? "same" : "off") + "\"" +
           attribute("data-name", submission.name) +
           attribute("data-template", "s" + std::to_string(number)) + "><th scope=\"row\"><a>" +
           escaped(submission.name) + "</a></th><td>" + fixedScore(submission.mean()) + "</td><td>" +
           std::to_string(right) + " of " + std::to_string(all) + "</td><td>" + escaped(worstName) +
           "</td><td>" + escaped(submission.remarks(thresholds)) + "</td></tr>\n";
}

std::string classSummary(std::span<const GradedSubmission> graded, const Thresholds& thresholds) {
    double sum = 0;
    std::size_t right = 0;
    for (const GradedSubmission& submission : graded) {
        sum += submission.mean();
        right += submission.rightCount(thresholds) == submission.results.size();
    }
    return "<p class=\"summary\"><b>" + std::to_string(right) + "</b> of <b>" +
           std::to_string(graded.size()) +
           "</b> submissions have all pictures as the reference, mean score <b>" +
           fixedScore(sum / static_cast<double>(graded.size())) + "</b></p>\n";
}

}  // namespace

std::string classReport(std::span<const GradedSubmission> graded, const Thresholds& thresholds,
                        const std::string& title, const PictureShelf& shelf) {
    std::vector<const GradedSubmission*> sorted;
    for (const GradedSubmission& submission : graded) sorted.push_back(&submission);
    std::ranges::stable_sort(sorted, {},
                             [](const GradedSubmission* submission) { return submission->mean(); });
    std::string rows, templates;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        rows += overviewRow(*sorted[i], thresholds, i);
        templates += "<template id=\"s" + std::to_string(i) + "\">\n" +
                     sections(sorted[i]->results, thresholds) + "</template>\n";
    }
    return pageHead(title, grading_page::style) + "<header class=\"page\"><h1>" + escaped(title) + "</h1>\n" +
           classSummary(graded, thresholds) + "<div id=\"opened\" hidden>" + grading_page::controls +
           "</div></header>\n" + grading_page::overviewHead + rows + grading_page::overviewTail +
           "<main></main>\n" + templates + grading_page::viewer +
           "<script type=\"application/json\" id=\"addresses\">" + shelf.addresses() +
           "</script>\n<script>\n" + grading_page::script + "</script>\n</body>\n</html>\n";
}

}  // namespace raytracer
