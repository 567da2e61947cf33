// What the user asks of the building of trees.
#pragma once

namespace raytracer {

// How the shapes that a ray meets are found: by trees (bvh.h), or, as the check, by trying all. The picture
// is the same.
enum class Accelerator { None, Bvh };

struct BuildOptions {
    Accelerator accelerator = Accelerator::Bvh;
    int threads = 0;  // 0: one for each processor
};

}  // namespace raytracer
