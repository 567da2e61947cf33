// Grades as files for other programs.
#pragma once

#include <span>
#include <string>

#include "raytracer/grading/submissions.h"

namespace raytracer {

// RFC 4180: `submission`, a column for each case with its score, `mean`, `mistake`.
std::string gradesAsCsv(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

std::string gradesAsJson(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

// As CI systems read it: a testsuite for each submission, a testcase for each picture. A picture that is
// missing is an error, a wrong one a failure.
std::string gradesAsJunit(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

// Gradescope's results.json: a test for each picture, of `points` each, by its score.
// https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format
std::string gradesForGradescope(const GradedSubmission& graded, const Thresholds& thresholds, double points);

// What is to be said of a result in one line: why there is no picture, or what is wrong with it.
std::string remark(const GradeResult& result);

}  // namespace raytracer
