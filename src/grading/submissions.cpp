#include "raytracer/grading/submissions.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>

#include "programs.h"
#include "raytracer/util/error.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

namespace files = std::filesystem;

// Where a picture was found, or a file that may be meant instead; relative to the submission's folder.
struct FoundPicture {
    std::string path, note, instead;
};

// The files beneath a folder, by name in small letters: PNG files with their ending, others without; of each
// name the nearest to the top first, then by path.
using FilesByName = std::map<std::string, std::vector<std::pair<int, files::path>>>;

FilesByName filesBeneath(const std::string& folder) {
    FilesByName found;
    std::error_code error;
    files::recursive_directory_iterator entry(folder, files::directory_options::skip_permission_denied,
                                              error);
    for (const files::recursive_directory_iterator end; !error && entry != end; entry.increment(error))
        if (entry->symlink_status(error).type() == files::file_type::regular) {
            const files::path& path = entry->path();
            const files::path name = endsIn(path.string(), ".png") ? path.filename() : path.stem();
            found[inLowerCase(name.string())].emplace_back(entry.depth(), path.lexically_relative(folder));
        }
    for (auto& [name, places] : found) std::ranges::sort(places);
    return found;
}

// A reference X-raytracing.png is matched by X.png, too. Without the ending.
std::vector<std::string> fileNames(const GradeCase& test) {
    std::vector<std::string> names{test.name};
    const std::string ending = "-" + std::string(completeStage().name);
    if (test.name.ends_with(ending)) names.push_back(test.name.substr(0, test.name.size() - ending.size()));
    return names;
}

// What is odd about the picture that counts for this name, the first.
std::string noteOn(const std::string& name, const FilesByName::mapped_type& places) {
    const auto inside = [&](std::size_t i) { return places[i].second.string(); };
    if (places.size() > 1 && places[1].first == places[0].first)
        return name + " is there twice: " + inside(0) + " counts, not " + inside(1);
    return places[0].second.filename() == name ? "" : inside(0) + " counts as " + name;
}

FoundPicture findPicture(const FilesByName& files, const GradeCase& test) {
    FoundPicture found;
    for (const std::string& name : fileNames(test)) {
        const std::string png = name + ".png";
        const auto known = files.find(inLowerCase(png)), other = files.find(inLowerCase(name));
        if (known != files.end()) return {known->second[0].second.string(), noteOn(png, known->second), ""};
        if (other != files.end() && found.instead.empty()) found.instead = other->second[0].second.string();
    }
    return found;
}

std::string thereIs(const std::string& file) { return file.empty() ? "" : ", but " + file + " is there"; }

std::string commandOf(std::string program, const Submission& submission) {
    const std::string folder = inShellQuotes(submission.folder);
    for (std::size_t at = 0; (at = program.find("{}", at)) != std::string::npos; at += folder.size())
        program.replace(at, 2, folder);
    return program;
}

// "too slow: 2.1 s" and "too slow: 2.2 s" are one fault.
std::string withoutNumbers(std::string text) {
    std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    return text;
}

// The whole class: results, in which a fault may be told already, and the paths of pictures.
class ClassGrading {
  public:
    ClassGrading(const GradePlan& plan, const std::vector<Submission>& submissions,
                 const ClassOptions& options, ProgressListener& progress)
        : plan_(plan), submissions_(submissions), options_(options), progress_(progress) {
        for (const Submission& submission : submissions) {
            graded_.push_back({submission.name, std::vector<GradeResult>(plan.cases.size())});
            for (std::size_t c = 0; c < plan.cases.size(); ++c)
                graded_.back().results[c].test = plan.cases[c];
        }
        paths_.resize(submissions.size() * plan.cases.size());
    }

    void findPictures() {
        for (std::size_t s = 0; s < submissions_.size(); ++s) {
            const Submission& submission = submissions_[s];
            const FilesByName files = filesBeneath(submission.folder);
            for (std::size_t c = 0; c < plan_.cases.size(); ++c) {
                const FoundPicture found = findPicture(files, plan_.cases[c]);
                take(graded_[s].results[c], found, submission);
                if (!found.path.empty()) path(s, c) = (files::path(submission.folder) / found.path).string();
            }
        }
    }

    void makePictures() {
        std::vector<ProgramRun> runs;
        for (std::size_t s = 0; s < submissions_.size(); ++s)
            for (std::size_t c = 0; c < plan_.cases.size(); ++c)
                runs.push_back({commandOf(options_.program, submissions_[s]), &plan_.cases[c],
                                longEdgeOf(plan_.cases[c]),
                                made_.file(std::to_string(runs.size()) + ".png")});
        std::size_t done = 0;
        runPrograms(runs, options_.run, options_.jobs, [&](std::size_t i, const Rendered& rendered) {
            GradeResult& result = graded_[i / plan_.cases.size()].results[i % plan_.cases.size()];
            if (!rendered.failed) paths_[i] = runs[i].picture;
            result.take(rendered);
            progress_.progress(static_cast<double>(++done) / static_cast<double>(runs.size()));
        });
    }

    // Scene by scene: what is known of one scene's mistakes is needed for its pictures only.
    void grade(const NamerMaker& makeNamer, PictureShelf* shelf) {
        std::mutex mutex;
        std::size_t done = 0;
        parallelFor(static_cast<std::uint32_t>(plan_.cases.size()), 0, [&](std::uint32_t c) {
            gradeCaseOfAll(c, makeNamer, shelf);
            const std::lock_guard lock(mutex);
            progress_.progress(static_cast<double>(++done) / static_cast<double>(plan_.cases.size()));
        });
    }

    std::vector<GradedSubmission> take() { return std::move(graded_); }

