// Writes grades as tables for people, and as files for other programs.
#pragma once

#include <span>
#include <string>

#include "raytracer/grading/submissions.h"

namespace raytracer {

// CSV (RFC 4180) with the columns `submission`, the score of each case, `mean` and `mistake`.
std::string gradesAsCsv(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

std::string gradesAsJson(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

// JUnit's XML, as CI systems read it: a testsuite for each submission, a testcase for each picture. A
// missing or unreadable picture is an error, a wrong one a failure.
std::string gradesAsJunit(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

// Gradescope's results.json: a test for each picture, worth `points` times its score / 100.
// https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format
std::string gradesForGradescope(const GradedSubmission& graded, const Thresholds& thresholds, double points);

// The table of one program's pictures: its head, and a picture's row with what is wrong with it.
std::string gradeTableHead();
std::string gradeTableRow(const GradeResult& result);

// The lines below that table.
std::string gradeSummary(const GradedSubmission& graded, const GradePlan& plan, const Thresholds& thresholds);

// The table of a class: a line for each submission.
std::string classTable(std::span<const GradedSubmission> graded, const Thresholds& thresholds);

// A remark on a result, in one line: why there is no picture, or what is wrong with it.
std::string remark(const GradeResult& result);

}  // namespace raytracer
