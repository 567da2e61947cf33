// Pictures that are written band by band, so that they need not fit into memory.
#pragma once

#include <memory>
#include <vector>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/part_file.h"
#include "raytracer/pictures/tiles.h"

namespace raytracer {

// Takes the bands of a picture, in the order of `bands`.
template <class Image>
class PictureWriter {
  public:
    virtual ~PictureWriter() = default;
    const std::vector<PixelRectangle>& bands() const { return bands_; }
    virtual void write(const Image& band) = 0;
    virtual void finish() = 0;  // the file is there

  protected:
    explicit PictureWriter(std::vector<PixelRectangle> bands) : bands_(std::move(bands)) {}

  private:
    std::vector<PixelRectangle> bands_;
};

// How many pixels are written together: by stb; else in a band. Tests have smaller ones.
struct WriterLimits {
    double ofStb = 1 << 25, ofBand = 1 << 23;
};

// What is written together, and so in memory.
PixelRectangle largestBand(const PixelRectangle& crop, bool isPfm);

// Nothing is written before the first band. What is behind these must outlive them. `crop` is the picture's
// place in the whole picture.
//
// PNG: by stb where that holds it; else here, with the same filter and deflate.
std::unique_ptr<PictureWriter<ByteImage>> pngWriter(OutputFile& file, const PixelRectangle& crop, int threads,
                                                    const WriterLimits& limits = {});
// PFM has its lowest row first.
std::unique_ptr<PictureWriter<FloatImage>> pfmWriter(OutputFile& file, const PixelRectangle& crop,
                                                     const WriterLimits& limits = {});

// A part of a picture of bytes or floats: what the part has not may be anything in the bands.
template <class Image>
std::unique_ptr<PictureWriter<Image>> partWriter(OutputFile& file, const PartHead& head,
                                                 const WriterLimits& limits = {});

}  // namespace raytracer