  private:
    static void take(GradeResult& result, const FoundPicture& found, const Submission& submission) {
        result.note = found.note;
        result.isMissing = found.path.empty();
        result.instead = found.instead;
        if (result.isMissing)
            result.message = "no picture " + result.test.name + ".png" + thereIs(found.instead);
        else result.path = (submission.given / files::path(found.path)).string();
    }

    std::string& path(std::size_t submission, std::size_t test) {
        return paths_[submission * plan_.cases.size() + test];
    }

    int longEdgeOf(const GradeCase& test) {
        int& edge = longEdges_[test.reference];
        if (edge) return edge;
        const FileBytes file(test.reference, FileKind::Regular);
        const auto size = sizeInHeader(file);
        if (!size) readImage(test.reference, FileKind::Regular);  // says what is wrong with it
        return edge = std::max(size->width, size->height);
    }

    void gradeCaseOfAll(std::size_t test, const NamerMaker& makeNamer, PictureShelf* shelf) {
        const ReferencePicture reference(plan_.cases[test].reference);
        NamedCase named(plan_.cases[test], reference, makeNamer);
        for (std::size_t s = 0; s < submissions_.size(); ++s) {
            GradeResult& result = graded_[s].results[test];
            if (!path(s, test).empty()) gradePicture(result, reference, path(s, test), &named);
            if (shelf) putOn(*shelf, result, reference);
            result.referencePng = result.ourPng = result.differencePng = {};
        }
    }

    static void putOn(PictureShelf& shelf, GradeResult& result, const ReferencePicture& reference) {
        result.keys = {shelf.add(reference.png), shelf.add(result.ourPng), shelf.add(result.differencePng)};
    }

    const GradePlan& plan_;
    const std::vector<Submission>& submissions_;
    const ClassOptions& options_;
    ProgressListener& progress_;
    TemporaryFolder made_;
    std::vector<GradedSubmission> graded_;
    std::vector<std::string> paths_;  // submission by submission; empty: there is no picture
    std::map<std::string, int> longEdges_;
};

}  // namespace

std::vector<Submission> submissionsIn(const std::string& folder) {
    std::vector<Submission> submissions;
    std::error_code error, ignored;
    for (files::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->is_directory(ignored) && !entry->path().filename().string().starts_with('.'))
            submissions.push_back({entry->path().filename().string(), absolutePath(entry->path().string()),
                                   entry->path().string()});
    if (error) throw folderError(folder, error);
    if (submissions.empty()) throw Error({folder}, "expected a folder for each submission, found none");
    std::ranges::sort(submissions, {}, &Submission::name);
    return submissions;
}

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

// "a, b and 3 more are missing, but a.jpg is there"; empty where none is.
std::string missingPictures(const std::vector<GradeResult>& results) {
    constexpr std::size_t most = 3;  // parts of the list: names, the last for all that are left
    std::vector<std::string> names;
    for (const GradeResult& result : results)
        if (result.isMissing) names.push_back(result.test.name);
    if (names.empty()) return {};
    const std::size_t count = names.size();
    const auto instead = std::ranges::find_if_not(results, &std::string::empty, &GradeResult::instead);
    if (count > most) {
        names.resize(most - 1);
        names.push_back(std::to_string(count - names.size()) + " more");
    }
    return listed(names, "and") + (count == 1 ? " is missing" : " are missing") +
           (instead == results.end() ? "" : thereIs(instead->instead));
}

// A picture that several mistakes explain counts for each of them: what explains the others too is the one.
std::string mistakeOfMost(const std::vector<GradeResult>& results, const Thresholds& thresholds) {
    std::map<std::string, std::size_t> count;
    std::vector<std::string> order;
    std::size_t wrong = 0;
    const auto add = [&](const std::string& text) {
        if (!text.empty() && count[withoutNumbers(text)]++ == 0) order.push_back(text);
    };
    for (const GradeResult& result : results) {
        if (result.isMissing || within(result, thresholds)) continue;
        ++wrong;
        if (!result.comparison) add(result.message);
        for (const std::string& mistake : result.mistakes) add(mistake);
    }
    if (wrong == 0) return {};
    if (order.empty()) return "no known mistake";
    const auto most = std::ranges::max_element(
        order, {}, [&](const std::string& text) { return count[withoutNumbers(text)]; });
    const std::size_t times = count[withoutNumbers(*most)];
    if (times == wrong) return *most;
    return *most + " (" + std::to_string(times) + " of " + std::to_string(wrong) + " wrong pictures)";
}

}  // namespace

std::string GradedSubmission::fault(const Thresholds& thresholds) const {
    const auto isNowhere = [](const GradeResult& r) { return r.isMissing && r.instead.empty(); };
    if (!results.empty() && std::ranges::all_of(results, isNowhere)) return "nothing handed in";
    const std::string mistake = mistakeOfMost(results, thresholds), missing = missingPictures(results);
    return mistake + (mistake.empty() || missing.empty() ? "" : "; ") + missing;
}

std::string GradedSubmission::remarks(const Thresholds& thresholds) const {
    std::string text = fault(thresholds);
    std::size_t notes = 0;
    for (const GradeResult& result : results)
        if (!result.note.empty() && notes++ == 0) text += (text.empty() ? "" : "; ") + result.note;
    if (notes > 1) text += " (so with " + std::to_string(notes) + " pictures)";
    return text;
}

std::vector<GradedSubmission> gradeClass(const GradePlan& plan, const std::vector<Submission>& submissions,
                                         const ClassOptions& options, const NamerMaker& makeNamer,
                                         PictureShelf* shelf, ProgressListener& progress) {
    ClassGrading grading(plan, submissions, options, progress);
    if (options.program.empty()) grading.findPictures();
    else grading.makePictures();
    grading.grade(makeNamer, shelf);
    return grading.take();
}

}  // namespace raytracer
