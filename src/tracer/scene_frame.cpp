#include "raytracer/tracer/scene_frame.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {

namespace {

// An axis-aligned box that grows.
struct Extent {
    bool empty = true;
    ExtendedVec low{0}, high{0};

    void add(const ExtendedVec& center, const ExtendedVec& radius = ExtendedVec(0)) {
        low = empty ? center - radius : glm::min(low, center - radius);
        high = empty ? center + radius : glm::max(high, center + radius);
        empty = false;
    }

    ExtendedVec middle() const { return (low + high) / 2.0L; }

    long double size() const {
        const ExtendedVec size = high - low;
        return std::max({size.x, size.y, size.z});
    }
};

// The largest |coordinate| of a shape in object space.
double radiusObject(const ShapeDescription& shape) {
    if (shape.type != ShapeType::Mesh) return 1;
    const glm::dvec3 largest = glm::max(glm::abs(shape.mesh->low), glm::abs(shape.mesh->high));
    return std::max({largest.x, largest.y, largest.z});
}

void addShape(Extent& extent, const Affine& transform, long double size) {
    ExtendedVec radius;
    for (int row = 0; row < 3; ++row) {
        const ExtendedVec r = glm::abs(transform.linear[row]);
        radius[row] = (r.x + r.y + r.z) * size;
    }
    extent.add(transform.translation, radius);
}

Extent extentOfShapes(const SceneDescription& scene) {
    Extent extent;
    for (const ShapeDescription& shape : scene.shapes)
        if (shape.type != ShapeType::Plane)
            addShape(extent, worldFromObject(scene, shape), radiusObject(shape));
    return extent;
}

// The extent of the shapes and the camera; where that has no size, also of planes and lights.
Extent extentOf(const SceneDescription& scene, Extent extent) {
    extent.add(scene.camera.eye);
    if (extent.size() > 0) return extent;
    for (const ShapeDescription& shape : scene.shapes)
        extent.add(compose(scene.transforms[shape.transform]).translation);
    for (const LightDescription& light : scene.lights) extent.add(light.position);
    return extent;
}

}  // namespace

ExtendedVec SceneFrame::pointToFrame(const glm::dvec3& point) const {
    return scaled(ExtendedVec(point) - origin, -exponent);
}

Affine SceneFrame::toFrame(const Affine& worldFromObject) const {
    Affine result = worldFromObject;
    const long double unit = std::scalbn(1.0L, -exponent);
    result.linear *= unit;
    result.translation = (result.translation - origin) * unit;
    return result;
}

SceneFrame chooseFrame(const SceneDescription& scene) {
    SceneFrame frame;
    const Extent shapes = extentOfShapes(scene), extent = extentOf(scene, shapes);
    const long double size = extent.size();
    // Infinite: of a description that no file has, or where long double is no wider than double.
    if (!(size > 0) || std::isinf(size)) return frame;
    frame.exponent = std::ilogb(size) + 1;
    const long double unit = std::scalbn(1.0L, frame.exponent);
    for (int axis = 0; axis < 3; ++axis) {
        const long double middle = extent.middle()[axis];
        if (std::abs(middle) > 16 * unit) frame.origin[axis] = std::round(middle / unit) * unit;
    }
    if (shapes.size() > 0)
        for (int axis = 0; axis < 3; ++axis)
            frame.eyeDistance = std::max(
                frame.eyeDistance, std::abs(scene.camera.eye[axis] - shapes.middle()[axis]) / shapes.size());
    return frame;
}

}  // namespace raytracer
