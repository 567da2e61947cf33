// The size of a picture that is complete: a PNG by its checksums,
// a PFM by its length. These throw Error if it is not.
#pragma once

#include "raytracer/pictures/pixels.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

ImageSize sizeOfWholePng(const FileBytes& file);
ImageSize sizeOfWholePfm(const FileBytes& file);

}  // namespace raytracer
