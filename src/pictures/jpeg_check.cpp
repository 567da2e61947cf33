#include "jpeg_check.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

#include "raytracer/util/error.h"

namespace raytracer {
namespace {

// The second byte of a marker, after 0xff.
enum Marker : std::uint8_t {
    progressiveFrame = 0xc2,
    huffmanTables = 0xc4,
    restart0 = 0xd0,
    restart7 = 0xd7,
    startOfImage = 0xd8,
    endOfImage = 0xd9,
    startOfScan = 0xda,
    quantisationTables = 0xdb,
    losslessFrame = 0xf7,  // of JPEG-LS
};

// The markers 0xc0 to 0xcf are frame headers, except three: DHT (huffmanTables), JPG (0xc8) and DAC (0xcc).
bool isFrame(std::uint8_t marker) {
    const bool isOther = marker == huffmanTables || marker == 0xc8 || marker == 0xcc;
    return (marker >= 0xc0 && marker <= 0xcf && !isOther) || marker == losslessFrame;
}

std::uint8_t byteAt(std::string_view text, std::size_t at) { return static_cast<std::uint8_t>(text[at]); }

class JpegCheck {
  public:
    explicit JpegCheck(const FileBytes& file) : file_(file), rest_(file.text()) {}

    void check() {
        for (std::uint8_t marker = nextMarker(); marker != endOfImage; marker = nextMarker()) {
            if (marker == startOfImage) continue;
            segment_ = takeSegment();
            if (marker == huffmanTables) checkHuffmanTables();
            else if (marker == quantisationTables) checkQuantisationTables();
            else if (isFrame(marker)) checkFrame(marker);
            else if (marker == startOfScan) checkScan();
        }
        for (const Component& component : components_)
            require(component.isScanned, "it has no data for one of its components");
        require(!components_.empty(), "it has no frame header");
    }

    ImageSize size() {
        for (;;) {
            const std::uint8_t marker = nextMarker();
            require(marker != endOfImage, "it has no frame header");
            if (marker == startOfImage) continue;
            segment_ = takeSegment();
            if (!isFrame(marker)) continue;
            skip(1);  // bits per sample
            const int height = takeNumber();
            return {takeNumber(), height};
        }
    }

  private:
    struct Component {
        std::uint8_t name, quantisation;
        bool isScanned = false;
    };

    void require(bool holds, const char* what) const {
        if (!holds) file_.fail(std::string("broken JPEG picture: ") + what);
    }
    void requireWhole(bool holds) const { require(holds, "a segment has not the length that it says"); }

    // The next marker that is not a restart. Skips compressed data, in which a 0 follows each 0xff that is no
    // marker, and fill bytes.
    std::uint8_t nextMarker() {
        for (;;) {
            rest_.remove_prefix(std::min(rest_.find('\xff'), rest_.size()));
            rest_.remove_prefix(std::min(rest_.find_first_not_of('\xff'), rest_.size()));
            require(!rest_.empty(), "it has no end marker");
            const std::uint8_t marker = byteAt(rest_, 0);
            rest_.remove_prefix(1);
            if (marker != 0 && (marker < restart0 || marker > restart7)) return marker;
        }
    }

    // A segment is a length in two bytes, which counts these two, and its content.
    std::string_view takeSegment() {
        require(rest_.size() >= 2, "it has no end marker");
        const std::size_t length = std::size_t{byteAt(rest_, 0)} << 8 | byteAt(rest_, 1);
        requireWhole(length >= 2);
        require(length <= rest_.size(), "it has no end marker");
        const std::string_view segment = rest_.substr(2, length - 2);
        rest_.remove_prefix(length);
        return segment;
    }

    std::uint8_t takeByte() {
        requireWhole(!segment_.empty());
        const std::uint8_t byte = byteAt(segment_, 0);
        segment_.remove_prefix(1);
        return byte;
    }

    int takeNumber() {  // of two bytes
        const int high = takeByte();
        return high << 8 | takeByte();
    }

    void skip(std::size_t count) {
        requireWhole(count <= segment_.size());
        segment_.remove_prefix(count);
    }

