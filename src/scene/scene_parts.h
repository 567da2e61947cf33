// Reads the parts of a scene that refer to no other part, each from its JSON object. All functions throw
// Error.
#pragma once

#include "known_keys.h"
#include "raytracer/json/json_view.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer {

CameraDescription readCamera(JsonView camera, KnownKeys& keys);

// Where a key is missing, the default in MaterialDescription or LightDescription stays.
MaterialDescription readMaterial(JsonView material, KnownKeys& keys);
LightDescription readLight(JsonView light, KnownKeys& keys);

// Throws also where the transform has no inverse.
TransformDescription readTransform(JsonView transform, KnownKeys& keys);

}  // namespace raytracer
