// The long run of the re-intersection test: reintersection [RAYS] [SIZE_DECADES] [STRETCH_DECADES]
// [ORIGIN_DECADES] [SEED] [SHAPE].
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "../test/support/core_reintersection.h"

using namespace raytracer;
using namespace raytracer::test;

int main(int argc, char** argv) {
    const auto argument = [&](int i, double value) { return argc > i ? std::atof(argv[i]) : value; };
    const auto rays = static_cast<std::uint64_t>(argument(1, 1e8));
    const Extents extents{argument(2, 30), argument(3, 4), argument(4, 30)};
    const auto seed = static_cast<std::uint64_t>(argument(5, 1));
    std::uint64_t failures = 0;
    std::printf("%-9s %12s %10s %10s %10s %10s %10s %10s\n", "shape", "rays", "points", "missed", "met again",
                "never out", "stuck", "odd");
    for (const Kind kind : allKinds) {
        if (argc > 6 && std::strcmp(argv[6], nameOf(kind)) != 0) continue;
        const Reintersections r =
            Reintersection(kind, kind == Kind::Mesh ? roundMesh() : nullptr, seed, extents).run(rays);
        std::printf("%-9s %12ju %10ju %10ju %10ju %10ju %10ju %10ju\n", nameOf(kind), r.rays, r.points,
                    r.missed, r.metAgain, r.neverOut, r.stuck, r.oddCrossings);
        failures += r.metAgain + r.neverOut + r.stuck + r.oddCrossings;
    }
    return failures == 0 ? 0 : 1;
}
