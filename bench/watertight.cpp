// The long run of the watertight test: watertight [RAYS] [SEED].
#include <cstdio>
#include <cstdlib>

#include "../test/support/core_watertight.h"

using namespace raytracer;
using namespace raytracer::test;

int main(int argc, char** argv) {
    const auto rays = static_cast<std::uint64_t>(argc > 1 ? std::atof(argv[1]) : 1e7);
    const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atof(argv[2]) : 1);
    const Crossings result = WatertightTest(glm::dvec3(148376, 1234, -223423), seed).run(rays);
    std::printf("rays %ju, through %ju, twice %ju, odd %ju\n", result.rays, result.through, result.twice,
                result.odd);
    return result.through + result.twice + result.odd == 0 ? 0 : 1;
}
