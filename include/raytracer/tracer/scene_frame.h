// The unit and origin in which the core computes: chosen from the scene, so that a picture depends on
// neither.
//
// A scene of 1e-12 units, or one that lies 1e8 of its own sizes from the origin, is brought to the order of 1
// before its numbers become Real. The unit is a power of two, so a scene multiplied by 2^k becomes the very
// same scene. The origin is the file's if the scene lies near it. Otherwise it is a point of a grid as coarse
// as the scene is large, so that subtracting it from coordinates of that distance is exact.
#pragma once

#include "raytracer/scene/affine.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer {

struct SceneFrame {
    int exponent = 0;       // one unit here is 2^exponent of the file's
    ExtendedVec origin{0};  // in the file's units
    // The distance of the camera from the middle of the shapes, in units of their size. Planes do not count;
    // 0 where there are only planes.
    long double eyeDistance = 0;

    // A position of the file, in this frame.
    ExtendedVec pointToFrame(const glm::dvec3& point) const;

    // World from object, with world in this frame.
    Affine toFrame(const Affine& worldFromObject) const;
};

// Chosen by the camera and every shape of finite size; where these together have no extent, by planes and
// lights too.
SceneFrame chooseFrame(const SceneDescription& scene);

}  // namespace raytracer
