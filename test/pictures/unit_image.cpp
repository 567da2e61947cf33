#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <random>
#include <thread>
#include <utility>

#include <libdeflate.h>
#include <stb_image_write.h>

#include "../../src/pictures/png_chunks.h"
#include "../support/test_folder.h"
#include "raytracer/pictures/image.h"
#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/error.h"

using namespace raytracer;

namespace {

ByteImage testPicture(int width, int height) {
    ByteImage image{{width, height}, {}};
    for (int i = 0; i < width * height * 3; ++i)
        image.pixels.push_back(static_cast<std::uint8_t>(i % 251 * 37));
    return image;
}

void append(void* to, void* bytes, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

std::string pngOf(int width, int height, int channels, const LargeVector<std::uint8_t>& pixels) {
    std::string png;
    stbi_write_png_to_func(append, &png, width, height, channels, pixels.data(), 0);
    return png;
}

// The PNG with each chunk's checksum as it must be.
std::string checksummed(std::string png) {
    for (std::size_t chunk = 8; chunk < png.size();) {
        std::size_t length = 0;
        for (std::size_t i = chunk; i < chunk + 4; ++i)
            length = length << 8 | static_cast<std::uint8_t>(png[i]);
        const std::uint32_t crc = libdeflate_crc32(0, &png[chunk + 4], length + 4);
        for (std::size_t i = 0; i < 4; ++i)
            png[chunk + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i));
        chunk += length + 12;
    }
    return png;
}

std::string jpegOf(const ByteImage& image) {
    std::string jpeg;
    stbi_write_jpg_to_func(append, &jpeg, image.width, image.height, 3, image.pixels.data(), 100);
    return jpeg;
}

// Files longer than this cannot be written while it lives: what a full disk does, at a place of our choice.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, signalBefore_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*signalBefore_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

}  // namespace

TEST_CASE("A channel becomes the nearest byte") {
    CHECK(toByte(0) == 0);
    CHECK(toByte(1) == 255);
    CHECK(toByte(-0.5) == 0);
    CHECK(toByte(1.5) == 255);
    CHECK(toByte(std::numeric_limits<double>::infinity()) == 255);
    CHECK(toByte(-std::numeric_limits<double>::infinity()) == 0);
    CHECK(toByte(std::nan("")) == 0);
    CHECK(toByte(std::numeric_limits<double>::denorm_min()) == 0);
    for (int tie = 0; tie < 255; ++tie) {
        const double half = (tie + 0.5) / 255;
        for (const double c : {std::nextafter(half, 0.0), half, std::nextafter(half, 1.0)})
            REQUIRE(toByte(c) == std::lround(255 * c));
    }
}

TEST_CASE("A PNG comes back as it was written") {
    const TestFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {64, 33}, {301, 200}}) {
        const ByteImage image = testPicture(width, height);
        writePng(folder.file("a.png"), image);
        const ByteImage read = readImage(folder.file("a.png"));
        CHECK(read.width == width);
        CHECK(read.height == height);
        CHECK(read.pixels == image.pixels);
    }
    CHECK(folder.fileCount() == 1);
}

// 128 KiB of rows are deflated together.
TEST_CASE("A PNG of several deflated pieces comes back, the same from any number of threads") {
    const TestFolder folder;
    const auto check = [&](const ByteImage& image) {
        writePng(folder.file("a.png"), image, 3);
        CHECK((readImage(folder.file("a.png")).pixels == image.pixels));
        CHECK((encodePng(image, {}, 1) == encodePng(image, {}, 3)));
    };
    ByteImage image{{500, 301}, LargeVector<std::uint8_t>(500 * 301 * 3, 0)};
    SECTION("of one colour: fixed codes") { check(image); }
    SECTION("like a render: codes of each block's own") { check(testPicture(500, 301)); }
    SECTION("noise: stored blocks") {
        std::mt19937 random(1);
        for (std::uint8_t& channel : image.pixels) channel = static_cast<std::uint8_t>(random());
        check(image);
    }
    SECTION("noise among what repeats: blocks of several kinds in a piece") {
        std::mt19937 random(1);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = static_cast<std::uint8_t>(i / 20000 % 2 ? random() : i % 7);
        check(image);
    }
}

