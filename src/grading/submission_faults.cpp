// Sums up what is wrong with a submission as a whole.
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "raytracer/grading/submissions.h"
#include "raytracer/util/text.h"

namespace raytracer {

std::string Rendered::butInstead() const { return instead.empty() ? "" : ", but " + instead; }

double GradedSubmission::mean() const {
    const double sum =
        std::accumulate(results.begin(), results.end(), 0.0,
                        [](double total, const GradeResult& result) { return total + result.score(); });
    return results.empty() ? 0 : sum / static_cast<double>(results.size());
}

std::size_t GradedSubmission::rightCount(const Thresholds& thresholds) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        results, [&](const GradeResult& result) { return within(result, thresholds); }));
}

const GradeResult& GradedSubmission::worst() const { return *std::ranges::min_element(results, isWorse); }

double GradedSubmission::seconds() const {
    return std::accumulate(results.begin(), results.end(), 0.0,
                           [](double total, const GradeResult& result) { return total + result.seconds; });
}

namespace {

// "a, b and 3 more are missing, but a.jpg is there"; empty if no picture is missing.
std::string missingPictures(const std::vector<GradeResult>& results) {
    constexpr std::size_t most = 3;  // entries of the list; if there are more, the last is "N more"
    std::vector<std::string> names;
    for (const GradeResult& result : results)
        if (result.isMissing) names.push_back(result.test.name);
    if (names.empty()) return {};
    const std::size_t count = names.size();
    const auto with = std::ranges::find_if_not(results, &std::string::empty, &GradeResult::instead);
    if (count > most) {
        names.resize(most - 1);
        names.push_back(std::to_string(count - names.size()) + " more");
    }
    return listed(names, "and") + (count == 1 ? " is missing" : " are missing") +
           (with == results.end() ? "" : with->butInstead());
}

// The message without what differs from picture to picture: numbers ("too slow: 2.1 s" and "too slow: 2.2 s"
// are one fault), and the name of what is there instead.
std::string commonPart(const GradeResult& result) {
    const std::string but = result.butInstead();
    std::string message = result.message;
    if (message.ends_with(but)) message.resize(message.size() - but.size());
    std::erase_if(message, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    return message;
}

// A fault, and the number of wrong pictures that have it.
struct Fault {
    std::string key, text;
    std::size_t pictures = 0;
};

class FaultCount {
  public:
    // `key` is the same for all pictures with the same fault.
    void add(const std::string& key, const std::string& text) {
        if (key.empty()) return;
        auto known = std::ranges::find(faults_, key, &Fault::key);
        if (known == faults_.end()) known = faults_.insert(known, {key, text});
        ++known->pictures;
    }

    // The fault with the most pictures; of several, the first. Null if there is none.
    const Fault* most() const {
        return faults_.empty() ? nullptr : &*std::ranges::max_element(faults_, {}, &Fault::pictures);
    }

  private:
    std::vector<Fault> faults_;
};

// The fault of wrong pictures that no mistake explains: rounding if all differ by that only.
std::string withoutMistake(const std::vector<const GradeResult*>& wrong) {
    FaultCount reasons;
    for (const GradeResult* result : wrong) reasons.add(result->unnamed, result->unnamed);
    if (const Fault* const most = reasons.most()) return most->text;
    std::uint64_t pixels = 0, byMore = 0;
    for (const GradeResult* result : wrong) {
        pixels += result->comparison->pixelsOver(0);
        byMore += result->comparison->pixelsOver(1);
    }
    return "rounding (" + std::to_string(pixels) + (pixels == 1 ? " pixel" : " pixels") +
           (byMore == 0 ? " by 1)" : ")");
}

// The fault of most of the wrong pictures. A picture that several mistakes explain counts for each of them,
// so that the one that explains other pictures too wins.
std::string mistakeOfMost(const std::vector<GradeResult>& results, const Thresholds& thresholds) {
    std::vector<const GradeResult*> wrong;
    FaultCount count;
    for (const GradeResult& result : results) {
        if (result.isMissing || within(result, thresholds)) continue;
        wrong.push_back(&result);
        if (!result.comparison) count.add(commonPart(result), result.message);
        for (const std::string& mistake : result.mistakes) count.add(mistake, mistake);
    }
    if (wrong.empty()) return {};
    const Fault* const most = count.most();
    if (!most) return withoutMistake(wrong);
    if (most->pictures == wrong.size()) return most->text;
    return most->text + " (" + std::to_string(most->pictures) + " of " + std::to_string(wrong.size()) +
           " wrong pictures)";
}

}  // namespace

std::string GradedSubmission::fault(const Thresholds& thresholds) const {
    if (isArchive) return toUnpack;
    return joined({mistakeOfMost(results, thresholds), missingPictures(results)}, "; ");
}

std::string GradedSubmission::remarks(const Thresholds& thresholds) const {
    std::string text = fault(thresholds);
    std::size_t notes = 0;
    for (const GradeResult& result : results)
        if (!result.note.empty() && notes++ == 0) text = joined({text, result.note}, "; ");
    if (notes > 1) text += " (so with " + std::to_string(notes) + " pictures)";
    return text;
}

}  // namespace raytracer
