#include "raytracer/pictures/picture_writer.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

#include <libdeflate.h>

#include "deflate.h"
#include "png_format.h"
#include "raytracer/util/parallel.h"

namespace raytracer {
namespace {

std::span<const char> asChars(const void* data, std::size_t size) {
    return {static_cast<const char*>(data), size};
}

// libdeflate_crc32 takes a null pointer for the beginning of a new checksum, so empty data are left out.
std::uint32_t crcWith(std::uint32_t crc, std::span<const char> next) {
    return next.empty() ? crc : libdeflate_crc32(crc, next.data(), next.size());
}

template <class Image>
std::span<const char> rowOf(const Image& image, int y) {
    const std::size_t rowChannels = 3 * static_cast<std::size_t>(image.width);
    return asChars(image.pixels.data() + static_cast<std::size_t>(y) * rowChannels,
                   rowChannels * sizeof image.pixels[0]);
}

class StbPngWriter final : public PictureWriter<ByteImage> {
  public:
    StbPngWriter(OutputFile& file, const PixelRectangle& crop, int threads)
        : PictureWriter({crop}), file_(file), threads_(threads) {}
    void write(const ByteImage& picture) override {
        file_.append(encodePng(picture, file_.name(), threads_));
    }
    void finish() override { file_.finish(); }

  private:
    OutputFile& file_;
    int threads_;
};

// Writes a PNG with one IDAT chunk for each band (PNG specification, 11.2.4).
class BandedPngWriter final : public PictureWriter<ByteImage> {
  public:
    BandedPngWriter(OutputFile& file, const PixelRectangle& crop, int threads, const WriterLimits& limits)
        : PictureWriter(bandsOf(crop, limits.ofBand)),
          file_(file),
          threads_(threads),
          width_(crop.width()),
          height_(crop.height()),
          lastRow_(3 * static_cast<std::size_t>(crop.width())) {}

    void write(const ByteImage& band) override {
        const bool isFirst = band_.empty(), isLast = ++written_ == bands().size();
        if (isFirst) appendBeginning();
        filter(band);
        Bytes chunk;
        if (isFirst) chunk.assign(std::begin(zlibHeader), std::end(zlibHeader));
        for (const DeflatedPiece& piece : deflatePieces(band_, isLast, deflateLevel, threads_)) {
            chunk.insert(chunk.end(), piece.bytes.begin(), piece.bytes.end());
            adler_ = adlerWith(adler_, piece);
        }
        if (isLast) appendBigEndian(chunk, adler_);
        appendChunk("IDAT", chunk);
    }
    void finish() override {
        appendChunk("IEND", {});
        file_.finish();
    }

  private:
    void appendBeginning() {
        Bytes header;
        appendBigEndian(header, static_cast<std::uint32_t>(width_));
        appendBigEndian(header, static_cast<std::uint32_t>(height_));
        header.insert(header.end(), {8, 2, 0, 0, 0});  // 8 bits, RGB; the others are the defaults
        file_.append(pngSignature);
        appendChunk("IHDR", header);
    }

    void filter(const ByteImage& band) {
        const std::size_t rowSize = lastRow_.size();
        band_.resize((rowSize + 1) * static_cast<std::size_t>(band.height));
        parallelFor(static_cast<std::uint32_t>(band.height), threads_, [&](std::uint32_t y) {
            const std::uint8_t* const row = &band.pixels[y * rowSize];
            const std::uint8_t* const above = y > 0 ? row - rowSize : lastRow_.data();
            unsigned char* const to = &band_[y * (rowSize + 1)];
            to[0] = pngFilter;
            for (std::size_t i = 0; i < rowSize; ++i)
                to[i + 1] = static_cast<unsigned char>(row[i] - above[i]);
        });
        lastRow_.assign(band.pixels.end() - static_cast<std::ptrdiff_t>(rowSize), band.pixels.end());
    }

    void appendChunk(std::string_view type, const Bytes& data) {
        const std::span<const char> content = asChars(data.data(), data.size());
        Bytes size, crc;
        appendBigEndian(size, static_cast<std::uint32_t>(data.size()));
        appendBigEndian(crc, crcWith(crcWith(0, type), content));
        file_.append(asChars(size.data(), size.size()));
        file_.append(type);
        file_.append(content);
        file_.append(asChars(crc.data(), crc.size()));
    }

