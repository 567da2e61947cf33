// Programs of submissions, run where they see their scene and nothing else of the class.
#pragma once

#include <string>
#include <vector>

#include "raytracer/grading/grade.h"

namespace raytracer {

// One run: its program, its scene, and the place for its picture. It runs in the folder of the scene's copy,
// but what its command names is found from ours.
struct ProgramRun {
    std::string command;
    const GradeCase* test = nullptr;
    int longEdge = 0;
    std::string picture;  // made there, unless the program has failed
};

// Runs them, up to `atOnce` side by side; ended(i, how) is told of each. A picture that was not written, or
// is no regular file, is a failure.
void runPrograms(const std::vector<ProgramRun>& runs, const ProgramOptions& options, int atOnce,
                 const std::function<void(std::size_t, const Rendered&)>& ended);

}  // namespace raytracer
