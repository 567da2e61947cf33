// The command line of `raytracer grade`.
#pragma once

#include <string>

#include "arguments.h"
#include "raytracer/grading/grade.h"

namespace raytracer::commands {

struct GradeArguments {
    std::string scenes, references, report, program, stage, submissions;
    std::string csv, json, junit, gradescope;
    double points = 10;
    int memory = 8192, jobs = 1;
    ProgramOptions options;  // but for the memory
    bool quiet = false;
    Thresholds thresholds;

    void addTo(CommandLine& line);

    // To standard output, unless `quiet`.
    void show(const std::string& text) const;

    // Throws Error for what cannot be done, before anything is read.
    void check() const;

    ProgramOptions programOptions() const;

  private:
    void addProgramTo(CommandLine& line);
    void addFilesTo(CommandLine& line);
};

}  // namespace raytracer::commands
