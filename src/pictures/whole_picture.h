// The size of a picture of which all is there: for a PNG by its checksums, for a PFM by its length. Throw
// Error.
#pragma once

#include "raytracer/pictures/pixels.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

ImageSize sizeOfWholePng(const FileBytes& file);
ImageSize sizeOfWholePfm(const FileBytes& file);

}  // namespace raytracer
