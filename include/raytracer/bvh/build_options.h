// How trees are built, and the instruction set for trees and packets of rays.
#pragma once

#include "raytracer/numerics/instruction_set.h"

namespace raytracer {

// How the shapes that a ray hits are found: by trees (bvh.h), or, as a check, by testing all of them. The
// picture is the same.
enum class Accelerator { None, Bvh };

struct BuildOptions {
    Accelerator accelerator = Accelerator::Bvh;
    int threads = 0;  // 0: one for each processor
    InstructionSet instructionSet = defaultInstructionSet();
};

}  // namespace raytracer
