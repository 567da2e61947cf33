// How fast a mesh of a million triangles loads: reading its bytes alone, our loader, tinyobjloader. Usage:
// obj_speed [GRID]; the mesh is a wavy grid of GRID x GRID squares (707 makes a million triangles) in the
// temporary folder.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "raytracer/scene/mesh_file.h"

namespace {

void writeVertices(std::FILE* file, int grid) {
    for (int y = 0; y <= grid; ++y)
        for (int x = 0; x <= grid; ++x) {
            const double u = static_cast<double>(x) / grid, v = static_cast<double>(y) / grid;
            std::fprintf(file, "v %.6f %.6f %.6f\n", u, v, 0.1 * std::sin(20 * u) * std::cos(15 * v));
        }
    for (int y = 0; y <= grid; ++y)
        for (int x = 0; x <= grid; ++x)
            std::fprintf(file, "vt %.6f %.6f\n", static_cast<double>(x) / grid,
                         static_cast<double>(y) / grid);
}

void writeFaces(std::FILE* file, int grid) {
    for (int y = 0; y < grid; ++y)
        for (int x = 0; x < grid; ++x) {
            const int a = y * (grid + 1) + x + 1, b = a + 1, c = b + grid + 1, d = c - 1;
            std::fprintf(file, "f %d/%d %d/%d %d/%d\nf %d/%d %d/%d %d/%d\n", a, a, b, b, c, c, a, a, c, c, d,
                         d);
        }
}

void writeMesh(const std::string& path, int grid) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"), std::fclose);
    if (!file) throw std::runtime_error("cannot write " + path);
    writeVertices(file.get(), grid);
    writeFaces(file.get(), grid);
}

template <class Work>
double medianSeconds(const Work& work) {
    std::vector<double> seconds;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(seconds);
    return seconds[2];
}

void readBytes(const std::string& path, std::size_t size) {
    const auto bytes = std::make_unique_for_overwrite<char[]>(size);
    std::ifstream(path, std::ios::binary).read(bytes.get(), static_cast<std::streamsize>(size));
}

void loadWithTinyobj(const std::string& path) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(path)) throw std::runtime_error(reader.Error());
}

}  // namespace

int main(int argc, char** argv) {
    const int grid = argc > 1 ? std::atoi(argv[1]) : 707;
    const std::string path = std::filesystem::temp_directory_path() / "raytracer-obj-speed.obj";
    writeMesh(path, grid);
    const std::size_t size = std::filesystem::file_size(path);
    const double read = medianSeconds([&] { readBytes(path, size); });
    const double ours = medianSeconds([&] { raytracer::loadObj(path); });
    const double tinyobj = medianSeconds([&] { loadWithTinyobj(path); });
    std::printf("%d triangles, %.1f MB, %u threads, median of 5\n", 2 * grid * grid,
                static_cast<double>(size) / 1e6, std::thread::hardware_concurrency());
    const auto report = [&](const char* name, double seconds) {
        std::printf("%-14s %7.1f ms %7.0f MB/s %6.2f x ours\n", name, seconds * 1e3,
                    static_cast<double>(size) / 1e6 / seconds, seconds / ours);
    };
    report("read the bytes", read);
    report("loadObj", ours);
    report("tinyobjloader", tinyobj);
    std::filesystem::remove(path);
}