TEST_CASE("Pictures of every kind are read as 8-bit RGB") {
    const TestFolder folder;
    const auto pixels = [&](const std::string& bytes) { return readImage(folder.write("a", bytes)).pixels; };
    using Bytes = LargeVector<std::uint8_t>;
    SECTION("alpha is dropped") {
        CHECK(pixels(pngOf(2, 1, 4, {1, 2, 3, 0, 4, 5, 6, 99})) == Bytes{1, 2, 3, 4, 5, 6});
    }
    SECTION("grey is spread") { CHECK(pixels(pngOf(1, 2, 1, {7, 8})) == Bytes{7, 7, 7, 8, 8, 8}); }
    SECTION("grey with alpha") { CHECK(pixels(pngOf(1, 1, 2, {7, 8})) == Bytes{7, 7, 7}); }
    SECTION("16 bits: one pixel 0x1234, 0xabcd, 0xff00") {
        const char png[] =
            "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x10\2\0\0\0@@@@"
            "\0\0\0\x12IDAT\x78\x01\x01\x07\0\xf8\xff\0\x12\x34\xab\xcd\xff\0\x08\x88\x02\xbe@@@@"
            "\0\0\0\0IEND@@@@";
        const std::string path = folder.write("a", checksummed({png, sizeof png - 1}));
        CHECK(readTexture(path).deepTexels == LargeVector<std::uint16_t>{0x1234, 0xabcd, 0xff00});
        CHECK(readTexture(path).texels.empty());
        CHECK(readImage(path).pixels == Bytes{0x12, 0xab, 0xfe});  // 65280 / 257 = 254.0
    }
    SECTION("JPEG") {
        const ByteImage flat{{9, 9}, Bytes(9 * 9 * 3, 100)};
        const ByteImage read = readImage(folder.write("a.jpg", jpegOf(flat)));
        CHECK(read.width == 9);
        for (const int byte : read.pixels) REQUIRE(std::abs(byte - 100) <= 1);
    }
}

TEST_CASE("A picture that cannot be read is told") {
    const TestFolder folder;
    const auto check = [&](const std::string& bytes, const std::string& message) {
        CHECK_THROWS_WITH(readImage(folder.write("a.png", bytes)), folder.file("a.png") + ": " + message);
    };
    const std::string png = pngOf(20, 20, 3, testPicture(20, 20).pixels), jpeg = jpegOf(testPicture(20, 20));
    check("", "it is empty");
    check("{}", "it is no PNG, JPEG or PFM picture: convert it to PNG");
    check("GIF89a", "it is a GIF picture: convert it to PNG");
    check("BM6\3\0\0", "it is a BMP picture: convert it to PNG");
    check("RIFF@@@@WEBPVP8", "it is a WebP picture: convert it to PNG");
    check({"\0\0\0\x1c"
           "ftypheic",
           12},
          "it is a HEIC or AVIF picture: convert it to PNG");
    check({"II*\0", 4}, "it is a TIFF picture: convert it to PNG");
    check({"MM\0*", 4}, "it is a TIFF picture: convert it to PNG");
    check("P6 1 1 255\n@@@", "it is a PPM picture: convert it to PNG");
    check("PF\n1 1\n-1\n", "it is a PFM picture: convert it to PNG");
    check(png.substr(0, png.size() / 2), "broken PNG picture: it is cut short, or a checksum in it is wrong");
    check(jpeg.substr(0, jpeg.size() - 10), "broken JPEG picture: it has no end marker");
    CHECK_THROWS_WITH(readImage(folder.file("nowhere.png")),
                      folder.file("nowhere.png") + ": cannot read: No such file or directory");
    CHECK_THROWS_WITH(readImage(folder.file("")),
                      folder.file("") + ": cannot read: Is a directory; name a file in it");
    CHECK_THROWS_AS(readImage(folder.file("")), Error);
}

