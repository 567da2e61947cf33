// The commands. Each parses its own arguments, calls the library and returns
// the process's exit status: 0 for success, 1 if a comparison or a goal is
// not met, 2 for wrong usage. Bad input is an Error, which main prints.
#pragma once

#include <string>
#include <vector>

namespace raytracer::commands {

// The whole command line: finds the command and calls it.
int run(int argc, char** argv);

// The names of the commands that have one.
std::vector<std::string> commandNames();

// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS [options]: the default, without a name of its own.
int render(int argc, char** argv);

// raytracer compare A B [options]: how much two pictures differ.
int compare(int argc, char** argv);

// raytracer assemble PART... IMAGE_OUT: makes a picture from all its parts, rendered with --part.
int assemble(int argc, char** argv);

// raytracer tradeoff SCENE... [options]: measures what speed costs in accuracy.
int tradeoff(int argc, char** argv);

// raytracer explain SCENE X Y LONG_EDGE_PIXELS [options]: the tree of rays behind one pixel.
int explain(int argc, char** argv);

// raytracer grade DIR [options]: renders scenes that have
// reference pictures, here or by another program, and compares.
int grade(int argc, char** argv);

}  // namespace raytracer::commands

namespace raytracer::schema_text {

extern const char* const scene;  // scenes/scene.schema.json, made by cmake/embed.cmake

}
