#include "raytracer/grading/grade_files.h"

#include <algorithm>

#include "raytracer/json/json_writer.h"
#include "raytracer/util/html.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string fixed(double value, int digits) { return formatted("%.*f", digits, value); }

std::string junitCase(const GradedSubmission& submission, const GradeResult& result,
                      const Thresholds& thresholds) {
    std::string xml = "    <testcase" + attribute("classname", submission.name) +
                      attribute("name", result.test.name) + attribute("time", fixed(result.seconds, 3));
    if (within(result, thresholds)) return xml + "/>\n";
    const char* const kind = result.comparison ? "failure" : "error";
    const std::string message =
        "score " + std::to_string(result.score()) + (remark(result).empty() ? "" : ": ") + remark(result);
    return xml + ">\n      <" + kind + attribute("message", message) + attribute("type", kind) + ">" +
           escaped(result.output) + "</" + kind + ">\n    </testcase>\n";
}

struct JunitCounts {
    std::size_t tests = 0, failures = 0, errors = 0;
    double seconds = 0;

    void add(const GradedSubmission& submission, const Thresholds& thresholds) {
        for (const GradeResult& result : submission.results) {
            ++tests;
            errors += !result.comparison;
            failures += result.comparison && !within(result, thresholds);
            seconds += result.seconds;
        }
    }

    std::string attributes() const {
        return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
               attribute("errors", std::to_string(errors)) + attribute("time", fixed(seconds, 3));
    }
};

void writePicture(JsonWriter& json, const GradeResult& result, const Thresholds& thresholds) {
    json.beginObject();
    json.key("picture").value(result.test.name);
    json.key("score").value(result.score());
    json.key("right").value(within(result, thresholds));
    if (result.comparison) json.key("differing").value(result.comparison->pixelsOver(0));
    else json.key("differing").null();
    json.key("message").value(printable(result.message.empty() ? result.note : result.message));
    json.key("output").value(printable(result.output, "\n"));
    json.key("mistakes").values(result.mistakes);
    json.key("sentence").value(result.sentence);
    json.key("seconds").value(result.seconds);
    json.key("processor_seconds").value(result.processorSeconds);
    json.endObject();
}

std::string outputFor(const GradeResult& result) {
    std::string text = remark(result);
    if (const auto& c = result.comparison; c && text.empty() && c->pixelsOver(0) > 0)
        text = std::to_string(c->pixelsOver(0)) + " pixels differ";
    if (!result.message.empty() && !result.output.empty()) text += "\n" + printable(result.output, "\n");
    return text.empty() ? "as the reference" : text;
}

// The last line of the program's output, which mostly says what went wrong.
std::string lastWords(const GradeResult& result) {
    const std::string& text = result.output;
    const std::size_t end = text.find_last_not_of(" \r\n\t");
    if (result.message.empty() || end == std::string::npos) return "";
    const std::size_t newline = text.find_last_of("\r\n", end);
    const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
    return text.substr(start, end + 1 - start);
}

}  // namespace

std::string gradeTableHead() {
    return formatted("%5s %9s %9s %9s %9s %9s  %s\n", "score", "off", "by > 1", "by > 8", "speckle",
                     "seconds", "picture");
}

std::string gradeTableRow(const GradeResult& result) {
    const auto count = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::string row = formatted("%5d %49.2f  ", 0, result.seconds);
    if (const auto& c = result.comparison)
        row = formatted("%5d %9llu %9llu %9llu %9llu %9.2f  ", c->score, count(c->pixelsOver(0)),
                        count(c->pixelsOver(1)), count(c->pixelsOver(8)), count(c->speckle), result.seconds);
    const std::string message = result.message.empty() ? "" : ": " + result.message;
    row += printable(result.test.name + message) + "\n";
    const std::string below(59, ' ');  // two columns to the right of the picture's name
    for (const std::string& line : {result.sentence, lastWords(result)})
        if (!line.empty()) row += below + line + "\n";
    return row;
}

std::string gradeSummary(const GradedSubmission& graded, const GradePlan& plan,
                         const Thresholds& thresholds) {
    std::string summary = formatted("%zu of %zu pictures as the reference, mean score %.1f\n",
                                    graded.rightCount(thresholds), graded.results.size(), graded.mean());
    for (const std::string& scene : plan.scenesWithoutReference)
        summary += "no reference: " + printable(scene) + "\n";
    return summary;
}

