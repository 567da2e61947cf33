#include "raytracer/scene/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "obj_chunk.h"
#include "obj_line.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// Some milliseconds of parsing: much longer than a thread takes to start, and short enough for an even load.
constexpr std::size_t chunkBytes = std::size_t{1} << 20;

// Where the first line after `from` begins that does not continue another one (by a backslash).
std::size_t nextLineBegin(std::string_view text, std::size_t from) {
    std::size_t newline = text.find('\n', from);
    while (newline != text.npos && endsInBackslash(text.substr(0, newline)))
        newline = text.find('\n', newline + 1);
    return newline == text.npos ? text.size() : newline + 1;
}

// Chunks of about equal length; some may be empty.
std::vector<std::string_view> splitAtLines(std::string_view text, std::size_t chunkCount) {
    std::vector<std::string_view> chunks;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= chunkCount; ++i) {
        const std::size_t share = text.size() / chunkCount * i;
        const std::size_t end = i == chunkCount ? text.size() : nextLineBegin(text, std::max(begin, share));
        chunks.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return chunks;
}

// The text with a newline in place of each carriage return that is a line end on its own.
std::string withNewlines(std::string_view text) {
    std::string result(text);
    for (std::size_t i = result.find('\r'); i != result.npos; i = result.find('\r', i + 1))
        if (i + 1 == result.size() || result[i + 1] != '\n') result[i] = '\n';
    return result;
}

// Replaces each chunk's counts by the sums over all chunks above it. Returns the sums over the whole file.
ObjCounts sumAbove(std::vector<ObjCounts>& counts) {
    ObjCounts whole;
    for (ObjCounts& chunk : counts) whole += std::exchange(chunk, whole);
    return whole;
}

// A line with a NUL could pass for a line that is ignored.
[[noreturn]] void failAtNul(std::string_view text, const std::string& path) {
    const auto lines = std::ranges::count(text.substr(0, text.find('\0')), '\n');
    throw Error({.file = path, .line = static_cast<std::size_t>(lines) + 1},
                "a NUL byte, which no OBJ mesh has");
}

// Binary STL is a header of 80 bytes, the number of triangles, and 50 bytes for each.
bool isBinaryStl(std::string_view text) {
    constexpr std::size_t header = 80, begin = header + 4, triangle = 50;
    std::size_t count = 0;
    for (std::size_t i = begin; text.size() > begin && i > header; --i)
        count = count << 8 | static_cast<unsigned char>(text[i - 1]);
    return count > 0 && text.size() == begin + triangle * count;
}

void requireNoOtherType(std::string_view text, const std::string& path) {
    if (text.empty()) throw Error({path}, "it is empty");
    const std::string_view trimmed = text.substr(std::min(text.find_first_not_of(' '), text.size()));
    if (isBinaryStl(text) || (trimmed.starts_with("solid") && trimmed.find("facet") != trimmed.npos))
        throw Error({path}, "an STL mesh: save it as OBJ");
    if (text.starts_with("ply\n") || text.starts_with("ply\r"))
        throw Error({path}, "a PLY mesh: save it as OBJ");
}

// A vertex that no face uses must not count in the mesh's bounds: it becomes a copy of one that is used.
void hideUnused(MeshData& mesh) {
    std::vector<char> isUsed(mesh.positions.size());
    for (const std::uint32_t i : mesh.positionIndex) isUsed[i] = 1;
    for (std::size_t i = 0; i < isUsed.size(); ++i)
        if (!isUsed[i]) mesh.positions[i] = mesh.positions[mesh.positionIndex[0]];
}

void requireUsable(const ObjCounts& whole, const std::string& path) {
    if (whole.faces == 0 && whole.positions == 0)
        throw Error({path}, "no vertices and no faces, so not an OBJ mesh");
    if (whole.faces == 0)
        throw Error({path}, "vertices, but no faces: save it with faces (lines like f 1 2 3)");
    // noTexCoord is not a valid index.
    if (std::max(whole.positions, whole.texCoords) >= MeshData::noTexCoord)
        throw Error({path}, "too many vertices: indices have 32 bits");
    // The memory of a triangle and its part of the tree (bench/README.md), while the tree is built.
    constexpr double triangleBytes = 80;
    requireMemory(path, std::to_string(whole.triangles) + " triangles",
                  triangleBytes * static_cast<double>(whole.triangles) +
                      24.0 * static_cast<double>(whole.positions) +
                      16.0 * static_cast<double>(whole.texCoords));
}

}  // namespace

void requireTriangles(std::size_t count, const std::string& path) {
    if (count > MeshData::mostTriangles)
        throw Error({path}, "more than 200,000,000 triangles: use several meshes");
}

