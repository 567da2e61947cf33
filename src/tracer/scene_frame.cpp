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
    long double low[3] = {}, high[3] = {};

    void add(const long double (&center)[3], const long double (&radius)[3]) {
        for (int axis = 0; axis < 3; ++axis) {
            const long double from = center[axis] - radius[axis], to = center[axis] + radius[axis];
            low[axis] = empty ? from : std::min(low[axis], from);
            high[axis] = empty ? to : std::max(high[axis], to);
        }
        empty = false;
    }

    void add(const glm::dvec3& point) { add({point.x, point.y, point.z}, {0, 0, 0}); }

    long double middle(int axis) const { return (low[axis] + high[axis]) / 2; }

    long double size() const {
        long double largest = 0;
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, high[axis] - low[axis]);
        return largest;
    }
};

// The largest |coordinate| of a shape in object space.
double radiusObject(const ShapeDescription& shape) {
    if (shape.type != ShapeType::Mesh) return 1;
    const glm::dvec3 largest = glm::max(glm::abs(shape.mesh->low), glm::abs(shape.mesh->high));
    return std::max({largest.x, largest.y, largest.z});
}

void addShape(Extent& extent, const Affine& transform, long double size) {
    long double radius[3];
    for (int row = 0; row < 3; ++row) {
        const auto& r = transform.linear[row];
        radius[row] = (std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2])) * size;
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

// Of all: the shapes, and the camera.
Extent extentOf(const SceneDescription& scene, Extent extent) {
    extent.add(scene.camera.eye);
    if (extent.size() > 0) return extent;
    for (const ShapeDescription& shape : scene.shapes)
        extent.add(compose(scene.transforms[shape.transform]).translation, {0, 0, 0});
    for (const LightDescription& light : scene.lights) extent.add(light.position);
    return extent;
}

}  // namespace

void SceneFrame::pointToFrame(const glm::dvec3& point, long double (&out)[3]) const {
    for (int axis = 0; axis < 3; ++axis) out[axis] = std::scalbn(point[axis] - origin[axis], -exponent);
}

Affine SceneFrame::toFrame(const Affine& worldFromObject) const {
    Affine result = worldFromObject;
    const long double unit = std::scalbn(1.0L, -exponent);
    for (int row = 0; row < 3; ++row) {
        for (long double& entry : result.linear[row]) entry *= unit;
        result.translation[row] = (result.translation[row] - origin[row]) * unit;
    }
    return result;
}

SceneFrame chooseFrame(const SceneDescription& scene) {
    SceneFrame frame;
    const Extent shapes = extentOfShapes(scene), extent = extentOf(scene, shapes);
    const long double size = extent.size();
    if (!(size > 0)) return frame;
    frame.exponent = std::ilogb(size) + 1;
    const long double unit = std::scalbn(1.0L, frame.exponent);
    for (int axis = 0; axis < 3; ++axis) {
        const long double middle = extent.middle(axis);
        if (std::abs(middle) > 16 * unit) frame.origin[axis] = std::round(middle / unit) * unit;
    }
    if (shapes.size() > 0)
        for (int axis = 0; axis < 3; ++axis)
            frame.eyeDistance = std::max(
                frame.eyeDistance, std::abs(scene.camera.eye[axis] - shapes.middle(axis)) / shapes.size());
    return frame;
}

}  // namespace raytracer
