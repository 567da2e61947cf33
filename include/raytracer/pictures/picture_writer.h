// Writes pictures band by band, so that they need not fit into memory.
#pragma once

#include <memory>
#include <vector>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/part_file.h"
#include "raytracer/pictures/tiles.h"

namespace raytracer {

// Writes a picture: call write() once for each of bands(), in that order, then finish(). These throw Error.
template <class Image>
class PictureWriter {
  public:
    virtual ~PictureWriter() = default;
    const std::vector<PixelRectangle>& bands() const { return bands_; }
    virtual void write(const Image& band) = 0;
    virtual void finish() = 0;  // completes the file

  protected:
    explicit PictureWriter(std::vector<PixelRectangle> bands) : bands_(std::move(bands)) {}

  private:
    std::vector<PixelRectangle> bands_;
};

// The most pixels that are written at once: by stb, and in a band. Tests use smaller limits.
struct WriterLimits {
    double ofStb = 1 << 25, ofBand = 1 << 23;
};

// The largest rectangle that is written at once, and therefore held in memory.
PixelRectangle largestBand(const PixelRectangle& crop, bool isPfm);

// Nothing is written before the first band. The file must outlive the writer. `crop` is the rectangle of the
// whole picture that is written.
//
// A PNG of at most limits.ofStb pixels is written by stb, as one band. A larger one is written in bands, with
// the same filter and compression.
std::unique_ptr<PictureWriter<ByteImage>> pngWriter(OutputFile& file, const PixelRectangle& crop, int threads,
                                                    const WriterLimits& limits = {});
// A PFM stores its bottom row first, so the bands go upwards.
std::unique_ptr<PictureWriter<FloatImage>> pfmWriter(OutputFile& file, const PixelRectangle& crop,
                                                     const WriterLimits& limits = {});

// Writes one part of a picture. Pixels of the bands that are not the part's are ignored.
template <class Image>
std::unique_ptr<PictureWriter<Image>> partWriter(OutputFile& file, const PartHead& head,
                                                 const WriterLimits& limits = {});

}  // namespace raytracer