TEST_CASE("A picture that stb cannot hold is told, with its size and the limit") {
    const TestFolder folder;
    const auto check = [&](const std::string& size, const std::string& kind, const std::string& message) {
        std::string png = pngOf(20, 20, 3, testPicture(20, 20).pixels);
        png.replace(16, 8, size);  // IHDR's width and height
        png.replace(24, 2, kind);  // bit depth, colour type
        if (kind[1] == 3) png.insert(33, {"\0\0\0\3PLTE\1\2\3@@@@", 15});
        CHECK_THROWS_WITH(readImage(folder.write("a.png", checksummed(png))),
                          folder.file("a.png") + ": " + message);
    };
    const std::string square("\0\0\x4e\x20\0\0\x4e\x20", 8), flat("\1\0\0\1\0\0\0\1", 8);
    check(square, "\x8\2", "20000 × 20000 pixels: at most 357913941 of 3 channels");
    check(square, "\x8\3", "20000 × 20000 pixels: at most 268435456 of 4 channels");
    check(square, "\x10\6", "20000 × 20000 pixels: at most 266338303 of 4 channels");
    check(std::string("\0\0\x80\0\0\0\x80\0", 8), {"\x8\0", 2},
          "32768 × 32768 pixels: at most 710235477 of 3 channels");
    check(flat, "\x8\2", "16777217 × 1 pixels: at most 16777216 on a side");
    check({"\0\0\0\1\1\0\0\1", 8}, "\x8\2", "1 × 16777217 pixels: at most 16777216 on a side");
}

TEST_CASE("A PNG whose data cannot be inflated is told") {
    const TestFolder folder;
    const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\2\0\0\0@@@@", 33);
    const std::string end("\0\0\0\0IEND@@@@", 12);
    for (const std::string data : {"\x78\x9c\xff\xff", "\x78\x9c\1\1", "@@@@"}) {
        const std::string chunk = std::string("\0\0\0\4IDAT", 8) + data + "@@@@";
        const std::string path = folder.write("a.png", checksummed(head + chunk + end));
        CHECK_THROWS_WITH(readImage(path), path + ": broken PNG picture: its compressed data are broken");
    }
}

TEST_CASE("A PNG whose pixels have another checksum (Adler-32) is refused") {
    const TestFolder folder;
    std::string png = pngOf(5, 4, 3, testPicture(5, 4).pixels);
    png[png.size() - 17] ^= 1;  // before the checksum of the last chunk of pixels, and the chunk IEND
    const std::string path = folder.write("a.png", checksummed(png));
    CHECK_THROWS_WITH(readImage(path), path + ": broken PNG picture: its compressed data are broken");
}

TEST_CASE("A PNG's first chunk of pixels may be empty") {
    const TestFolder folder;
    const ByteImage image = testPicture(5, 4);
    std::string png = pngOf(5, 4, 3, image.pixels);
    png.insert(33, {"\0\0\0\0IDAT@@@@", 12});  // behind the header
    CHECK(readImage(folder.write("a.png", checksummed(png))).pixels == image.pixels);
}

TEST_CASE("What a PNG's header says") {
    const auto headerOf = [](const std::string& bytes) { return std::string(8, '@') + bytes; };
    const std::string five = headerOf({"\0\0\0\5\0\0\0\5\x8\0\0\0\1", 13});
    CHECK(sizeOf(five).width == 5);
    CHECK(channelsOf(five) == 1);
    CHECK(bitDepthOf(five) == 8);
    CHECK(inflatedSize(five) == 25 + 11);  // interlaced: 11 rows
    CHECK(inflatedSize(headerOf({"\0\0\0\1\0\0\0\1\x8\0\0\0\1", 13})) == 2);
    CHECK(inflatedSize(headerOf({"\0\0\0\5\0\0\0\3\x10\6\0\0\0", 13})) == 3 * (1 + 5 * 8));
    CHECK(inflatedSize(headerOf({"\0\0\0\x9\0\0\0\3\1\3\0\0\0", 13})) == 3 * (1 + 2));
    CHECK(hasDeepTexels(headerOf({"\0\0\0\5\0\0\0\3\x10\2\0\0\0", 13})));
    CHECK_FALSE(hasDeepTexels(""));
}

