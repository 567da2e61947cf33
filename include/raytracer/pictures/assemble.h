// A picture from the files of all its parts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/part_file.h"

namespace raytracer {

class PartFiles {
  public:
    // Reads all of the files, on several threads.
    PartFiles(std::span<const std::string> paths, int threads);

    // What keeps these files from being one picture, a line each: files that are broken, that do not fit to
    // most others, or are of one part; parts that are missing.
    const std::vector<std::string>& faults() const { return faults_; }

    // Where there is no fault: what they are parts of, and the pixels of a band (bandsOf). Throws Error.
    const PartHead& head() const { return head_; }
    template <class Image>
    Image read(const PixelRectangle& band) const;

  private:
    int threads_;
    PartHead head_;
    std::vector<std::string> paths_;  // of part 1, 2, ...
    std::vector<std::string> faults_;
};

}  // namespace raytracer
