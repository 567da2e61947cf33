// Time against size for PNG: stb's row filters by name (adaptive: the best of each row, by its own estimate)
// and libdeflate's levels. Usage: png_levels PICTURE [LONG_EDGE]; the picture is scaled (bilinear) to
// LONG_EDGE pixels.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <stb_image_write.h>

#include "raytracer/pictures/image.h"

namespace {

using raytracer::ByteImage;

std::uint8_t sample(const ByteImage& image, double x, double y, int channel) {
    const int x0 = std::clamp(static_cast<int>(x), 0, std::max(image.width - 2, 0));
    const int y0 = std::clamp(static_cast<int>(y), 0, std::max(image.height - 2, 0));
    const auto at = [&](int dx, int dy) -> double {
        return image.pixels[static_cast<std::size_t>((y0 + dy) * image.width + x0 + dx) * 3 + channel];
    };
    const double top = std::lerp(at(0, 0), at(1, 0), x - x0), bottom = std::lerp(at(0, 1), at(1, 1), x - x0);
    return static_cast<std::uint8_t>(std::lround(std::lerp(top, bottom, y - y0)));
}

ByteImage enlarge(const ByteImage& image, int longEdge) {
    const double scale = static_cast<double>(longEdge) / std::max(image.width, image.height);
    ByteImage out{{static_cast<int>(image.width * scale), static_cast<int>(image.height * scale)}, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double sourceX = std::min(x / scale, image.width - 1.0);
                const double sourceY = std::min(y / scale, image.height - 1.0);
                out.pixels.push_back(sample(image, sourceX, sourceY, c));
            }
    return out;
}

struct Result {
    double milliseconds;
    std::size_t bytes;
};

Result encode(const ByteImage& image, int filter, int level) {
    stbi_write_force_png_filter = filter;
    stbi_write_png_compression_level = level;
    std::size_t bytes = 0;
    const auto start = std::chrono::steady_clock::now();
    const auto count = [](void* total, void*, int size) { *static_cast<std::size_t*>(total) += size; };
    stbi_write_png_to_func(count, &bytes, image.width, image.height, 3, image.pixels.data(), 0);
    return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
            bytes};
}

Result medianOf5(const ByteImage& image, int filter, int level) {
    std::vector<Result> runs;
    for (int i = 0; i < 5; ++i) runs.push_back(encode(image, filter, level));
    std::ranges::sort(runs, {}, &Result::milliseconds);
    return runs[2];
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "usage: png_levels PICTURE [LONG_EDGE]\n"), 2;
    ByteImage image = raytracer::readImage(std::string(argv[1]));
    if (argc > 2) image = enlarge(image, std::atoi(argv[2]));
    std::printf("%d x %d: milliseconds (median of 5) / KiB\nlevel", image.width, image.height);
    for (const char* name : {"none", "sub", "up", "average", "Paeth", "adaptive"}) std::printf("%18s", name);
    for (int level = 1; level <= 12; ++level) {
        std::printf("\n%5d", level);
        for (const int filter : {0, 1, 2, 3, 4, -1}) {
            const Result result = medianOf5(image, filter, level);
            std::printf("%9.2f /%7.1f", result.milliseconds, static_cast<double>(result.bytes) / 1024);
            std::fflush(stdout);
        }
    }
    std::printf("\n");
}
