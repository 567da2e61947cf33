// Writes grades as tables and pages for people, and as files for other programs.
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

// One self-contained HTML file. The pictures are grouped by scene, the worst first. A click on a picture
// opens it large, at the worst pixel; each further click swaps the reference and the graded picture in place.
// The page lists its keys. Without scripts it is a list of all results.
std::string gradeReport(const GradedSubmission& graded, const Thresholds& thresholds,
                        const std::string& title);

// For a class: a table of the submissions, the worst first. Each row opens the submission's pictures, which
// are on the shelf and loaded only then. Without scripts it is only the table.
std::string classReport(std::span<const GradedSubmission> graded, const Thresholds& thresholds,
                        const std::string& title, const PictureShelf& shelf);

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
