// The traversal's inner loops (bvh_kernel.inc), once for each instruction set: what bvh.cpp chooses from.
#pragma once

#include "raytracer/bvh/bvh.h"

namespace raytracer {

#define RAYTRACER_BVH_KERNEL                                                         \
    double prepare(BvhTraversal& s, const BvhFrame& frame, const BvhRay& ray);       \
    double prepareBeam(BvhTraversal& s, const BvhFrame& frame, const BvhBeam& beam); \
    bool advance(BvhTraversal& s, float limit);

namespace scalar {
RAYTRACER_BVH_KERNEL
}
#if defined(__x86_64__)
namespace sse2 {
RAYTRACER_BVH_KERNEL
}
namespace avx2 {
RAYTRACER_BVH_KERNEL
}
#endif
#undef RAYTRACER_BVH_KERNEL

}  // namespace raytracer
