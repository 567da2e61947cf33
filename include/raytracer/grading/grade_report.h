// The grading as one HTML file that needs nothing else: open it in a browser, or send it to a student.
#pragma once

#include <span>
#include <string>

#include "raytracer/grading/grade.h"

namespace raytracer {

// Grouped by the names' first word, worst first. In the page a click on a picture opens it large at the worst
// pixel, and each further click swaps reference and ours in place; it lists its keys itself. Without scripts
// it is a table. `title` says what was graded.
std::string gradeReport(std::span<const GradeResult> results, const Thresholds& thresholds,
                        const std::string& title);

}  // namespace raytracer
