// Which program this is.
#pragma once

#include <string>

namespace raytracer::commands {

// Lines: version and commit, the instruction sets that there is code for, the precisions.
std::string versionText();

// Of the code: two programs of one version make the same pictures.
std::string programVersion();

}  // namespace raytracer::commands

namespace raytracer::schema_text {

extern const char* const scene;  // scenes/scene.schema.json, made by cmake/embed.cmake

}
