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
    ProgramOptions options;  // without `memory`; programOptions() has all
    bool quiet = false;
    Thresholds thresholds;

    void addTo(CommandLine& line);

    // Prints to standard output, unless `quiet`.
    void show(const std::string& text) const;

    // Throws Error for impossible options, before any file is read.
    void check() const;

    ProgramOptions programOptions() const;

  private:
    void addProgramTo(CommandLine& line);
    void addFilesTo(CommandLine& line);
};

}  // namespace raytracer::commands
