// The traversal of a packet alone, without shading, for embree_compare.
#pragma once

#include <span>

#include "raytracer/geometry/shape_tree.h"

namespace raytracer {

// The nearest hits of up to eight rays, which leave the same side of the same shape, if any; with an end, any
// hit before it. (Where two hits coincide, either.)
void meetPacket(const ShapeTree& tree, std::span<const Ray> rays, const Vec3* end, std::span<Hit> hits);

}  // namespace raytracer
