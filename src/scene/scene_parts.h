// The parts of a scene that stand for themselves, each from its JSON object. Throws Error.
#pragma once

#include "known_keys.h"
#include "raytracer/json/json_view.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer {

CameraDescription readCamera(JsonView camera, KnownKeys& keys);

// A key that is left out leaves the default that MaterialDescription or LightDescription has.
MaterialDescription readMaterial(JsonView material, KnownKeys& keys);
LightDescription readLight(JsonView light, KnownKeys& keys);

// One that can be inverted.
TransformDescription readTransform(JsonView transform, KnownKeys& keys);

}  // namespace raytracer
