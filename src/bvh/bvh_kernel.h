// The traversal's inner loops, which bvh_kernel.cpp defines for each instruction set.
#pragma once

#include "raytracer/bvh/bvh.h"

namespace raytracer {

struct BvhKernel {
    // Prepare for a ray or a beam. Return the factor from its t to the traversal's, or 0 where the tree
    // cannot be used.
    double (*prepareRay)(BvhTraversal& s, const BvhFrame& frame, const BvhRay& ray);
    double (*prepareBeam)(BvhTraversal& s, const BvhFrame& frame, const BvhBeam& beam);
    // BvhCursor::next, with the limit in the traversal's units.
    bool (*advance)(BvhTraversal& s, float limit);
};

template <InstructionSet set>
const BvhKernel& bvhKernel();

}  // namespace raytracer
