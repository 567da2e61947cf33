// The subcommands: each parses its own arguments, calls the library and returns the process's exit status
// (0 success, 1 a comparison or goal not met, 2 wrong usage). Bad input is an Error, for main to print.
#pragma once

#include <string>
#include <vector>

namespace raytracer::commands {

// The whole command line: finds the command and calls it.
int run(int argc, char** argv);

// Of those that have one.
std::vector<std::string> commandNames();

// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS [options]: the default, without a name of its own.
int render(int argc, char** argv);

// raytracer compare A B [options]: how much two pictures differ.
int compare(int argc, char** argv);

// raytracer assemble PART... IMAGE_OUT: a picture of all its parts, rendered with --part.
int assemble(int argc, char** argv);

// raytracer tradeoff SCENE... [options]: what speed costs in accuracy, measured.
int tradeoff(int argc, char** argv);

// raytracer explain SCENE X Y LONG_EDGE_PIXELS [options]: the tree of rays behind one pixel.
int explain(int argc, char** argv);

// raytracer grade DIR [options]: scenes with reference pictures, rendered (by us or another program) and
// compared.
int grade(int argc, char** argv);

}  // namespace raytracer::commands

namespace raytracer::schema_text {

extern const char* const scene;  // scenes/scene.schema.json, made by cmake/embed.cmake

}