namespace {

// The text, padded to this many columns of a terminal.
std::string padded(std::string text, std::size_t width) {
    text.append(width - std::min(width, columnCount(text)), ' ');
    return text;
}

// The worst of the pictures that were handed in, in words; empty if none is wrong.
std::string worstOf(const GradedSubmission& submission, const Thresholds& thresholds) {
    const GradeResult* worst = nullptr;
    for (const GradeResult& result : submission.results)
        if (!result.isMissing && !within(result, thresholds) && (!worst || isWorse(result, *worst)))
            worst = &result;
    if (!worst || submission.results.size() == 1) return {};
    return "; worst: " + worst->test.name + formatted(" (%d)", worst->score());
}

}  // namespace

std::string classTable(std::span<const GradedSubmission> graded, const Thresholds& thresholds) {
    std::size_t width = 10;
    for (const GradedSubmission& submission : graded)
        width = std::max(width, columnCount(printable(submission.name)));
    std::string table = " mean   right  " + padded("submission", width) + "  what is wrong\n";
    for (const GradedSubmission& submission : graded) {
        const std::size_t right = submission.rightCount(thresholds), all = submission.results.size();
        const std::string name = printable(submission.name);
        const std::string remarks =
            printable(submission.remarks(thresholds) + worstOf(submission, thresholds));
        table += formatted("%5.1f %3zu/%-3zu  ", submission.mean(), right, all) +
                 (remarks.empty() ? name : padded(name, width) + "  " + remarks) + "\n";
    }
    return table;
}

std::string remark(const GradeResult& result) {
    return joined({result.message, result.note, result.sentence}, "; ");
}

std::string gradesAsCsv(std::span<const GradedSubmission> graded, const Thresholds& thresholds) {
    std::string csv = "submission";
    if (!graded.empty())
        for (const GradeResult& result : graded.front().results) csv += "," + csvField(result.test.name);
    csv += ",mean,mistake\r\n";
    for (const GradedSubmission& submission : graded) {
        csv += csvField(submission.name);
        for (const GradeResult& result : submission.results) csv += "," + std::to_string(result.score());
        csv += "," + fixed(submission.mean(), 1) + "," + csvField(submission.remarks(thresholds)) + "\r\n";
    }
    return csv;
}

std::string gradesAsJson(std::span<const GradedSubmission> graded, const Thresholds& thresholds) {
    JsonWriter json;
    json.beginObject();
    json.key("submissions").array(graded, [&](const GradedSubmission& submission) {
        json.beginObject();
        json.key("submission").value(printable(submission.name));
        json.key("mean").value(submission.mean());
        json.key("right").value(submission.rightCount(thresholds));
        json.key("mistake").value(printable(submission.remarks(thresholds)));
        json.key("pictures").array(submission.results, [&](const GradeResult& result) {
            writePicture(json, result, thresholds);
        });
        json.endObject();
    });
    json.endObject();
    return json.text() + "\n";
}

std::string gradesAsJunit(std::span<const GradedSubmission> graded, const Thresholds& thresholds) {
    JunitCounts all;
    std::string suites;
    for (const GradedSubmission& submission : graded) {
        JunitCounts own;
        own.add(submission, thresholds);
        all.add(submission, thresholds);
        suites += "  <testsuite" + attribute("name", submission.name) + own.attributes() + ">\n";
        for (const GradeResult& result : submission.results)
            suites += junitCase(submission, result, thresholds);
        suites += "  </testsuite>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "raytracer grade") +
           all.attributes() + ">\n" + suites + "</testsuites>\n";
}

std::string gradesForGradescope(const GradedSubmission& graded, const Thresholds& thresholds, double points) {
    JsonWriter json;
    const double share = points / 100;
    json.beginObject();
    json.key("score").value(share * graded.mean() * static_cast<double>(graded.results.size()));
    json.key("execution_time").value(graded.seconds());
    json.key("output").value(printable(graded.fault(thresholds)));
    json.key("output_format").value("text");
    json.key("visibility").value("visible");
    json.key("tests").array(graded.results, [&](const GradeResult& result) {
        json.beginObject();
        json.key("name").value(printable(result.test.name));
        json.key("score").value(share * result.score());
        json.key("max_score").value(points);
        json.key("status").value(within(result, thresholds) ? "passed" : "failed");
        json.key("output").value(outputFor(result));
        json.key("output_format").value("text");
        json.key("extra_data").beginObject();
        json.key("execution_time").value(result.seconds);
        json.endObject();
        json.endObject();
    });
    json.endObject();
    return json.text() + "\n";
}

}  // namespace raytracer