namespace {

// A segment of a JPEG: its marker's second byte, and what is in it.
std::string segmentOf(int marker, const std::string& content) {
    const std::size_t length = content.size() + 2;
    const char head[] = {'\xff', static_cast<char>(marker), static_cast<char>(length >> 8),
                         static_cast<char>(length)};
    return std::string(head, sizeof head) + content;
}

// Huffman tables: class and number, how many codes of each length, their values.
std::string tableOf(int table, const std::vector<int>& counts) {
    std::string content(1, static_cast<char>(table));
    std::size_t codes = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        content += static_cast<char>(i < counts.size() ? counts[i] : 0);
        codes += static_cast<std::size_t>(i < counts.size() ? counts[i] : 0);
    }
    return segmentOf(0xc4, content + std::string(codes, '\0'));
}

// A grey JPEG of 8 x 8 pixels, of which every coefficient is 0.
struct GreyJpeg {
    std::string quantisation = segmentOf(0xdb, std::string(1, '\0') + std::string(64, '\1'));
    std::string frame = segmentOf(0xc0, {"\x8\0\x8\0\x8\1\1\x11\0", 9});
    std::string constantTable = tableOf(0x00, {1}), otherTable = tableOf(0x10, {1});
    std::string scan = segmentOf(0xda, {"\1\1\0\0\x3f\0", 6}) + '\0';
    std::string end = "\xff\xd9";

    std::string bytes() const {
        return "\xff\xd8" + quantisation + frame + constantTable + otherTable + scan + end;
    }
};

}  // namespace

// A graded program's picture is asked for its size before anything of it has been checked.
TEST_CASE("The size in a picture's header is read whatever stands around it") {
    const TestFolder folder;
    const auto sizeOfFile = [&](const std::string& bytes) -> std::vector<int> {
        const auto size = sizeInHeader(FileBytes(folder.write("a", bytes)));
        return size ? std::vector{size->width, size->height} : std::vector<int>();
    };
    GreyJpeg jpeg;
    jpeg.quantisation += tableOf(0x00, std::vector<int>(16, 255));  // stb writes past its table
    jpeg.frame = segmentOf(0xc2, {"\x8\0\x7\1\2\1\1\x11\0", 9});
    CHECK(sizeOfFile(jpeg.bytes()) == std::vector{258, 7});
    CHECK(sizeOfFile(jpeg.bytes().substr(0, 30)).empty());
    jpeg.frame = segmentOf(0xc2, {"\x8\0\0\1\2\1\1\x11\0", 9});  // no height
    CHECK(sizeOfFile(jpeg.bytes()).empty());
    jpeg.frame.clear();
    CHECK(sizeOfFile(jpeg.bytes()).empty());
    const std::string png("\x89PNG\r\n\x1a\n\0\0\0\xdIHDR\0\0\1\0\0\0\0\3", 24);
    CHECK(sizeOfFile(png) == std::vector{256, 3});
    CHECK(sizeOfFile(png.substr(0, 23)).empty());
    CHECK(sizeOfFile(png.substr(0, 16) + "\xff" + png.substr(17)).empty());
    CHECK(sizeOfFile(png.substr(0, 12) + "IEND" + png.substr(16)).empty());
    CHECK(sizeOfFile("").empty());
}