    // A table has a class and a number, the number of codes of each length from 1 to 16 bits, and the codes'
    // values. No code is a prefix of another, and none is all ones.
    void checkHuffmanTables() {
        while (!segment_.empty()) {
            const std::uint8_t table = takeByte();
            require((table & 0xf) < 4 && table >> 4 < 2, "a Huffman table has no such number");
            std::size_t codes = 0, room = 1;
            for (int length = 1; length <= 16; ++length) {
                const std::size_t ofThisLength = takeByte();
                room *= 2;
                require(ofThisLength < room, "a Huffman table has more codes than there are");
                room -= ofThisLength;
                codes += ofThisLength;
            }
            require(codes <= 256, "a Huffman table has more codes than there are");
            skip(codes);
            huffman_.set(table);
        }
    }

    void checkQuantisationTables() {
        while (!segment_.empty()) {
            const std::uint8_t table = takeByte();
            require((table & 0xf) < 4 && table >> 4 < 2, "a quantisation table has no such number");
            skip(table >> 4 == 0 ? 64 : 128);
            quantisation_.set(table & 0xf);
        }
    }

    // A frame has the bits per sample, height and width, and for each component its name, sampling factors
    // and quantisation table.
    void checkFrame(std::uint8_t marker) {
        if (marker > progressiveFrame) file_.fail("cannot decode: neither a baseline nor a progressive JPEG");
        require(components_.empty(), "it has two frame headers");
        isProgressive_ = marker == progressiveFrame;
        skip(5);
        for (std::size_t count = takeByte(); count > 0; --count) {
            const std::uint8_t name = takeByte();
            skip(1);
            components_.push_back({name, takeByte()});
        }
        requireWhole(segment_.empty());
    }

    // A scan has, for each of its components, its name and its Huffman tables: one for the DC coefficients
    // (class 0), one for the AC ones. Then come the first and the last coefficient, and which of their bits.
    void checkScan() {
        const std::size_t count = takeByte();
        requireWhole(segment_.size() == 2 * count + 3);
        const std::uint8_t firstTerm = byteAt(segment_, 2 * count),
                           lastTerm = byteAt(segment_, 2 * count + 1), bits = byteAt(segment_, 2 * count + 2);
        for (std::size_t i = 0; i < count; ++i) {
            const auto found = std::ranges::find(components_, takeByte(), &Component::name);
            require(found != components_.end(), "a scan is of a component that it does not have");
            const std::uint8_t tables = takeByte();
            const auto hasHuffman = [&](int table) {
                return table < 32 && huffman_[static_cast<std::size_t>(table)];
            };
            const bool isFirstScan = !isProgressive_ || bits >> 4 == 0;
            require((firstTerm != 0 || !isFirstScan || hasHuffman(tables >> 4)) &&
                        ((isProgressive_ && lastTerm == 0) || hasHuffman(0x10 | (tables & 0xf))) &&
                        found->quantisation < 4 && quantisation_[found->quantisation],
                    "a table that it uses is missing");
            require(found->isScanned || (firstTerm == 0 && isFirstScan), "its scans are not in order");
            found->isScanned = true;
        }
    }

    const FileBytes& file_;
    std::string_view rest_, segment_;
    std::vector<Component> components_;
    bool isProgressive_ = false;
    std::bitset<32> huffman_;      // by class and number
    std::bitset<4> quantisation_;  // by number
};

}  // namespace

// As in stb, any number of 0xff may stand before a marker.
bool isJpeg(const FileBytes& file) {
    const std::string_view text = file.text();
    const std::size_t marker = text.find_first_not_of('\xff');
    return marker > 0 && marker != text.npos && byteAt(text, marker) == startOfImage;
}

std::optional<ImageSize> sizeOfJpeg(const FileBytes& file) {
    try {
        const ImageSize size = JpegCheck(file).size();
        return size.area() > 0 ? std::optional(size) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

void requireSoundJpeg(const FileBytes& file) { JpegCheck(file).check(); }

}  // namespace raytracer
