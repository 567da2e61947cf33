// Which instruction set is used: what RAYTRACER_SIMD names, or else the best.
#include <catch2/catch.hpp>

#include "raytracer/numerics/instruction_set.h"

using namespace raytracer;

TEST_CASE("instruction sets: plain C++ always, each by its name, otherwise the best") {
    const std::vector<InstructionSet> sets = supportedInstructionSets();
    REQUIRE(sets.front() == InstructionSet::scalar);
    CHECK(supportedInstructionSet("scalar") == InstructionSet::scalar);
    for (const char* name : {"", "SCALAR", "scal", "avx1024", ","})
        CHECK(supportedInstructionSet(name) == sets.back());
#if defined(__x86_64__)
    CHECK(supportedInstructionSet("sse2") == InstructionSet::sse2);
#endif
}
