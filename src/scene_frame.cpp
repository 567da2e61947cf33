#include "raytracer/scene_frame.h"

#include <algorithm>
#include <cmath>

#include "raytracer/mesh_file.h"

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

    long double size() const {
        long double largest = 0;
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, high[axis] - low[axis]);
        return largest;
    }
};

// The largest |coordinate| of the shape in object space.
long double objectRadius(const ShapeDescription& shape) {
    if (shape.type != ShapeDescription::Type::Mesh) return 1;
    double largest = 0;
    for (const glm::dvec3& p : shape.mesh->positions)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
}

void addShape(Extent& extent, const Affine& transform, long double radiusObject) {
    long double radius[3];
    for (int row = 0; row < 3; ++row) {
        const auto& r = transform.linear[row];
        radius[row] = (std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2])) * radiusObject;
    }
    extent.add(transform.translation, radius);
}

Extent extentOf(const SceneDescription& scene, const std::vector<Affine>& transforms) {
    Extent extent;
    extent.add(scene.camera.eye);
    for (const ShapeDescription& shape : scene.shapes)
        if (shape.type != ShapeDescription::Type::Plane)
            addShape(extent, transforms[shape.transform], objectRadius(shape));
    if (extent.size() > 0) return extent;
    for (const ShapeDescription& shape : scene.shapes) extent.add(transforms[shape.transform].translation, {0, 0, 0});
    for (const LightDescription& light : scene.lights) extent.add(light.position);
    return extent;
}

}  // namespace

void SceneFrame::pointToFrame(const glm::dvec3& point, long double (&out)[3]) const {
    for (int axis = 0; axis < 3; ++axis) out[axis] = std::scalbn(point[axis] - origin[axis], -exponent);
}

Affine SceneFrame::toFrame(const Affine& worldFromObject) const {
    Affine result = worldFromObject;
    for (int row = 0; row < 3; ++row) {
        for (long double& entry : result.linear[row]) entry = std::scalbn(entry, -exponent);
        result.translation[row] = std::scalbn(result.translation[row] - origin[row], -exponent);
    }
    return result;
}

SceneFrame chooseFrame(const SceneDescription& scene, const std::vector<Affine>& transforms) {
    SceneFrame frame;
    const Extent extent = extentOf(scene, transforms);
    const long double size = extent.size();
    if (!(size > 0)) return frame;
    frame.exponent = std::ilogb(size) + 1;
    const long double unit = std::scalbn(1.0L, frame.exponent);
    for (int axis = 0; axis < 3; ++axis) {
        const long double middle = (extent.low[axis] + extent.high[axis]) / 2;
        if (std::abs(middle) > 16 * unit) frame.origin[axis] = std::round(middle / unit) * unit;
    }
    return frame;
}

}  // namespace raytracer
