#include "obj_chunk.h"

#include <string>
#include <utility>

#include "obj_line.h"

namespace raytracer {
namespace {

// The index, from 0, for an index of a face as written: above 0 it counts from 1 in the whole file, below 0
// backwards from the face.
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

    ObjTriangles parse(ObjChunk chunk) {
        for (std::size_t physicalLines = 0; !chunk.text.empty(); above_.lines += physicalLines) {
            ObjLine line(takeObjLine(chunk.text, physicalLines), chunk.path, above_.lines + 1);
            parseLine(line);
        }
        return std::move(triangles_);
    }

  private:
    struct Corner {
        std::uint32_t position = 0, texCoord = MeshData::noTexCoord;
        bool hasNormal = false;

        bool hasSameForm(const Corner& other) const {
            return (texCoord == MeshData::noTexCoord) == (other.texCoord == MeshData::noTexCoord) &&
                   hasNormal == other.hasNormal;
        }
    };

    void parseLine(ObjLine& line) {
        switch (line.keyword()) {
            case ObjKeyword::position: return parsePosition(line);
            case ObjKeyword::texCoord: return parseTexCoord(line);
            case ObjKeyword::face: return parseFace(line);
            case ObjKeyword::normal:
                ++above_.normals;
                return;  // not read: a triangle's normal is that of its plane
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
        const Corner first = takeCorner(line, 0);
        Corner previous = takeCorner(line, 1);
        bool sameForm = previous.hasSameForm(first);
        for (std::size_t count = 2; count == 2 || !line.atEnd(); ++count) {
            const Corner corner = takeCorner(line, count);
            sameForm &= corner.hasSameForm(first);
            addTriangle(first, previous, corner);
            previous = corner;
        }
        if (!sameForm) line.fail("the corners of a face are all v, all v/vt, all v//vn or all v/vt/vn");
    }

    Corner takeCorner(ObjLine& line, std::size_t count) const {
        if (line.atEnd()) line.fail("a face has at least 3 corners, found " + std::to_string(count));
        const ObjLine::Corner written = line.corner();
        Corner corner{.position =
                          resolve(line, written.position, above_.positions, whole_.positions, "vertex")};
        if (written.texCoord != 0)
            corner.texCoord =
                resolve(line, written.texCoord, above_.texCoords, whole_.texCoords, "texture coordinate");
        corner.hasNormal = written.normal != 0;
        if (corner.hasNormal) resolve(line, written.normal, above_.normals, whole_.normals, "normal");
        return corner;
    }

    void addTriangle(const Corner& a, const Corner& b, const Corner& c) {
        auto& [positionIndex, texCoordIndex] = triangles_;
        if (a.texCoord != MeshData::noTexCoord) {
            texCoordIndex.resize(positionIndex.size(),
                                 MeshData::noTexCoord);  // fills in the triangles before, which had none
            texCoordIndex.insert(texCoordIndex.end(), {a.texCoord, b.texCoord, c.texCoord});
        }
        positionIndex.insert(positionIndex.end(), {a.position, b.position, c.position});
    }

    ObjCounts above_;  // of what stands above the current line
    const ObjCounts whole_;
    MeshData& mesh_;
    ObjTriangles triangles_;
};

}  // namespace

ObjCounts& ObjCounts::operator+=(const ObjCounts& other) {
    lines += other.lines;
    positions += other.positions;
    texCoords += other.texCoords;
    normals += other.normals;
    faces += other.faces;
    return *this;
}

ObjCounts countObjChunk(std::string_view chunk) {
    ObjCounts counts;
    for (std::size_t physicalLines = 0; !chunk.empty(); counts.lines += physicalLines) {
        switch (ObjLine(takeObjLine(chunk, physicalLines)).keyword()) {
            case ObjKeyword::position: ++counts.positions; break;
            case ObjKeyword::texCoord: ++counts.texCoords; break;
            case ObjKeyword::normal: ++counts.normals; break;
            case ObjKeyword::face: ++counts.faces; break;
            case ObjKeyword::other: break;
        }
    }
    return counts;
}

ObjTriangles parseObjChunk(const ObjChunk& chunk, const ObjCounts& above, const ObjCounts& whole,
                           MeshData& mesh) {
    return ChunkParser(above, whole, mesh).parse(chunk);
}

}  // namespace raytracer
