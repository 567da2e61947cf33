#include "raytracer/grading/submissions.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>

#include "mistake.h"
#include "programs.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/folder_walk.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

namespace files = std::filesystem;

// The path of a picture that was found, relative to the submission's folder, and what is odd about its name;
// or a file that may be meant instead: "a.jpg is there".
struct FoundPicture {
    std::string path, note, instead;
};

// The files beneath a folder, by their names in small letters: PNG files with their ending, others without.
// Links to PNG files are among the others: what they lead to was not handed in. The places of each name are
// sorted by depth, the nearest to the top first, then by path. Throws Error as walkBeneath does.
using FilesByName = std::map<std::string, std::vector<std::pair<int, files::path>>>;

FilesByName filesBeneath(const std::string& folder) {
    FilesByName found;
    walkBeneath(folder, [&](const files::path& path, files::file_type type, int depth) {
        const bool isPng = endsIn(path.string(), ".png"), isFile = type == files::file_type::regular;
        if (!isFile && !(isPng && type == files::file_type::symlink)) return;
        files::path name = isPng && isFile ? path.filename() : path.stem();
        if (!isPng && endsIn(name.string(), ".png")) name = name.stem();  // a.png.zip is no a.png
        found[inLowerCase(name.string())].emplace_back(depth, path.lexically_relative(folder));
    });
    for (auto& [name, places] : found) std::ranges::sort(places);
    return found;
}

// The names, without ending, that a case's picture may have: X.png matches a reference X-raytracing.png, too.
std::vector<std::string> fileNames(const GradeCase& test) {
    std::vector<std::string> names{test.name};
    const std::string ending = "-" + std::string(completeStage().name);
    if (test.name.ends_with(ending)) names.push_back(test.name.substr(0, test.name.size() - ending.size()));
    return names;
}

// What is odd about the picture that counts for this name, which is the first place; empty if nothing is.
std::string noteOn(const std::string& name, const FilesByName::mapped_type& places) {
    const auto inside = [&](std::size_t i) { return places[i].second.string(); };
    if (places.size() > 1 && places[1].first == places[0].first)
        return name + " is there twice: " + inside(0) + " counts, not " + inside(1);
    return places[0].second.filename() == name ? "" : inside(0) + " counts as " + name;
}

// What there is instead of a picture: only its links end in .png.
std::string insteadOf(const std::string& other) {
    return other + (endsIn(other, ".png") ? " is a symbolic link" : " is there");
}

FoundPicture findPicture(const FilesByName& files, const GradeCase& test) {
    FoundPicture found;
    for (const std::string& name : fileNames(test)) {
        const std::string png = name + ".png";
        const auto known = files.find(inLowerCase(png)), other = files.find(inLowerCase(name));
        if (known != files.end()) return {known->second[0].second.string(), noteOn(png, known->second), ""};
        if (other != files.end() && found.instead.empty())
            found.instead = insteadOf(other->second[0].second.string());
    }
    return found;
}

// The grading of a class: the results, some of which may have a fault already, and the pictures' paths.
class ClassGrading {
  public:
    ClassGrading(const GradePlan& plan, const std::vector<Submission>& submissions,
                 const ClassOptions& options, ProgressListener& progress)
        : plan_(plan), submissions_(submissions), options_(options), progress_(progress) {
        for (const Submission& submission : submissions) {
            graded_.push_back({submission.name, {}, submission.isArchive});
            for (const GradeCase& test : plan.cases) {
                GradeResult& result = graded_.back().results.emplace_back();
                result.test = test;
                result.isMissing = submission.isArchive;
                if (submission.isArchive) result.message = toUnpack;
            }
        }
        paths_.resize(submissions.size() * plan.cases.size());
    }

    void findPictures() {
        for (std::size_t s = 0; s < submissions_.size(); ++s) {
            const Submission& submission = submissions_[s];
            if (submission.isArchive) continue;
            const FilesByName files = filesBeneath(submission.given);
            for (std::size_t c = 0; c < plan_.cases.size(); ++c) {
                const FoundPicture found = findPicture(files, plan_.cases[c]);
                take(graded_[s].results[c], found, submission);
                if (!found.path.empty()) path(s, c) = (files::path(submission.folder) / found.path).string();
            }
        }
    }

