// Writes the grading as one self-contained HTML file.
#pragma once

#include <span>
#include <string>

#include "raytracer/grading/submissions.h"

namespace raytracer {

// The pictures are grouped by scene, the worst first. A click on a picture opens it large, at the worst
// pixel; each further click swaps the reference and the graded picture in place. The page lists its keys.
// Without scripts it is a list of all results.
std::string gradeReport(const GradedSubmission& graded, const Thresholds& thresholds,
                        const std::string& title);

// For a class: a table of the submissions, the worst first. Each row opens the submission's pictures, which
// are on the shelf and loaded only then. Without scripts it is only the table.
std::string classReport(std::span<const GradedSubmission> graded, const Thresholds& thresholds,
                        const std::string& title, const PictureShelf& shelf);

}  // namespace raytracer
