// A part of a picture in a file.
//
// The file: "raytracer part 1 SIZE\n" with the head's size in eight hexadecimal digits; the head, JSON; the
// pixels of the part's tiles (tilesOf), each row by row, as bytes, or as floats in the machine's order; the
// CRC-32 of all that, in eight hexadecimal digits.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "raytracer/pictures/pixels.h"
#include "raytracer/pictures/tiles.h"
#include "raytracer/util/file_reader.h"

namespace raytracer {

// What a part is of. Parts for which all but `part.number` is the same make a picture.
struct PartHead {
    std::string version;  // of the program
    std::string scene;    // the CRC-32 of the scene, its meshes and its textures, one behind the other
    std::string options;  // of the command line, all that change the picture
    ImageSize size;       // of the whole picture
    PixelRectangle crop;
    bool isFloat = false;   // of a PFM, else of a PNG
    bool isReached = true;  // the target of --target-error
    PicturePart part;

    std::size_t pixelBytes() const { return isFloat ? 3 * sizeof(float) : 3; }
};

// How the file begins: all but the pixels and the checksum.
std::string partBeginning(const PartHead& head);
constexpr std::size_t partChecksumSize = 8;
std::string partChecksum(std::uint32_t crc);

// What PartHead::scene is for these files: against accidents, not against attacks. Throws Error.
std::string sceneChecksum(std::span<const std::string> paths);

// A whole part; reads all of it. Throws Error for anything else.
class PartFile {
  public:
    explicit PartFile(const std::string& path);
    const PartHead& head() const { return head_; }

    // Some of its pixels' bytes, of a file that is known to begin with this head.
    static void readPixels(const std::string& path, const PartHead& head, std::uint64_t offset,
                           std::span<char> bytes);

  private:
    void requireWhole(const std::string& path) const;

    FileReader reader_;
    PartHead head_;
    std::uint64_t begin_ = 0;  // of the pixels
};

// Whether the file is the whole part that this head begins.
bool isPart(const std::string& path, const PartHead& head);

}  // namespace raytracer
