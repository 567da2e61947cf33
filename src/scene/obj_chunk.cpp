#include "obj_chunk.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "obj_line.h"
#include "triangulate.h"

namespace raytracer {
namespace {

// The index, from 0, for an index as a face has it: above 0, it counts from 1 in the whole file; below 0, it
// counts backwards from the face.
std::uint32_t resolve(const ObjLine& line, std::int64_t written, std::size_t above, std::size_t whole,
                      const char* what) {
    const auto count = static_cast<std::int64_t>(written > 0 ? whole : above);
    if (written > count || written < -count)
        line.fail(std::string("there is no ") + what + ' ' + std::to_string(written) + ": " +
                  (written > 0 ? "the file has " : "above this line stand ") + std::to_string(count));
    return static_cast<std::uint32_t>(written > 0 ? written - 1 : count + written);
}

class ChunkParser {
  public:
    ChunkParser(const ObjCounts& above, const ObjCounts& whole, MeshData& mesh)
        : above_(above), whole_(whole), mesh_(mesh) {}

    ObjFaces parse(ObjChunk chunk) {
        for (std::size_t physicalLines = 0; !chunk.text.empty(); above_.lines += physicalLines) {
            ObjLine line(takeObjLine(chunk.text, physicalLines), chunk.path, above_.lines + 1);
            parseLine(line);
        }
        return std::move(faces_);
    }

  private:
    struct Corner {
        std::uint32_t position = 0, texCoord = MeshData::noTexCoord;
        bool hasTexCoord() const { return texCoord != MeshData::noTexCoord; }
    };

    void parseLine(ObjLine& line) {
        switch (line.keyword()) {
            case ObjKeyword::position: return parsePosition(line);
            case ObjKeyword::texCoord: return parseTexCoord(line);
            case ObjKeyword::face: return parseFace(line);
            case ObjKeyword::other: return;
        }
    }

    // x y z; then, ignored, a weight w (for curves only), a colour r g b, or both.
    void parsePosition(ObjLine& line) {
        const double x = line.number(), y = line.number(), z = line.number();
        mesh_.positions[above_.positions++] = {x, y, z};
        const int count = 3 + skipNumbers(line);
        if (count == 5 || count > 7)
            line.fail("a vertex has 3, 4, 6 or 7 numbers, found " + std::to_string(count));
    }

    // u, u v or u v w.
    void parseTexCoord(ObjLine& line) {
        const double u = line.number();
        const double v = line.atEnd() ? 0 : line.number();
        mesh_.texCoords[above_.texCoords++] = {u, v};
        if (skipNumbers(line) > 1) line.fail("a texture coordinate has at most 3 numbers");
    }

    static int skipNumbers(ObjLine& line) {
        int count = 0;
        for (; !line.atEnd(); ++count) line.number();
        return count;
    }

    void parseFace(ObjLine& line) {
        const auto firstTriangle = static_cast<std::uint32_t>(above_.triangles);
        const Corner first = takeCorner(line, 0);
        Corner previous = takeCorner(line, 1);
        bool sameForm = previous.hasTexCoord() == first.hasTexCoord();
        std::uint32_t count = 2;
        for (; count == 2 || !line.atEnd(); ++count) {
            const Corner corner = takeCorner(line, count);
            sameForm &= corner.hasTexCoord() == first.hasTexCoord();
            addTriangle(first, previous, corner);
            previous = corner;
        }
        if (!sameForm) line.fail("either all corners of a face have a texture coordinate or none");
        if (count > 3) faces_.polygons.push_back({firstTriangle, count});
        faces_.textured |= first.hasTexCoord();
    }

    Corner takeCorner(ObjLine& line, std::size_t count) const {
        if (line.atEnd()) line.fail("a face has at least 3 corners, found " + std::to_string(count));
        const ObjLine::Corner written = line.corner();
        Corner corner{.position =
                          resolve(line, written.position, above_.positions, whole_.positions, "vertex")};
        if (written.texCoord != 0)
            corner.texCoord =
                resolve(line, written.texCoord, above_.texCoords, whole_.texCoords, "texture coordinate");
        return corner;
    }

