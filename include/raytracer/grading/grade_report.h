// The grading as one self-contained HTML file.
#pragma once

#include <span>
#include <string>

#include "raytracer/grading/submissions.h"

namespace raytracer {

// Grouped by the first word of the names, worst first. A click on a picture opens it large at the worst
// pixel; each further click swaps reference and ours in place. The page lists its keys. Without scripts it is
// a table.
std::string gradeReport(const GradedSubmission& graded, const Thresholds& thresholds,
                        const std::string& title);

// A class: a table of the submissions, the worst first, that opens the pictures of each, which are on the
// shelf; loaded when they are opened. Without scripts it is the table.
std::string classReport(std::span<const GradedSubmission> graded, const Thresholds& thresholds,
                        const std::string& title, const PictureShelf& shelf);

}  // namespace raytracer
