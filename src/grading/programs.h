// Runs programs of submissions, each in a folder that has its scene and nothing else of the class.
#pragma once

#include <string>
#include <vector>

#include "raytracer/grading/grade.h"

namespace raytracer {

// One run: its program, its scene, and the path for its picture. It runs in the folder with the scene's copy,
// but relative paths in its command lead to files of this program's folder.
struct ProgramRun {
    std::string command;
    const GradeCase* test = nullptr;
    int longEdge = 0;
    std::string picture;  // path to which the picture is copied, unless the program fails
};

// The command with absolute paths for the relative ones that lead to files of this program's folder.
std::string commandFromHere(const std::string& command);

// Runs the programs, up to `atOnce` at a time, and calls ended(i, how) after each. It is a failure if no
// picture was written, if it is not a regular file, or if the program has filled the disk. Throws Error if
// others have, or if one of the options' inputs has changed.
void runPrograms(const std::vector<ProgramRun>& runs, const ProgramOptions& options, int atOnce,
                 const std::function<void(std::size_t, const Rendered&)>& ended);

}  // namespace raytracer