    void addTriangle(const Corner& a, const Corner& b, const Corner& c) {
        const std::size_t place = 3 * above_.triangles++;
        const Corner corner[] = {a, b, c};
        for (std::size_t i = 0; i < 3; ++i) mesh_.positionIndex[place + i] = corner[i].position;
        if (whole_.texCoords == 0) return;
        for (std::size_t i = 0; i < 3; ++i) mesh_.texCoordIndex[place + i] = corner[i].texCoord;
    }

    ObjCounts above_;  // of what stands above the current line
    const ObjCounts whole_;
    MeshData& mesh_;
    ObjFaces faces_;
};

// Whether a line ends in a carriage return alone, as on Macs before 2001.
bool hasReturns(std::string_view text) {
    std::size_t at = text.find('\r');
    while (at != text.npos && text.substr(at + 1).starts_with('\n')) at = text.find('\r', at + 1);
    return at != text.npos;
}

// The place in a polygon's fan where a corner first appears.
std::size_t placeInFan(std::size_t corner) { return corner < 2 ? corner : 3 * (corner - 2) + 2; }

// Replaces the triangles of a polygon's fan, whose corners are in `index`, by other triangles of the same
// corners.
void replaceFan(std::span<std::uint32_t> index, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const std::vector<std::uint32_t> fan(index.begin(), index.end());
    std::uint32_t* to = index.data();
    for (const auto& triangle : triangles)
        for (const std::uint32_t corner : triangle) *to++ = fan[placeInFan(corner)];
}

}  // namespace

ObjCounts& ObjCounts::operator+=(const ObjCounts& other) {
    lines += other.lines;
    positions += other.positions;
    texCoords += other.texCoords;
    faces += other.faces;
    triangles += other.triangles;
    hasReturns |= other.hasReturns;
    hasNul |= other.hasNul;
    return *this;
}

ObjCounts countObjChunk(std::string_view chunk) {
    ObjCounts counts;
    counts.hasReturns = hasReturns(chunk);
    counts.hasNul = chunk.find('\0') != chunk.npos;
    if (counts.hasReturns || counts.hasNul) return counts;
    for (std::size_t physicalLines = 0; !chunk.empty(); counts.lines += physicalLines) {
        ObjLine line(takeObjLine(chunk, physicalLines));
        switch (line.keyword()) {
            case ObjKeyword::position: ++counts.positions; break;
            case ObjKeyword::texCoord: ++counts.texCoords; break;
            case ObjKeyword::face:
                ++counts.faces;
                counts.triangles += std::max<std::size_t>(line.words(), 2) - 2;
                break;
            case ObjKeyword::other: break;
        }
    }
    return counts;
}

ObjFaces parseObjChunk(const ObjChunk& chunk, const ObjCounts& above, const ObjCounts& whole,
                       MeshData& mesh) {
    return ChunkParser(above, whole, mesh).parse(chunk);
}

void cutConcavePolygons(const ObjFaces& faces, MeshData& mesh) {
    std::vector<glm::dvec3> corners;
    for (const auto& [firstTriangle, count] : faces.polygons) {
        const std::size_t begin = std::size_t{3} * firstTriangle, size = std::size_t{3} * (count - 2);
        const std::span position = std::span(mesh.positionIndex).subspan(begin, size);
        corners.clear();
        for (std::uint32_t i = 0; i < count; ++i) corners.push_back(mesh.positions[position[placeInFan(i)]]);
        const auto triangles = triangulateConcave(corners);
        if (triangles.empty()) continue;
        replaceFan(position, triangles);
        if (!mesh.texCoordIndex.empty())
            replaceFan(std::span(mesh.texCoordIndex).subspan(begin, size), triangles);
    }
}

}  // namespace raytracer