    void makePictures() {
        std::vector<int> edges;
        for (const GradeCase& test : plan_.cases) edges.push_back(longEdgeOf(test));
        std::vector<ProgramRun> runs;
        std::vector<std::pair<std::size_t, std::size_t>> places;
        for (std::size_t s = 0; s < submissions_.size(); ++s) {
            const std::string command =
                replaced(options_.program, "{}", inShellQuotes(submissions_[s].folder));
            for (std::size_t c = 0; !submissions_[s].isArchive && c < plan_.cases.size(); ++c) {
                runs.push_back(
                    {command, &plan_.cases[c], edges[c], made_.file(std::to_string(runs.size()) + ".png")});
                places.emplace_back(s, c);
            }
        }
        std::size_t done = 0;
        runPrograms(runs, options_.run, options_.jobs, [&](std::size_t i, const Rendered& rendered) {
            const auto& [s, c] = places[i];
            if (!rendered.failed) path(s, c) = runs[i].picture;
            static_cast<Rendered&>(graded_[s].results[c]) = rendered;
            progress_.progress(static_cast<double>(++done) / static_cast<double>(runs.size()));
        });
    }

    // Grades case by case, so that only the cases in work keep what is known of their scene's mistakes. The
    // threads have the stack for these: otherwise each of some thousand traces would start a thread.
    void grade(const NamerMaker& makeNamer, PictureShelf* shelf) {
        std::mutex mutex;
        std::size_t done = 0;
        const auto count = static_cast<std::uint32_t>(plan_.cases.size());
        onTracingThreads(count, 0, mostRecursionTried, [&](JobQueue& queue) {
            for (std::uint32_t c; queue.next(c);) {
                gradeCaseOfAll(c, makeNamer, shelf);
                const std::lock_guard lock(mutex);
                progress_.progress(static_cast<double>(++done) / count);
            }
        });
    }

    std::vector<GradedSubmission> take() { return std::move(graded_); }

  private:
    static void take(GradeResult& result, const FoundPicture& found, const Submission& submission) {
        result.note = found.note;
        result.isMissing = found.path.empty();
        result.instead = found.instead;
        if (result.isMissing)
            result.message = "no picture " + result.test.name + ".png" + result.butInstead();
        else result.path = (submission.given / files::path(found.path)).string();
        if (!result.isMissing && !std::ifstream(result.path)) throw systemError(result.path, "cannot read");
    }

    std::string& path(std::size_t submission, std::size_t test) {
        return paths_[submission * plan_.cases.size() + test];
    }

    static int longEdgeOf(const GradeCase& test) {
        const FileBytes file(test.reference, FileKind::Regular);
        const auto size = sizeInHeader(file);
        if (!size) readImage(file);  // throws what is wrong with it
        return std::max(size->width, size->height);
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
};

// The name of the folder that an archive should have been unpacked to; empty if the file is not an archive.
std::string unpackedName(const std::string& file) {
    for (const std::string_view ending :
         {".zip", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".7z", ".rar"})
        if (endsIn(file, ending)) return file.substr(0, file.size() - ending.size());
    return {};
}

}  // namespace

std::vector<Submission> submissionsIn(const std::string& folder) {
    std::vector<Submission> submissions, archives;
    std::error_code error, why;
    for (files::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        const files::file_type type = entry->status(why).type();
        if (type == files::file_type::none) throw unreadable(entry->path(), why);
        Submission found{name, absolutePath(entry->path().string()), entry->path().string()};
        found.isArchive = type == files::file_type::regular && !unpackedName(name).empty();
        if (!found.isArchive && type != files::file_type::directory) continue;
        (found.isArchive ? archives : submissions).push_back(std::move(found));
    }
    if (error) throw folderError(folder, error);
    std::erase_if(archives, [&](const Submission& archive) {
        return std::ranges::find(submissions, unpackedName(archive.name), &Submission::name) !=
               submissions.end();
    });
    std::ranges::move(archives, std::back_inserter(submissions));
    if (submissions.empty()) throw Error({folder}, "expected a folder for each submission, found none");
    std::ranges::sort(submissions, {}, &Submission::name);
    return submissions;
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
