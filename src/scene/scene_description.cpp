#include "raytracer/scene/scene_description.h"

namespace raytracer {

const char* typeName(ShapeDescription::Type type) {
    constexpr const char* names[] = {"sphere", "plane", "cylinder", "cone", "cube", "mesh"};
    return names[static_cast<int>(type)];
}

}  // namespace raytracer