TEST_CASE("A JPEG is read if its segments are sound") {
    const TestFolder folder;
    const auto read = [&](const GreyJpeg& jpeg) {
        return readImage(folder.write("a.jpg", jpeg.bytes())).pixels;
    };
    const auto refused = [&](const GreyJpeg& jpeg, const std::string& why) {
        CHECK_THROWS_WITH(read(jpeg), folder.file("a.jpg") + ": broken JPEG picture: " + why);
    };
    GreyJpeg jpeg;
    const std::string thumbnail = segmentOf(0xe1, "Exif" + GreyJpeg().bytes());
    REQUIRE(read(jpeg) == LargeVector<std::uint8_t>(64 * 3, 128));
    SECTION("with a thumbnail, fill bytes, and something behind the end") {
        jpeg.quantisation = thumbnail + "\xff\xff\xff" + jpeg.quantisation;
        jpeg.end += "behind";
        CHECK(read(jpeg) == LargeVector<std::uint8_t>(64 * 3, 128));
    }
    SECTION("an end marker in the thumbnail is not the picture's") {
        jpeg.quantisation = thumbnail + jpeg.quantisation;
        jpeg.end = "";
        refused(jpeg, "it has no end marker");
        jpeg.end = "\xff";
        refused(jpeg, "it has no end marker");
        jpeg.end = "\xff\xe1";
        refused(jpeg, "it has no end marker");
        jpeg.scan = jpeg.scan.substr(0, 5);
        refused(jpeg, "it has no end marker");
    }
    SECTION("Huffman tables") {
        jpeg.otherTable = tableOf(0x10, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 200, 57});
        refused(jpeg, "a Huffman table has more codes than there are");  // than values of a byte
        jpeg.otherTable = tableOf(0x10, {2});
        refused(jpeg, "a Huffman table has more codes than there are");  // of ones alone there is none
        jpeg.otherTable = tableOf(0x10, {1, 0, 4});
        refused(jpeg, "a Huffman table has more codes than there are");
        jpeg.otherTable = tableOf(0x24, {1});
        refused(jpeg, "a Huffman table has no such number");
        jpeg.otherTable = segmentOf(0xc4, tableOf(0x10, {1, 1}).substr(4, 18));
        refused(jpeg, "a segment has not the length that it says");
        jpeg.otherTable = "\xff\xc4" + std::string("\0\1", 2);
        refused(jpeg, "a segment has not the length that it says");
    }
    SECTION("quantisation tables") {
        jpeg.quantisation = segmentOf(0xdb, std::string(1, '\4') + std::string(64, '\1'));
        refused(jpeg, "a quantisation table has no such number");
        jpeg.quantisation = segmentOf(0xdb, std::string(1, '\0') + std::string(63, '\1'));
        refused(jpeg, "a segment has not the length that it says");
    }
    SECTION("tables that are not there") {
        for (std::string* part : {&jpeg.quantisation, &jpeg.constantTable, &jpeg.otherTable}) {
            const std::string whole = std::exchange(*part, "");
            refused(jpeg, "a table that it uses is missing");
            *part = whole;
        }
    }
    SECTION("frame and scans") {
        const std::string whole = std::exchange(jpeg.scan, "");
        refused(jpeg, "it has no data for one of its components");
        jpeg.scan = segmentOf(0xda, {"\1\2\0\0\x3f\0", 6});
        refused(jpeg, "a scan is of a component that it does not have");
        jpeg.scan = segmentOf(0xda, {"\1\1\0\0\x3f", 5});
        refused(jpeg, "a segment has not the length that it says");
        jpeg.scan = whole;
        jpeg.frame += jpeg.frame;
        refused(jpeg, "it has two frame headers");
        jpeg.frame = segmentOf(0xc0, {"\x8\0\x8\0\x8\1\1\x11\0\0", 10});
        refused(jpeg, "a segment has not the length that it says");
        jpeg.frame = segmentOf(0xc2, {"\x8\0\x8\0\x8\1\1\x11\0", 9});
        jpeg.scan = segmentOf(0xda, {"\1\1\0\1\x3f\0", 6});  // its first scan without the constant terms
        refused(jpeg, "its scans are not in order");
        for (const int lossless : {0xc9, 0xf7}) {
            jpeg.frame = segmentOf(lossless, "");
            CHECK_THROWS_WITH(read(jpeg), folder.file("a.jpg") +
                                              ": cannot decode: neither a baseline nor a progressive JPEG");
        }
    }
    SECTION("too large a size") {
        jpeg.frame = segmentOf(0xc0, {"\x8\xff\xff\xff\xff\1\1\x11\0", 9});
        CHECK_THROWS_WITH(read(jpeg), folder.file("a.jpg") + ": 65535 × 65535 pixels: at most 536870911");
    }
    SECTION("no frame") {
        jpeg.frame = jpeg.scan = "";
        refused(jpeg, "it has no frame header");
    }
}

TEST_CASE("A PNG with any bit flipped is refused") {
    const TestFolder folder;
    const std::string png = pngOf(5, 4, 3, testPicture(5, 4).pixels);
    for (std::size_t bit = 0; bit < 8 * png.size(); ++bit) {
        std::string flipped = png;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        INFO("bit " << bit % 8 << " of byte " << bit / 8);
        CHECK_THROWS_AS(readImage(folder.write("a.png", flipped)), Error);
    }
}

