#include "raytracer/pictures/part_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <libdeflate.h>

#include "raytracer/json/json_view.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

constexpr std::string_view partMagic = "raytracer part 1 ";
constexpr std::size_t sizeDigits = 8, magicSize = partMagic.size() + sizeDigits + 1;
constexpr std::size_t longestHead = 1 << 20;
constexpr double mostEdge = 1 << 16;

std::string hexadecimal(std::size_t number) { return formatted("%08zx", number); }

std::string headText(const PartHead& head) {
    JsonWriter json;
    json.beginObject();
    json.key("version").value(head.version);
    json.key("scene").value(head.scene);
    json.key("options").value(head.options);
    json.key("size").values(std::array{head.size.width, head.size.height});
    const PixelRectangle& crop = head.crop;
    json.key("crop").values(std::array{crop.x0, crop.y0, crop.x1, crop.y1});
    json.key("float").value(head.isFloat);
    json.key("reached").value(head.isReached);
    json.key("part").values(std::array{head.part.number, head.part.count});
    json.endObject();
    return json.text() + "\n";
}

// An array of whole numbers, each from `least` to `most`.
template <std::size_t count>
std::array<int, count> wholeNumbers(JsonView view, double least, double most) {
    std::array<double, count> numbers{};
    view.numbers(numbers);
    std::array<int, count> whole{};
    for (std::size_t i = 0; i < count; ++i) {
        if (!(numbers[i] >= least && numbers[i] <= most)) view.fail("out of range");
        whole[i] = static_cast<int>(numbers[i]);
    }
    return whole;
}

JsonView member(JsonView object, std::string_view key) {
    const auto found = object.find(key);
    if (!found) object.fail("no " + std::string(key));
    return *found;
}

PartHead headOf(JsonView json) {
    PartHead head;
    head.version = member(json, "version").string();
    head.scene = member(json, "scene").string();
    head.options = member(json, "options").string();
    const auto size = wholeNumbers<2>(member(json, "size"), 1, mostEdge);
    head.size = {size[0], size[1]};
    const JsonView cropView = member(json, "crop");
    const auto crop = wholeNumbers<4>(cropView, 0, mostEdge);
    head.crop = {crop[0], crop[1], crop[2], crop[3]};
    if (head.crop.width() < 1 || head.crop.height() < 1) cropView.fail("out of range");
    head.isFloat = member(json, "float").boolean();
    head.isReached = member(json, "reached").boolean();
    const JsonView partView = member(json, "part");
    const auto part = wholeNumbers<2>(partView, 1, mostParts);
    head.part = {part[0], part[1]};
    if (part[0] > part[1]) partView.fail("out of range");
    return head;
}

[[noreturn]] void failPart(const std::string& path, const std::string& why) {
    throw Error({path}, "broken part of a picture: " + why);
}

}  // namespace

std::string partBeginning(const PartHead& head) {
    const std::string text = headText(head);
    return std::string(partMagic) + hexadecimal(text.size()) + "\n" + text;
}

std::string partChecksum(std::uint32_t crc) { return hexadecimal(crc); }

std::string sceneChecksum(std::span<const std::string> paths) {
    std::uint32_t crc = 0;
    for (const std::string& path : paths) {
        const FileBytes file(path, FileKind::Regular);
        crc = libdeflate_crc32(crc, file.text().data(), file.text().size());
    }
    return partChecksum(crc);
}

PartFile::PartFile(const std::string& path) : reader_(path) {
    std::string magic(std::min<std::uint64_t>(magicSize, reader_.size()), '\0');
    reader_.read(0, magic);
    if (!magic.starts_with(partMagic) || magic.size() < magicSize)
        throw Error({path}, "not a part of a picture: it does not begin with \"raytracer part 1\"");
    const std::size_t size = std::strtoul(magic.substr(partMagic.size(), sizeDigits).c_str(), nullptr, 16);
    begin_ = magicSize + size;
    if (size > longestHead || begin_ > reader_.size()) failPart(path, "it is cut short");
    std::string text(size, '\0');
    reader_.read(magicSize, text);
    try {
        head_ = headOf(JsonView(JsonDocument(path, text)));
    } catch (const Error&) {
        failPart(path, "its head cannot be read");
    }
    // readPixels() relies on this: it computes where the pixels begin from the head alone.
    if (magic + text != partBeginning(head_)) failPart(path, "its head is not as raytracer writes it");
    requireWhole(path);
}

void PartFile::requireWhole(const std::string& path) {
    const auto pixels = pixelsOfParts(head_.crop, head_.part.count);
    const std::uint64_t end =
        begin_ + head_.pixelBytes() * pixels[static_cast<std::size_t>(head_.part.number)];
    if (reader_.size() < end + partChecksumSize) failPart(path, "it is cut short");
    if (reader_.size() > end + partChecksumSize) failPart(path, "it goes on behind its end");
    std::vector<char> block(std::min<std::uint64_t>(end, 1 << 20));
    std::uint32_t crc = 0;
    for (std::uint64_t at = 0; at < end; at += block.size()) {
        block.resize(std::min<std::uint64_t>(block.size(), end - at));
        reader_.read(at, block);
        crc = libdeflate_crc32(crc, block.data(), block.size());
    }
    std::string checksum(partChecksumSize, '\0');
    reader_.read(end, checksum);
    if (checksum != partChecksum(crc)) failPart(path, "its checksum is wrong");
}

void PartFile::readPixels(const std::string& path, const PartHead& head, std::uint64_t offset,
                          std::span<char> bytes) {
    FileReader(path).read(partBeginning(head).size() + offset, bytes);
}

bool isPart(const std::string& path, const PartHead& head) {
    try {
        return headText(PartFile(path).head()) == headText(head);
    } catch (const Error&) {
        return false;
    }
}

}  // namespace raytracer