void MeshData::findBounds() {
    low = glm::dvec3(std::numeric_limits<double>::infinity());
    high = -low;
    for (const glm::dvec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
}

namespace {

double largestOf(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double leastCoordinate(const MeshData& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] != 0) least = std::min(least, std::abs(p[axis]));
    return least;
}

// The size of a triangle relative to `largest`: the root of the product of its two least half extents that
// are not zero. A triangle's area is made of such products. Infinite where it has fewer than two.
double sizeOfTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double largest) {
    const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    double least = std::numeric_limits<double>::infinity(), second = least;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = (high[axis] / 2 - low[axis] / 2) / largest;
        if (extent == 0) continue;
        second = std::min(second, std::max(least, extent));
        least = std::min(least, extent);
    }
    return std::sqrt(least) * std::sqrt(second);
}

double leastTriangle(const MeshData& mesh, double largest) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.positionIndex[i + k]]; };
        least = std::min(least, sizeOfTriangle(corner(0), corner(1), corner(2), largest));
    }
    return least;
}

// Relative to the largest coordinate. Where no coordinate is small, triangles need not be examined: two
// floats of 2^-28 or more are equal or at least 2^-52 apart. The square of that is far from the ends of any
// precision.
double finestOf(const MeshData& mesh, double largest, double least) {
    double finest = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = (mesh.high[axis] / 2 - mesh.low[axis] / 2) / largest;
        if (extent > 0) finest = std::min(finest, extent);
    }
    return least < 0x1p-28 * largest ? std::min(finest, leastTriangle(mesh, largest)) : finest;
}

}  // namespace

void MeshData::chooseUnit() {
    const double largest = std::max(largestOf(low), largestOf(high)), least = leastCoordinate(*this);
    if (largest == 0) return;
    finest = finestOf(*this, largest, least);
    constexpr int leastExponent = std::numeric_limits<double>::min_exponent - 1;
    const int more = std::min(std::ilogb(largest), std::max(0, std::ilogb(least) - leastExponent));
    if (more < std::ilogb(largest)) finest = least / largest;  // there is no such unit in double
    // In two steps: 2^-more itself may be beyond double.
    const double first = std::ldexp(1.0, -more / 2), second = std::ldexp(1.0, more / 2 - more);
    const auto scale = [&](glm::dvec3& p) { p = p * first * second; };
    std::ranges::for_each(positions, scale);
    scale(low);
    scale(high);
    exponent = more;
}

MeshData parseObjInChunks(std::string_view text, std::size_t chunkCount, const std::string& path,
                          int threads) {
    const std::vector<std::string_view> chunks = splitAtLines(text, chunkCount);
    std::vector<ObjCounts> above(chunkCount);
    const auto jobs = static_cast<std::uint32_t>(chunkCount);
    parallelFor(jobs, threads, [&](std::uint32_t i) { above[i] = countObjChunk(chunks[i]); });
    const ObjCounts whole = sumAbove(above);
    if (whole.hasReturns) return parseObjInChunks(withNewlines(text), chunkCount, path, threads);
    if (whole.hasNul) failAtNul(text, path);
    requireUsable(whole, path);

    requireTriangles(whole.triangles, path);

    MeshData mesh;
    mesh.positions.resize(whole.positions);
    mesh.texCoords.resize(whole.texCoords);
    mesh.positionIndex.resize(3 * whole.triangles);
    if (whole.texCoords > 0) mesh.texCoordIndex.resize(3 * whole.triangles);
    std::vector<ObjFaces> faces(chunkCount);
    parallelFor(jobs, threads, [&](std::uint32_t i) {
        faces[i] = parseObjChunk({chunks[i], path}, above[i], whole, mesh);
    });
    if (std::ranges::none_of(faces, &ObjFaces::textured)) {
        mesh.texCoords = {};
        mesh.texCoordIndex = {};
    }
    parallelFor(jobs, threads, [&](std::uint32_t i) { cutConcavePolygons(faces[i], mesh); });
    hideUnused(mesh);
    mesh.findBounds();
    return mesh;
}

MeshData parseObj(std::string_view text, const std::string& path, int threads) {
    if (const auto wide = wideEncoding(text); !wide.empty())
        throw Error({path}, "expected UTF-8, found " + wide);
    requireNoOtherType(text, path);
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    return parseObjInChunks(text, text.size() / chunkBytes + 1, path, threads);
}

MeshData loadObj(const std::string& path, int threads) {
    return parseObj(FileBytes(path, FileKind::Regular).text(), path, threads);
}

}  // namespace raytracer
