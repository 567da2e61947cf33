// The instruction sets of vector registers that this program has code for, and which of them is used.
//
// CMakeLists.txt lists them and compiles what is written with Lanes (lanes.h) once for each. Pictures are the
// same with any of them.
#pragma once

#include <string_view>
#include <vector>

namespace raytracer {

// Each is better than the one before. `scalar` is plain C++.
enum class InstructionSet { RAYTRACER_INSTRUCTION_SETS };

// Those that this processor has, the best last.
std::vector<InstructionSet> supportedInstructionSets();

// As CMakeLists.txt has it: "avx2".
std::string_view nameOf(InstructionSet set);

// The one of this name among these; the best for an empty name. Throws Error for any other.
InstructionSet supportedInstructionSet(std::string_view name);

// The one that the environment variable RAYTRACER_SIMD names, or else the best. Throws Error where it names
// none that this processor has.
InstructionSet defaultInstructionSet();

}  // namespace raytracer
