#include "raytracer/pictures/assemble.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

#include "raytracer/util/error.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// A file that was given: its head, or why it cannot be read.
struct GivenPart {
    std::string path;
    std::optional<PartHead> head{};
    std::string fault{};
};

std::vector<GivenPart> readParts(std::span<const std::string> paths, int threads) {
    std::vector<GivenPart> parts(paths.size());
    parallelFor(static_cast<std::uint32_t>(paths.size()), threads, [&](std::uint32_t i) {
        parts[i].path = paths[i];
        try {
            parts[i].head = PartFile(paths[i]).head();
        } catch (const Error& error) {
            parts[i].fault = error.what();
        }
    });
    return parts;
}

// A key that is the same for all parts of a picture.
std::string pictureOf(PartHead head) {
    head.part.number = 1;
    return partBeginning(head);
}

// The first part of the picture to which most of the parts belong; null if no file is a part.
const GivenPart* usualPart(const std::vector<GivenPart>& parts) {
    std::map<std::string, int> counts;
    for (const GivenPart& part : parts)
        if (part.head) ++counts[pictureOf(*part.head)];
    const GivenPart* usual = nullptr;
    int most = 0;
    for (const GivenPart& part : parts) {
        const int count = part.head ? counts[pictureOf(*part.head)] : 0;
        if (count > most) usual = &part;
        most = std::max(most, count);
    }
    return usual;
}

std::string inWords(const PixelRectangle& crop) {
    std::string text;
    for (const int place : {crop.x0, crop.y0, crop.x1, crop.y1})
        text += (text.empty() ? "" : ",") + std::to_string(place);
    return text;
}

// The options, "--name value", that `head` has and `other` has not.
std::string onlyIn(const PartHead& head, const PartHead& other) {
    constexpr std::string_view next = " --";
    std::string text;
    for (std::size_t begin = 0, end = 0; end < head.options.size(); begin = end + 1) {
        end = std::min(head.options.find(next, begin), head.options.size());
        const std::string option = head.options.substr(begin, end - begin);
        const bool isInBoth = (other.options + next.data()).find(option + next.data()) != std::string::npos;
        if (!isInBoth) text += (text.empty() ? "" : " ") + option;
    }
    return text;
}

// How `found` differs from `expected`, in words; empty if they are of the same picture.
std::string difference(const PartHead& found, const PartHead& expected) {
    if (found.version != expected.version)
        return "of version " + found.version + " of raytracer, not " + expected.version;
    if (found.scene != expected.scene) return "of another scene";
    if (found.size != expected.size)
        return "of a picture of " + inWords(found.size) + " pixels, not " + inWords(expected.size);
    if (inWords(found.crop) != inWords(expected.crop))
        return "of --crop " + inWords(found.crop) + ", not " + inWords(expected.crop);
    if (found.isFloat != expected.isFloat)
        return found.isFloat ? "of a .pfm, not of a .png" : "of a .png, not of a .pfm";
    if (found.options != expected.options) {
        const std::string has = onlyIn(found, expected), lacks = onlyIn(expected, found);
        if (has.empty()) return "of a picture without " + lacks;
        return "of a picture with " + has + (lacks.empty() ? "" : ", not with " + lacks);
    }
    if (found.part.count != expected.part.count)
        return "part " + inWords(found.part) + ", not of " + std::to_string(expected.part.count);
    return "";
}

// "part 3 of 7 is missing: ...", "parts 1 and 3 to 5 of 7 are missing: ..."; empty if none is.
std::string missingParts(const std::vector<std::string>& paths) {
    std::vector<std::string> ranges;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (!paths[i].empty()) continue;
        const std::size_t first = i;
        while (i + 1 < paths.size() && paths[i + 1].empty()) ++i;
        missing += i + 1 - first;
        ranges.push_back(std::to_string(first + 1) + (i > first ? " to " + std::to_string(i + 1) : ""));
    }
    if (missing == 0) return "";
    const std::string text = listed(ranges, "and"), count = std::to_string(paths.size());
    if (missing == 1)
        return "part " + text + " of " + count + " is missing: render it with --part " + text + "/" + count;
    return "parts " + text + " of " + count + " are missing: render each with --part K/" + count;
}

// Copies a tile's pixels, which lie row by row at `from`, to their place in the image of the band.
template <class Image>
void copyTile(const PixelRectangle& tile, const char* from, const PixelRectangle& band, Image& image) {
    constexpr std::size_t pixelSize = 3 * sizeof image.pixels[0];
    const std::size_t rowSize = pixelSize * static_cast<std::size_t>(tile.width());
    for (int y = tile.y0; y < tile.y1; ++y, from += rowSize)
        std::memcpy(image.at(tile.x0 - band.x0, y - band.y0), from, rowSize);
}

}  // namespace

PartFiles::PartFiles(std::span<const std::string> paths, int threads) : threads_(threads) {
    const std::vector<GivenPart> parts = readParts(paths, threads);
    const GivenPart* const usual = usualPart(parts);
    if (usual) head_ = *usual->head;
    paths_.resize(usual ? static_cast<std::size_t>(head_.part.count) : 0);
    for (const GivenPart& part : parts) {
        const std::string other = part.head ? difference(*part.head, head_) : "";
        std::string fault = part.fault;
        if (!other.empty()) fault = part.path + ": does not fit " + usual->path + ": it is " + other;
        if (part.head && other.empty()) {
            std::string& place = paths_[static_cast<std::size_t>(part.head->part.number) - 1];
            if (!place.empty())
                fault = part.path + ": part " + inWords(part.head->part) + " again, as " + place;
            else place = part.path;
        }
        if (!fault.empty()) faults_.push_back(fault);
    }
    if (const std::string missing = missingParts(paths_); !missing.empty()) faults_.push_back(missing);
}

template <class Image>
Image PartFiles::read(const PixelRectangle& band) const {
    Image image{band.size(), {}};
    image.pixels.resize(3 * image.area());
    const PixelRectangle above{head_.crop.x0, head_.crop.y0, head_.crop.x1, band.y0};
    const int count = head_.part.count;
    const std::vector<std::uint64_t> before = pixelsOfParts(above, count), here = pixelsOfParts(band, count);
    std::vector<std::vector<PixelRectangle>> tiles(here.size());
    const PartLattice lattice(count);
    for (const PixelRectangle& tile : tilesOf(band))
        tiles[static_cast<std::size_t>(lattice.partOf(tile))].push_back(tile);
    const std::size_t pixelSize = head_.pixelBytes();
    parallelFor(static_cast<std::uint32_t>(count), threads_, [&](std::uint32_t i) {
        if (tiles[i + 1].empty()) return;
        PartHead head = head_;
        head.part.number = static_cast<int>(i) + 1;
        std::vector<char> pixels(pixelSize * here[i + 1]);
        PartFile::readPixels(paths_[i], head, pixelSize * before[i + 1], pixels);
        const char* from = pixels.data();
        for (const PixelRectangle& tile : tiles[i + 1]) {
            copyTile(tile, from, band, image);
            from += pixelSize * static_cast<std::size_t>(tile.area());
        }
    });
    return image;
}

template ByteImage PartFiles::read(const PixelRectangle&) const;
template FloatImage PartFiles::read(const PixelRectangle&) const;

}  // namespace raytracer
