// Which instruction set is used: what RAYTRACER_SIMD names, the best where it is not set.
#include <catch2/catch.hpp>

#include "raytracer/numerics/instruction_set.h"
#include "raytracer/util/error.h"

using namespace raytracer;

TEST_CASE("instruction sets: plain C++ always, each by its name, no other") {
    const std::vector<InstructionSet> sets = supportedInstructionSets();
    REQUIRE(sets.front() == InstructionSet::scalar);
    CHECK(supportedInstructionSet("scalar") == InstructionSet::scalar);
    CHECK(supportedInstructionSet("") == sets.back());
    for (const InstructionSet set : sets) CHECK(supportedInstructionSet(nameOf(set)) == set);
    for (const char* name : {"SCALAR", "scal", "avx1024", ","})
        CHECK_THROWS_AS(supportedInstructionSet(name), Error);
#if defined(__x86_64__)
    CHECK(supportedInstructionSet("sse2") == InstructionSet::sse2);
#endif
}
