// A part of a picture in a file.
//
// The format:
// - "raytracer part 1 SIZE\n", with the head's size in eight hexadecimal digits;
// - the head, JSON;
// - the pixels of the part's tiles (tilesOf), each tile row by row, as bytes, or as floats in the machine's
//   byte order;
// - the CRC-32 of all that, in eight hexadecimal digits.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "raytracer/pictures/pixels.h"
#include "raytracer/pictures/tiles.h"
#include "raytracer/util/file_reader.h"

namespace raytracer {

// Which picture a part belongs to. Parts that differ only in `part.number` make one picture.
struct PartHead {
    std::string version;  // of the program
    std::string scene;    // the CRC-32 of the scene's file, its meshes' and its textures', concatenated
    std::string options;  // those of the command line that change the picture
    ImageSize size;       // of the whole picture
    PixelRectangle crop;
    bool isFloat = false;   // true for a PFM, false for a PNG
    bool isReached = true;  // whether --target-error was reached
    PicturePart part;

    std::size_t pixelBytes() const { return isFloat ? 3 * sizeof(float) : 3; }
};

// The file's beginning: all that precedes the pixels.
std::string partBeginning(const PartHead& head);
constexpr std::size_t partChecksumSize = 8;
std::string partChecksum(std::uint32_t crc);

// PartHead::scene for these files. It guards against accidents, not against attacks. Throws Error.
std::string sceneChecksum(std::span<const std::string> paths);

// A complete part. The constructor reads all of the file, and throws Error if that is anything else.
class PartFile {
  public:
    explicit PartFile(const std::string& path);
    const PartHead& head() const { return head_; }

    // Reads bytes.size() bytes of a part's pixels, from `offset`
    // in them. The file must begin with this head. Throws Error.
    static void readPixels(const std::string& path, const PartHead& head, std::uint64_t offset,
                           std::span<char> bytes);

  private:
    void requireWhole(const std::string& path);

    FileReader reader_;
    PartHead head_;
    std::uint64_t begin_ = 0;  // of the pixels in the file, bytes
};

// Whether the file is a complete part with this head.
bool isPart(const std::string& path, const PartHead& head);

}  // namespace raytracer
