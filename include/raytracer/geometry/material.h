// Materials and lights: the numbers of Phong's model, in Real.
#pragma once

#include "raytracer/numerics/types.h"
#include "raytracer/pictures/texture.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Material {
    Color color_ambient{0}, color_diffuse{1}, color_specular{1};
    Real shininess = 10;
    bool reflective = false;
    Color color_reflect{1};
    bool refractive = false;
    Color color_refract{1};
    Real index_of_refraction = 1;
    const Texture* diffuse_texture = nullptr;  // null: no texture
};

struct Light {
    Vec3 position{0};  // world
    Color color{1}, color_ambient{1};
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
