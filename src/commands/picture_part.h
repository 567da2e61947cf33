// --part: one of several parts of a picture, for `raytracer assemble`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raytracer/pictures/part_file.h"
#include "render_arguments.h"

namespace raytracer::commands {

// "K/N". Throws Error.
PicturePart parsePart(const std::string& text);

// The file of a part of the picture `out`: "out.png.part-3-of-7".
std::string partName(const std::string& out, const PicturePart& part);

// All options that change the picture, as a command line has them.
std::string pictureOptions(const RenderArguments& arguments, const RenderOptions& options);

// Which part of which picture this is. Throws Error where a file of the scene cannot be read again.
PartHead partHead(const RenderArguments& arguments, const RenderOptions& options, const PicturePart& part,
                  const std::vector<std::string>& sceneFiles);

}  // namespace raytracer::commands