TEST_CASE("What is wrong with a PNG's header, or missing behind it, is named") {
    const TestFolder folder;
    const auto check = [&](const std::string& header, const std::string& behind, const std::string& why) {
        const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
        const std::string path = folder.write(
            "a.png", checksummed(png + header + "@@@@" + behind + std::string("\0\0\0\0IEND@@@@", 12)));
        CHECK_THROWS_WITH(readImage(path), path + ": broken PNG picture: " + why);
    };
    const std::string sound("\0\0\0\4\0\0\0\4\x8\2\0\0\0", 13);
    const auto changed = [&](std::size_t place, char value) {
        std::string header = sound;
        header[place] = value;
        return header;
    };
    check(changed(3, 0), "", "its width is 0, which no PNG has");
    check(changed(7, 0), "", "its height is 0, which no PNG has");
    check(changed(0, '\x80'), "", "its width is 2147483652, which no PNG has");
    check(changed(8, 4), "", "its bit depth is 4, which no PNG of its colour type has");
    check(changed(9, 5), "", "its colour type is 5, which no PNG has");
    check(changed(10, 1), "", "its compression method is 1, which no PNG has");
    check(changed(11, 1), "", "its filter method is 1, which no PNG has");
    check(changed(12, 2), "", "its interlace method is 2, which no PNG has");
    check(sound, "", "it has no pixels (no chunk IDAT)");
    const std::string palette("\0\0\0\3PLTEabc@@@@", 15), four("\0\0\0\4PLTEabcd@@@@", 16),
        pixels("\0\0\0\0IDAT@@@@", 12);
    check(changed(9, 3), pixels + palette, "it has no palette before its pixels");
    check(changed(9, 3), four + pixels, "its palette has 4 bytes, not 3 for each of 1 to 256 colours");
}

TEST_CASE("A PNG with a palette") {
    // Colours red, green and blue, the second one transparent; three texels, each the byte of an uncompressed
    // block.
    const auto paletted = [](std::uint8_t a, std::uint8_t b, std::uint8_t c) {
        std::string bytes(
            "\0"
            "abc",
            4);
        bytes[1] = static_cast<char>(a), bytes[2] = static_cast<char>(b), bytes[3] = static_cast<char>(c);
        const std::uint32_t adler = libdeflate_adler32(1, bytes.data(), bytes.size());
        std::string zlib("\x78\x01\x01\x04\0\xfb\xff", 7);
        zlib += bytes;
        for (int shift = 24; shift >= 0; shift -= 8) zlib += static_cast<char>(adler >> shift);
        const char head[] =
            "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\3\0\0\0\1\x8\3\0\0\0@@@@"
            "\0\0\0\x9PLTE\xff\0\0\0\xff\0\0\0\xff@@@@\0\0\0\2tRNS\xff\0@@@@\0\0\0\xfIDAT";
        return checksummed(std::string(head, sizeof head - 1) + zlib +
                           std::string("@@@@\0\0\0\0IEND@@@@", 16));
    };
    const TestFolder folder;
    const auto read = [&](const std::string& png) { return readImage(folder.write("a.png", png)); };
    CHECK(read(paletted(2, 1, 0)).pixels == LargeVector<std::uint8_t>{0, 0, 255, 0, 255, 0, 255, 0, 0});
    for (const int beyond : {3, 4, 255})
        CHECK_THROWS_WITH(
            read(paletted(0, static_cast<std::uint8_t>(beyond), 1)),
            folder.file("a.png") + ": broken PNG picture: a texel has a colour beyond its palette");
}

// stb takes both, and then reads the chunks in another way than we do.
TEST_CASE("A PNG that does not begin with its header, or is made for iOS, is refused") {
    const TestFolder folder;
    const std::string png = pngOf(2, 1, 3, {1, 2, 3, 4, 5, 6});
    const auto refused = [&](const std::string& chunk, std::size_t place, const std::string& message) {
        std::string other = png;
        other.insert(place, chunk);
        CHECK_THROWS_WITH(readImage(folder.write("a.png", checksummed(other))),
                          folder.file("a.png") + ": " + message);
    };
    constexpr std::size_t afterSignature = 8, afterHeader = 33;
    for (const std::size_t place : {afterSignature, afterHeader})
        refused(std::string("\0\0\0\4CgBI\x50\0\x20\2@@@@", 16), place,
                "no PNG by the standard, but one made for iOS (CgBI)");
    refused(std::string("\0\0\0\0teSt@@@@", 12), afterSignature,
            "broken PNG picture: it does not begin with its header");
}

