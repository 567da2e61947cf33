// How trees are built, and by which instructions they and packets of rays are worked on.
#pragma once

#include "raytracer/numerics/instruction_set.h"

namespace raytracer {

// How the shapes that a ray meets are found: by trees (bvh.h), or, as the check, by trying all. The picture
// is the same.
enum class Accelerator { None, Bvh };

struct BuildOptions {
    Accelerator accelerator = Accelerator::Bvh;
    int threads = 0;  // 0: one for each processor
    InstructionSet instructionSet = defaultInstructionSet();
};

}  // namespace raytracer
