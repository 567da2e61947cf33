// Grades a class. Each submission is a folder with pictures, or with a program that makes them.
#pragma once

#include <string>
#include <vector>

#include "raytracer/grading/grade.h"
#include "raytracer/grading/picture_shelf.h"
#include "raytracer/util/progress.h"

namespace raytracer {

struct Submission {
    std::string name, folder;  // the folder's name, and its absolute path
    std::string given;         // its path as given, relative or absolute
    bool isArchive = false;    // whether it is a file that should have been unpacked into a folder
};

inline constexpr const char* toUnpack = "an archive: unpack it into a folder";

// The subfolders of `folder`, sorted by name, and the archives for which there is no subfolder of their name.
// Throws Error if the folder, or what is in it, cannot be read, or if it has none of these.
std::vector<Submission> submissionsIn(const std::string& folder);

struct GradedSubmission {
    std::string name;
    std::vector<GradeResult> results;  // one for each case of the plan, in its order
    bool isArchive = false;

    double mean() const;
    std::size_t rightCount(const Thresholds& thresholds) const;
    const GradeResult& worst() const;
    double seconds() const;  // the sum of the results' times
    // What is wrong with most of the wrong pictures (a mistake, or why there is no picture), and which
    // pictures are missing. Empty if nothing is wrong.
    std::string fault(const Thresholds& thresholds) const;
    std::string remarks(const Thresholds& thresholds) const;  // the fault, and notes on pictures that count
};

struct ClassOptions {
    std::string program;  // "{}" is the submission's folder; empty: the folder has the pictures
    ProgramOptions run;
    int jobs = 1;  // number of programs that run at a time
};

// Grades all submissions. A picture that was handed in is X.png anywhere beneath the folder, the one nearest
// to its top. Programs run in a fresh folder each. What is wrong with a submission is in its results. Throws
// Error for what is the grader's fault: a reference or a submission that cannot be read, no temporary folder,
// a full disk, too little memory. If there is a shelf, the pictures are put there.
std::vector<GradedSubmission> gradeClass(const GradePlan& plan, const std::vector<Submission>& submissions,
                                         const ClassOptions& options, const NamerMaker& makeNamer,
                                         PictureShelf* shelf, ProgressListener& progress);

}  // namespace raytracer