TEST_CASE("A PFM comes back to the bit, bottom row first in the file") {
    const TestFolder folder;
    const float inf = std::numeric_limits<float>::infinity();
    const FloatImage image{{2, 2},
                           {0, 1, -2.5F, 1e-40F, inf, 1e30F, 0.1F, 0.2F, 0.3F, -0.0F, std::nanf(""), 7}};
    OutputFile file(folder.file("a.pfm"));
    const auto writer = pfmWriter(file, {0, 0, 2, 2});
    writer->write(image);
    writer->finish();
    const std::string bytes = bytesOf(folder.file("a.pfm"));
    const std::string header = "PF\n2 2\n-1.0\n";
    REQUIRE(bytes.size() == header.size() + 48);
    CHECK(bytes.starts_with(header));
    CHECK(std::memcmp(bytes.data() + header.size(), image.pixels.data() + 6, 24) == 0);
    CHECK(std::memcmp(bytes.data() + header.size() + 24, image.pixels.data(), 24) == 0);

    const FloatImage read = readPfm(folder.file("a.pfm"));
    CHECK(read.width == 2);
    CHECK(read.height == 2);
    CHECK(std::memcmp(read.pixels.data(), image.pixels.data(), 48) == 0);
}

TEST_CASE("A PFM of the other byte order is read") {
    const TestFolder folder;
    const std::string bytes("PF 1 1 2\n\x3f\x80\0\0\xc0\x20\0\0\0\0\0\0", 21);
    CHECK(readPfm(folder.write("a.pfm", bytes)).pixels == LargeVector<float>{1, -2.5F, 0});
}

TEST_CASE("A PFM whose header ends in more than one blank is read where the size tells") {
    const TestFolder folder;
    const auto read = [&](const std::string& bytes) { return readPfm(folder.write("a.pfm", bytes)).pixels; };
    const std::string twelve("\x3f\x80\0\0\xc0\x20\0\0\0\0\0\0", 12);
    CHECK(read("PF\r\n1 1\r\n1.0\r\n" + twelve) == LargeVector<float>{1, -2.5F, 0});
    CHECK(read("PF\n1 1 \n1.0 \n" + twelve) == LargeVector<float>{1, -2.5F, 0});
    // Here the newline is the first pixel's first byte.
    CHECK(read("PF 1 1 1.0\r\n" + twelve.substr(1)).at(1) == -2.5F);
}

TEST_CASE("A PFM that is broken is told") {
    const TestFolder folder;
    const auto check = [&](const std::string& bytes, const std::string& message) {
        CHECK_THROWS_WITH(readPfm(folder.write("a.pfm", bytes)), folder.file("a.pfm") + ": " + message);
    };
    check("", "not a colour PFM picture: it does not begin with \"PF\"");
    check("Pf\n1 1\n-1.0\n1234", "not a colour PFM picture: it does not begin with \"PF\"");
    check("PF\n1 x\n-1.0\n", "not a PFM picture: its height is no number");
    check("PF\n99999999999 99999999999\n-1.0\n",
          "cannot read: its width is too large, \"99999999999\": at most 2147483647");
    check("PF\n2147483648 2\n-1.0\n",
          "cannot read: its width is too large, \"2147483648\": at most 2147483647");
    check("PF\n2 2147483648\n-1.0\n",
          "cannot read: its height is too large, \"2147483648\": at most 2147483647");
    check("PF\n-2147483649 2\n-1.0\n", "not a PFM picture: it has no pixels");
    check("PF\n1 1", "not a PFM picture: its scale is no number");
    for (const char* scale : {"0", "-0.0", "-1e-400"})
        check(std::string("PF\n1 1\n") + scale + "\n123456789012",
              "not a PFM picture: its scale is 0, which has no sign to tell the byte order");
    for (const char* scale : {"nan", "inf", "-inf", "-1e400"})
        check(std::string("PF\n1 1\n") + scale + "\n123456789012",
              "not a PFM picture: its scale is no finite number");
    check("PF\n0 1\n-1.0\n", "not a PFM picture: it has no pixels");
    check("PF\n1 1\n-1.0", "broken PFM picture: it ends before its last pixel");
    check("PF\n1 1\n-1.0\n12345678901", "broken PFM picture: it ends before its last pixel");
    check("PF\n1 1\n-1.0\n123456789012\n", "broken PFM picture: it goes on behind its last pixel");
    check("PF\n1 1\n-1.0\r\n123456789012x", "broken PFM picture: it goes on behind its last pixel");
    check("PF\n2147483647 2147483647\n-1.0\n123", "broken PFM picture: it ends before its last pixel");
    // 12 bytes a pixel are 2^64 and 2504 more.
    check("PF 1304999805 1177953182 1\n" + std::string(2504, 'x'),
          "broken PFM picture: it ends before its last pixel");
    CHECK_THROWS_AS(readPfm(folder.file("nowhere.pfm")), Error);
    CHECK_THROWS_WITH(readPfm(folder.file("nowhere.pfm")),
                      folder.file("nowhere.pfm") + ": cannot read: No such file or directory");
}

