// Assembles a picture from the files of all its parts.
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

    // What keeps these files from making one picture, one line each: files that are broken, that belong to
    // another picture than most others, or that hold the same part; and parts that are missing.
    const std::vector<std::string>& faults() const { return faults_; }

    // Only if there are no faults: the picture that these are parts of, and the pixels of one of its bands
    // (bandsOf). read() throws Error.
    const PartHead& head() const { return head_; }
    template <class Image>
    Image read(const PixelRectangle& band) const;

  private:
    int threads_;
    PartHead head_;
    std::vector<std::string> paths_;  // paths_[i] is the file of part i + 1, or empty
    std::vector<std::string> faults_;
};

}  // namespace raytracer