    OutputFile& file_;
    int threads_;
    int width_, height_;
    std::size_t written_ = 0;  // bands so far
    Bytes lastRow_, band_;     // the row above the band (zeros above the first); the band, filtered
    std::uint32_t adler_ = adlerOfNothing;
};

class PfmWriter final : public PictureWriter<FloatImage> {
  public:
    PfmWriter(OutputFile& file, const PixelRectangle& crop, const WriterLimits& limits)
        : PictureWriter(upwards(crop, limits)), file_(file) {
        const char* const scale = std::endian::native == std::endian::little ? "-1.0" : "1.0";
        beginning_ =
            "PF\n" + std::to_string(crop.width()) + ' ' + std::to_string(crop.height()) + '\n' + scale + '\n';
    }
    void write(const FloatImage& band) override {
        file_.append(std::exchange(beginning_, ""));
        for (int y = band.height; y-- > 0;) file_.append(rowOf(band, y));
    }
    void finish() override { file_.finish(); }

  private:
    static std::vector<PixelRectangle> upwards(const PixelRectangle& crop, const WriterLimits& limits) {
        std::vector<PixelRectangle> bands = bandsOf(crop, limits.ofBand);
        std::ranges::reverse(bands);
        return bands;
    }

    OutputFile& file_;
    std::string beginning_;
};

template <class Image>
class PartWriter final : public PictureWriter<Image> {
  public:
    PartWriter(OutputFile& file, const PartHead& head, const WriterLimits& limits)
        : PictureWriter<Image>(bandsOf(head.crop, limits.ofBand)), file_(file), head_(head) {}
    void write(const Image& band) override {
        if (next_ == 0) append(partBeginning(head_));
        const PixelRectangle& place = this->bands()[next_++];
        std::vector<char> pixels;
        for (const PixelRectangle& tile : tilesOf(place, head_.part))
            for (int y = tile.y0; y < tile.y1; ++y) {
                const auto row =
                    rowOf(band, y - place.y0)
                        .subspan(head_.pixelBytes() * static_cast<std::size_t>(tile.x0 - place.x0),
                                 head_.pixelBytes() * static_cast<std::size_t>(tile.width()));
                pixels.insert(pixels.end(), row.begin(), row.end());
            }
        append(pixels);
    }
    void finish() override {
        file_.append(partChecksum(crc_));
        file_.finish();
    }

  private:
    void append(std::span<const char> bytes) {
        crc_ = crcWith(crc_, bytes);
        file_.append(bytes);
    }

    OutputFile& file_;
    PartHead head_;
    std::size_t next_ = 0;
    std::uint32_t crc_ = 0;
};

}  // namespace

PixelRectangle largestBand(const PixelRectangle& crop, bool isPfm) {
    const WriterLimits limits;
    return !isPfm && crop.area() <= limits.ofStb ? crop : bandsOf(crop, limits.ofBand).front();
}

std::unique_ptr<PictureWriter<ByteImage>> pngWriter(OutputFile& file, const PixelRectangle& crop, int threads,
                                                    const WriterLimits& limits) {
    if (crop.area() <= limits.ofStb) return std::make_unique<StbPngWriter>(file, crop, threads);
    return std::make_unique<BandedPngWriter>(file, crop, threads, limits);
}

std::unique_ptr<PictureWriter<FloatImage>> pfmWriter(OutputFile& file, const PixelRectangle& crop,
                                                     const WriterLimits& limits) {
    return std::make_unique<PfmWriter>(file, crop, limits);
}

template <class Image>
std::unique_ptr<PictureWriter<Image>> partWriter(OutputFile& file, const PartHead& head,
                                                 const WriterLimits& limits) {
    return std::make_unique<PartWriter<Image>>(file, head, limits);
}
template std::unique_ptr<PictureWriter<ByteImage>> partWriter(OutputFile&, const PartHead&,
                                                              const WriterLimits&);
template std::unique_ptr<PictureWriter<FloatImage>> partWriter(OutputFile&, const PartHead&,
                                                               const WriterLimits&);

}  // namespace raytracer