TEST_CASE("A picture is written whole or not at all") {
    const TestFolder folder;
    const ByteImage image = testPicture(100, 100);
    SECTION("the folder is missing") {
        CHECK_THROWS_AS(writePng(folder.file("no/a.png"), image), Error);
        CHECK_THROWS_WITH(writePng(folder.file("no/a.png"), image),
                          folder.file("no/a.png") +
                              ": cannot write: No such file or directory; there is no folder \"" +
                              folder.file("no") + "\"");
        CHECK(folder.fileCount() == 0);
    }
    SECTION("a folder has the name") {
        CHECK_THROWS_WITH(writePng(folder.file(""), image),
                          folder.file("") + ": cannot write: Is a directory");
        CHECK(folder.fileCount() == 0);
    }
    SECTION("writing stops in the middle") {
        folder.write("a.png", "as it was");
        {
            const FileSizeLimit limit(1000);
            CHECK_THROWS_WITH(writePng(folder.file("a.png"), image),
                              folder.file("a.png") + ": cannot write: File too large");
        }
        CHECK(bytesOf(folder.file("a.png")) == "as it was");
        CHECK(folder.fileCount() == 1);
    }
    SECTION("over what stood there, in place of nothing else") {
        folder.write("a.png", std::string(1 << 20, 'x'));
        writePng(folder.file("a.png"), image);
        CHECK(readImage(folder.file("a.png")).pixels == image.pixels);
        CHECK(folder.fileCount() == 1);
    }
    SECTION("through a symbolic link") {
        folder.write("a.png", "as it was");
        std::filesystem::create_symlink("a.png", folder.file("link.png"));
        writePng(folder.file("link.png"), image);
        CHECK(std::filesystem::is_symlink(folder.file("link.png")));
        CHECK(readImage(folder.file("a.png")).pixels == image.pixels);
    }
    SECTION("a pipe, as a device, is written in place") {
        REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
        std::fstream keptOpen(
            folder.file("pipe"));  // for reading too, so that opening it to write does not wait
        writePng(folder.file("pipe"), testPicture(1, 1));
        CHECK(std::filesystem::is_fifo(folder.file("pipe")));
        CHECK(folder.fileCount() == 1);
    }
    SECTION("too large for PNG") {
        CHECK_THROWS_WITH(writePng(folder.file("a.png"), {50000, 50000, {}}),
                          folder.file("a.png") + ": cannot write: the picture is too large for PNG");
    }
}

TEST_CASE("A picture is read from a pipe") {
    const TestFolder folder;
    REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
    const ByteImage image = testPicture(300, 300);  // more than the pipe holds at once
    std::thread writer([&] { folder.write("pipe", pngOf(300, 300, 3, image.pixels)); });
    CHECK(readImage(folder.file("pipe")).pixels == image.pixels);
    writer.join();
}
